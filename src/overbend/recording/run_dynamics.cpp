#include "recording/run_dynamics.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "base/shown_unit.h"
#include "dynamics/setup/start_leap.h"
#include "recording/dynamic_recorder.h"
#include "recording/moored_recorder.h"
#include "recording/reach_row.h"

namespace overbend {
namespace {

constexpr double kSmallLeap = 1e-3;     ///< Of the stern shoe at t = 0, not worth a word [m].
constexpr double kWorthKeeping = 10.0;  ///< What a run took that is not done again [s].
constexpr double kSmallSpeed = 0.01;    ///< Likewise [m/s].

DynamicRunReport finished(DynamicRunReport report, const DynamicOptions& options, double simulated) {
  report.real_time_ratio = report.wall_time > 0.0 ? simulated / report.wall_time : 0.0;
  report.integrator = "generalized-alpha, spectral radius " +
                      std::to_string(options.step.spectral_radius).substr(0, 4) +
                      (options.fixed_step ? ", fixed step" : ", adaptive step");
  return report;
}

/// What results of all runs have in common; `Run`: a Simulation or a SystemRun.
template <class Run>
DynamicResults begun_results(const Model& model, const Run& run) {
  const DynamicOptions& options = run.options();
  DynamicResults r;
  r.duration = run.time();
  r.build_up = options.build_up;
  r.output_step = options.output_step;
  r.seed = options.seed;
  r.energy = run.energy();
  r.run = finished(run.report(), options, r.duration + std::ceil(r.build_up / r.output_step) * r.output_step);
  if (const double leap = leap_at_start(model); leap > kSmallLeap) {
    r.findings.push_back(
        Finding{FindingCode::start_without_build_up,
                fmt::format("without build-up the stern shoe leaps by {} from where statics have it: what rings after "
                            "t = 0 comes from that; give some wave periods (analysis.dynamic.build_up)",
                            shown_digits(leap, "m", 3))}
            .on("vessel")
            .with("distance", leap, "m"));
  }
  if (const double speed = speed_at_start(model); speed > kSmallSpeed) {
    r.findings.push_back(
        Finding{FindingCode::start_without_build_up,
                fmt::format("without build-up the stern shoe has {} at once: impacts and tensions after t = 0 come "
                            "from that; give some wave periods (analysis.dynamic.build_up)",
                            shown_digits(speed, "m/s", 3))}
            .on("vessel")
            .with("speed", speed, "m/s"));
  }
  return r;
}

DynamicResults results_of(const Model& model, const Simulation& simulation, const DynamicRecorder& recorder) {
  DynamicResults r = begun_results(model, simulation);
  recorder.fill(r);
  r.assumptions = merge(std::move(r.assumptions), simulation.controllers().assumptions());
  append(r.findings, simulation.controllers().findings(simulation.system()));
  return r;
}

DynamicResults results_of(const Model& model, const SystemRun& run, const MooredRecorder& recorder) {
  DynamicResults r = begun_results(model, run);
  recorder.fill(r);
  return r;
}

/// To the end, unless `control` stops it. `so_far` gives the results at the present, `tension` that to tell [N].
template <class Run>
DynamicOutcome follow(Run& run, DynamicSink& sink, const std::function<DynamicControl(const DynamicProgress&)>& control,
                      const std::function<DynamicResults()>& so_far, const std::function<double()>& tension) {
  while (!run.finished()) {
    if (!reach_row(run)) return {std::nullopt, std::nullopt, true};
    if (run.failure()) return {std::nullopt, run.failure(), false};
    const DynamicControl wanted =
        control({run.time(), run.end(), run.report().steps, tension(), [&so_far] { return so_far(); }});
    if (wanted != DynamicControl::go_on) sink.checkpoint(run.checkpoint());
    if (wanted == DynamicControl::stop && !run.finished()) {
      if (run.time() <= 0.0) return {std::nullopt, std::nullopt, true};
      return {so_far(), std::nullopt, true};
    }
  }
  if (run.report().wall_time > kWorthKeeping) sink.checkpoint(run.checkpoint());  // results are still to be written
  return {so_far(), std::nullopt, false};
}

/// A hull on its mooring lines, without a pipe.
DynamicOutcome run_moored(const Model& model, const StaticSolution& start, const DynamicOptions& options,
                          DynamicSink& sink, const DynamicCheckpoint* from,
                          const std::function<DynamicControl(const DynamicProgress&)>& control) {
  MooredSimulation moored(model, start, options);
  if (moored.failure()) return {std::nullopt, moored.failure(), false};
  SystemRun& run = moored.run();
  MooredRecorder recorder(model, moored, sink);
  run.observe(recorder);
  if (from != nullptr) {
    run.restore(*from);
  } else {
    recorder.row(run);
  }
  return follow(
      run, sink, control, [&] { return results_of(model, run, recorder); }, [&] { return recorder.largest_tension(); });
}

}  // namespace

DynamicOutcome run_dynamics(const Model& model, const StaticSolution& start, const StaticResults& statics,
                            const DynamicOptions& options, DynamicSink& sink, const DynamicCheckpoint* from,
                            const std::function<DynamicControl(const DynamicProgress&)>& control) {
  if (!model.description.has_pipe) return run_moored(model, start, options, sink, from, control);
  Simulation simulation(model, start, statics.top_tension, options);
  if (simulation.failure()) return {std::nullopt, simulation.failure(), false};
  DynamicRecorder recorder(model, statics, simulation, sink);
  simulation.observe(recorder);  // also before a restore: the recorder keeps the static state
  if (from != nullptr) {
    simulation.restore(*from);
  } else {
    recorder.row(simulation.now(), simulation.row_number());
  }
  return follow(
      simulation, sink, control, [&] { return results_of(model, simulation, recorder); },
      [&] { return recorder.top_tension(); });
}

}  // namespace overbend
