#include "recording/run_dynamics.h"

#include <cmath>
#include <string>

#include "recording/dynamic_recorder.h"

namespace overbend {
namespace {

DynamicRunReport report_of(const Simulation& simulation, double simulated) {
  DynamicRunReport report = simulation.report();
  const DynamicOptions& options = simulation.options();
  report.real_time_ratio = report.wall_time > 0.0 ? simulated / report.wall_time : 0.0;
  report.integrator = "generalized-alpha, spectral radius " +
                      std::to_string(options.step.spectral_radius).substr(0, 4) +
                      (options.fixed_step ? ", fixed step" : ", adaptive step");
  return report;
}

DynamicResults results_of(const Simulation& simulation, const DynamicRecorder& recorder) {
  const DynamicOptions& options = simulation.options();
  DynamicResults r;
  r.duration = simulation.time();
  r.build_up = options.build_up;
  r.output_step = options.output_step;
  r.seed = options.seed;
  r.energy = simulation.energy();
  r.run = report_of(simulation, r.duration + std::ceil(r.build_up / r.output_step) * r.output_step);
  recorder.fill(r);
  for (std::string& words : simulation.controllers().assumptions()) r.assumptions.push_back(std::move(words));
  for (std::string& words : simulation.controllers().warnings(simulation.system())) {
    r.warnings.push_back(std::move(words));
  }
  return r;
}

}  // namespace

DynamicOutcome run_dynamics(const Model& model, const StaticSolution& start, const StaticResults& statics,
                            const DynamicOptions& options, DynamicSink& sink, const DynamicCheckpoint* from,
                            const std::function<DynamicControl(const DynamicProgress&)>& control) {
  Simulation simulation(model, start, statics.top_tension, options);
  if (simulation.failure()) return {std::nullopt, simulation.failure(), false};
  DynamicRecorder recorder(model, statics, simulation, sink);
  simulation.observe(recorder);  // also before a restore: the recorder keeps the static state
  if (from != nullptr) {
    simulation.restore(*from);
  } else {
    recorder.row(simulation.now(), simulation.row_number());
  }
  const auto so_far = [&] { return results_of(simulation, recorder); };
  while (!simulation.finished()) {
    if (!simulation.advance(simulation.next_row())) return {std::nullopt, simulation.failure(), false};
    const DynamicControl wanted =
        control({simulation.time(), simulation.end(), simulation.report().steps, recorder.top_tension(), so_far});
    if (wanted != DynamicControl::go_on) sink.checkpoint(simulation.checkpoint());
    if (wanted == DynamicControl::stop && !simulation.finished()) {
      if (simulation.time() <= 0.0) return {std::nullopt, std::nullopt, true};
      return {results_of(simulation, recorder), std::nullopt, true};
    }
  }
  return {results_of(simulation, recorder), std::nullopt, false};
}

}  // namespace overbend
