#include "recording/run_dynamics.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "base/shown_unit.h"
#include "dynamics/setup/initial_jump.h"
#include "recording/advance_row.h"
#include "recording/recorder.h"

namespace overbend {
namespace {

constexpr double kMinReportedJump = 1e-3;      ///< Jump of the stern shoe at t = 0 below which it is not reported [m].
constexpr double kMinCheckpointedTime = 10.0;  ///< Wall time of a run from which a final checkpoint is kept [s].
constexpr double kMinReportedSpeed = 0.01;  ///< Initial speed of the stern shoe below which it is not reported [m/s].

DynamicRunReport finished(DynamicRunReport report, const DynamicOptions& options, double simulated) {
  report.real_time_ratio = report.wall_time > 0.0 ? simulated / report.wall_time : 0.0;
  report.integrator = "generalized-alpha, spectral radius " +
                      std::to_string(options.step.spectral_radius).substr(0, 4) +
                      (options.fixed_step ? ", fixed step" : ", adaptive step");
  return report;
}

Finding make_start_finding(const std::string& text) {
  return Finding{FindingCode::start_without_build_up, text};
}

/// Warns of motions whose initial values differ from the static state.
Findings start_findings(const Model& model, const Simulation& run) {
  Findings findings;
  const bool carries = run.hull() != nullptr || run.lines().size() < run.system().lines.size();
  if (const double leap = carries ? initial_shoe_jump(model) : 0.0; leap > kMinReportedJump) {
    findings.push_back(
        make_start_finding(
            fmt::format("without a build-up the stern shoe jumps by {} from its static position: oscillations after "
                        "t = 0 come from that; set a few wave periods (analysis.dynamic.build_up)",
                        shown_digits(leap, "m", 3)))
            .on("vessel")
            .with("distance", leap, "m"));
  }
  if (const double speed = carries ? initial_shoe_speed(model) : 0.0; speed > kMinReportedSpeed) {
    findings.push_back(
        make_start_finding(
            fmt::format("without a build-up the stern shoe starts with {}: impacts and tensions after t = 0 "
                        "come from that; set a few wave periods (analysis.dynamic.build_up)",
                        shown_digits(speed, "m/s", 3)))
            .on("vessel")
            .with("speed", speed, "m/s"));
  }
  if (const double leap = run.lines().empty() ? 0.0 : initial_line_end_jump(model, run.options());
      leap > kMinReportedJump) {
    findings.push_back(
        make_start_finding(
            fmt::format("without a build-up a line end jumps by {} from its static position: oscillations after t = 0 "
                        "come from that; set a few periods (analysis.dynamic.build_up)",
                        shown_digits(leap, "m", 3)))
            .with("distance", leap, "m"));
  }
  return findings;
}

DynamicResults collect_results(const Model& model, const Simulation& run, const Recorder& recorder) {
  const DynamicOptions& options = run.options();
  DynamicResults r;
  r.duration = run.time();
  r.build_up = options.build_up;
  r.output_step = options.output_step;
  r.seed = options.seed;
  r.energy = run.energy();
  r.run = finished(run.report(), options, r.duration + std::ceil(r.build_up / r.output_step) * r.output_step);
  append(r.findings, start_findings(model, run));
  recorder.fill(r);
  r.assumptions = merge(std::move(r.assumptions), run.controllers().assumptions());
  append(r.findings, run.controllers().findings(run.system()));
  return r;
}

}  // namespace

DynamicOutcome run_dynamics(const Model& model, const StaticSolution& start, const StaticResults& statics,
                            const DynamicOptions& options, DynamicSink& sink, const DynamicCheckpoint* from,
                            const std::function<DynamicControl(const DynamicProgress&)>& control) {
  Simulation run(model, start, statics.top_tension, options);
  if (run.failure()) return {std::nullopt, run.failure(), false};
  Recorder recorder(model, statics, run, sink);
  run.observe(recorder);  // also before a restore: the recorder keeps the static state
  if (from != nullptr) {
    run.restore(*from);
  } else {
    recorder.row(run.present(), run.row_number());
  }
  const auto so_far = [&] { return collect_results(model, run, recorder); };
  while (!run.finished()) {
    if (!reach_row(run)) return {std::nullopt, std::nullopt, true};
    if (run.failure()) return {std::nullopt, run.failure(), false};
    const DynamicControl wanted =
        control({run.time(), run.end(), run.report().steps, recorder.top_tension(), [&so_far] { return so_far(); }});
    if (wanted != DynamicControl::go_on) sink.checkpoint(run.checkpoint());
    if (wanted == DynamicControl::stop && !run.finished()) {
      if (run.time() <= 0.0) return {std::nullopt, std::nullopt, true};
      return {so_far(), std::nullopt, true};
    }
  }
  if (run.report().wall_time > kMinCheckpointedTime) {
    sink.checkpoint(run.checkpoint());
  }  // results are still to be written
  return {so_far(), std::nullopt, false};
}

}  // namespace overbend
