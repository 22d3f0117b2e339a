/// The time domain from the equilibrium through build-up and storm to results.
#pragma once

#include <functional>
#include <optional>

#include "dynamics/integrator/dynamics.h"
#include "results/dynamic_sink.h"

namespace overbend {

/// Told after every row of output.
struct DynamicProgress {
  double time = 0.0, end = 0.0;  ///< [s]
  std::int64_t steps = 0;
  double top_tension = 0.0;  ///< See Recorder::top_tension [N].
  /// Results up to now, without code checks; after t = 0 only, and only during the call.
  std::function<DynamicResults()> so_far{};
};

enum class DynamicControl { go_on, checkpoint, stop };  ///< `stop` leaves a checkpoint.

struct DynamicOutcome {
  std::optional<DynamicResults> results;  ///< Of a run that was stopped: of what lies behind t = 0, if anything.
  std::optional<StaticFailure> failure;
  bool stopped = false;  ///< By the caller; the sink holds a checkpoint, that of an earlier row where rows take long.
};

/// Runs a simulation with a recorder, or goes on from a checkpoint; `statics` are the results of the equilibrium that
/// it starts from. The results of a run that was stopped and taken up again are those of one that was not, bit for bit.
/// Histories, spectra and extremes are left to who has the sink, code checks to checks/run_checks.h.
DynamicOutcome run_dynamics(const Model& model, const StaticSolution& start, const StaticResults& statics,
                            const DynamicOptions& options, DynamicSink& sink, const DynamicCheckpoint* from,
                            const std::function<DynamicControl(const DynamicProgress&)>& control);

}  // namespace overbend
