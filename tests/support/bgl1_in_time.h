/// The BGL-1 example in time, on a coarse mesh.
#pragma once

#include <functional>

#include "checks/run_checks.h"
#include "modelfile/reading/yaml_reader.h"
#include "recording/run_dynamics.h"
#include "statics/recovery/recovery.h"
#include "study/run/static_analysis.h"

namespace overbend::testing {

/// The example in a sea that a barge works in, coarse, for a short time.
inline Description workable() {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
  d.environment.waves.front().hs = 1.5;
  d.environment.waves.front().tp = 8.0;
  d.environment.waves.front().from = 1.75;  // nearly from ahead
  d.environment.waves.front().components = 40;
  d.mesh.overbend_element = 1.0;
  d.mesh.touchdown_element = 3.0;
  d.mesh.max_element_length = 8.0;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 12.0;
  d.dynamics->build_up = 4.0;
  return d;
}

/// A model with its static state, to be run in time.
struct TimedLay {
  explicit TimedLay(const Description& d)
      : model(build_model(d)),
        start(solve_statics(model).solution.value()),
        statics(checked_statics(model, {start, {}, {}})) {}

  DynamicOutcome run(
      DynamicSink& sink, const DynamicOptions& options, const DynamicCheckpoint* from = nullptr,
      const std::function<DynamicControl(const DynamicProgress&)>& control = [](const DynamicProgress&) {
        return DynamicControl::go_on;
      }) const {
    return run_dynamics(model, start, statics, options, sink, from, control);
  }
  DynamicResults results(DynamicSink& sink) const {
    DynamicResults r = run(sink, dynamic_options(model)).results.value();
    fill_checks(model, statics, r);
    return r;
  }

  Model model;
  StaticSolution start;
  StaticResults statics;
};

}  // namespace overbend::testing
