/// The time domain: from the equilibrium through build-up and storm to results.
#pragma once

#include <functional>
#include <optional>

#include "dynamics/impact_tracker.h"
#include "dynamics/time_step.h"
#include "results/dynamic_sink.h"
#include "statics/statics.h"

namespace overbend {

struct DynamicOptions {
  std::uint64_t seed = 1;
  double duration = 0.0, build_up = 60.0, output_step = 0.5;  ///< [s]
  std::optional<double> fixed_step;                           ///< [s]
  double max_step = 0.125;                                    ///< [s]
  double error_tolerance = 1e-3;  ///< Of a node's place in one step, where the step is free [m].
  double tail_reach = 1.0;        ///< Laid pipe behind the static line over what friction needs, see with_laid_tail.
  StepSettings step;
  ImpactSettings impacts;
};

/// The options of a model's `analysis.dynamic`.
DynamicOptions dynamic_options(const Model& model);

/// Told after every row of output.
struct DynamicProgress {
  double time = 0.0, end = 0.0;  ///< [s]
  std::int64_t steps = 0;
  double top_tension = 0.0;  ///< [N]
};

enum class DynamicControl { go_on, checkpoint, stop };  ///< `stop` leaves a checkpoint.

struct DynamicOutcome {
  std::optional<DynamicResults> results;  ///< Of a run that was stopped: of what lies behind t = 0, if anything.
  std::optional<StaticFailure> failure;
  bool stopped = false;  ///< By the caller; the sink holds a checkpoint.
};

/// Runs, or goes on from a checkpoint. The results of a run that was stopped and taken up again are those of one that
/// was not, bit for bit. Histories, spectra and extremes are left to who has the sink.
DynamicOutcome run_dynamics(const Model& model, const StaticSolution& start, const StaticResults& statics,
                            const DynamicOptions& options, DynamicSink& sink, const DynamicCheckpoint* from,
                            const std::function<DynamicControl(const DynamicProgress&)>& control);

/// Why a model cannot be run in time although its statics can; nothing when it can.
std::optional<StaticFailure> dynamic_obstacle(const Model& model);

}  // namespace overbend
