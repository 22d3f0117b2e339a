#include "recording/mooring_watch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "checks/run_checks.h"
#include "modelfile/yaml_reader.h"
#include "recording/run_dynamics.h"
#include "study/static_run.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

/// Warnings of a second of the BGL-1 on its moorings.
std::vector<std::string> warnings_with(double breaking, double brake, double holding) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-moored.yaml").description.value();
  d.environment.waves.components = 40;
  d.mesh.overbend_element = 1.0;
  d.mesh.touchdown_element = 3.0;
  d.mesh.longest_element = 8.0;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 0.5;
  d.dynamics->build_up = 0.5;
  MooringLineDescription& line = d.moorings->lines.front();
  line.segments.front().type.breaking_load = breaking;
  line.anchor_holding.holding = holding;
  d.moorings->winches.front().brake = brake;
  Model model = build_model(d);
  const LayOutcome lay = solve_lay(model);
  const StaticResults statics = checked_statics(model, lay);
  testing::MemorySink sink;
  const DynamicOutcome outcome = run_dynamics(model, *lay.solution, statics, dynamic_options(model), sink, nullptr,
                                              [](const DynamicProgress&) { return DynamicControl::go_on; });
  return outcome.results.value().warnings;
}

bool says(const std::vector<std::string>& warnings, const std::string& words) {
  return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& warning) {
    return warning.find("\"port bow\"") != std::string::npos && warning.find(words) != std::string::npos;
  });
}

// The line has some 320 kN.
TEST(mooring_watch, says_which_line_is_beyond_what_it_bears) {
  const std::vector<std::string> weak = warnings_with(250e3, 260e3, 150e3);
  EXPECT_TRUE(says(weak, "its breaking load of 250.0 kN"));
  EXPECT_TRUE(says(weak, "its brake, set to 260.0 kN, paid out"));
  EXPECT_TRUE(says(weak, "holding power"));
  const std::vector<std::string> strong = warnings_with(2594e3, 1600e3, 1500e3);
  EXPECT_FALSE(says(strong, "kN"));
}

}  // namespace
}  // namespace overbend
