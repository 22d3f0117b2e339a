/// The example as the engine solves it: real results for tests of the report.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "model/model.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/statics.h"
#include "study/run/static_analysis.h"

namespace overbend::testing {

struct SolvedExample {
  StaticResults results;
  std::string model_text;
};

/// Solved once for all tests.
inline const SolvedExample& bgl1() {
  static const SolvedExample kSolved = [] {
    const ModelReading reading = read_model(std::string(OVERBEND_SOURCE_DIR) + "/examples/bgl1.yaml");
    if (!reading.description) {
      throw std::runtime_error("the example cannot be read");
    }
    const Model model = build_model(*reading.description);
    const StaticOutcome outcome = solve_statics(model);
    if (!outcome.solution) {
      throw std::runtime_error("the example cannot be solved");
    }
    return SolvedExample{checked_statics(model, {outcome.solution, {}, {}}), reading.description->source_text};
  }();
  return kSolved;
}

}  // namespace overbend::testing
