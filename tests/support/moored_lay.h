/// BGL-1 on its moorings for tests: coarse, and solved.
#pragma once

#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/moored_lay.h"

namespace overbend::testing {

/// An example on a coarse mesh, with few waves, for a run of `duration` after `build_up` [s].
inline Description coarse_example(const char* name, double duration, double build_up) {
  Description d = read_model(std::string(OVERBEND_SOURCE_DIR "/examples/") + name + ".yaml").description.value();
  d.environment.waves.front().components = 40;
  d.mesh.overbend_element = 1.0;
  d.mesh.touchdown_element = 3.0;
  d.mesh.max_element_length = 8.0;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = duration;
  d.dynamics->build_up = build_up;
  return d;
}

struct SolvedLay {
  explicit SolvedLay(const Description& d) : model(build_model(d)), lay(solve_lay(model)) {}
  Model model;
  ModelEquilibrium lay;
  double tension() const { return model.description.tensioner.tension.value(); }
};

/// A hull without a pipe.
struct SolvedHull {
  explicit SolvedHull(const Description& d) : model(build_model(d)), rest(solve_moored_hull(model)) {
    EXPECT_FALSE(rest.failure) << rest.failure->why;
  }
  const StaticSolution& start() const { return *rest.solution; }

  Model model;
  ModelEquilibrium rest;
};

/// Its results.
inline MooringResults rest_of_hull(const Description& d) {
  return SolvedHull(d).rest.moorings.value_or(MooringResults{});
}

}  // namespace overbend::testing
