/// Time-domain simulation from the equilibrium through the build-up to results.
#pragma once

#include <functional>
#include <optional>

#include "dynamics/integrator/dynamics.h"
#include "results/dynamic_sink.h"

namespace overbend {

/// Passed to the control callback after every output row.
struct DynamicProgress {
  double time = 0.0, end = 0.0;  ///< [s]
  std::int64_t steps = 0;
  double top_tension = 0.0;  ///< See Recorder::top_tension [N].
  /// Results so far, without code checks; callable after t = 0 only, and only during the callback.
  std::function<DynamicResults()> so_far{};
};

enum class DynamicControl { go_on, checkpoint, stop };  ///< `stop` leaves a checkpoint.

struct DynamicOutcome {
  std::optional<DynamicResults> results;  ///< Results; of a stopped run those from t = 0 on, if any.
  std::optional<StaticFailure> failure;
  bool stopped = false;  ///< Stopped by the caller; the sink holds a checkpoint, of an earlier row if rows take long.
};

/// Runs a simulation with a recorder, or resumes it from a checkpoint; `statics` are the results of its initial
/// equilibrium. The results of a stopped and resumed run equal those of an uninterrupted one bit for bit. Histories,
/// spectra and extremes are left to the owner of the sink, code checks to checks/run_checks.h.
DynamicOutcome run_dynamics(const Model& model, const StaticSolution& start, const StaticResults& statics,
                            const DynamicOptions& options, DynamicSink& sink, const DynamicCheckpoint* from,
                            const std::function<DynamicControl(const DynamicProgress&)>& control);

}  // namespace overbend
