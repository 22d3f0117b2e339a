#include "model/model_findings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "modelfile/reading/yaml_reader.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

Description first_model() {
  return read_model(OVERBEND_SOURCE_DIR "/examples/first-model.yaml").description.value();
}

bool says(const Description& d, const std::string& message) {
  const std::vector<std::string> list = messages(model_findings(build_model(d)));
  return std::any_of(list.begin(), list.end(),
                     [&](const std::string& text) { return text.find(message) != std::string::npos; });
}

TEST(model_findings, a_dynamic_analysis_in_which_nothing_moves_is_reported) {
  const std::string message = "nothing moves in the dynamic analysis";
  Description d = first_model();
  EXPECT_FALSE(says(d, message));  // statics alone
  d.dynamics.emplace();
  EXPECT_TRUE(says(d, message));
  Description moving = d;
  moving.vessel.motion = VesselMotion::harmonic;
  moving.vessel.harmonic["heave"] = {0.0, 8.0, 0.0};
  EXPECT_TRUE(says(moving, message));
  moving.vessel.harmonic["heave"].amplitude = 0.5;
  EXPECT_FALSE(says(moving, message));
  Description recorded = d;
  recorded.vessel.motion = VesselMotion::history;
  recorded.vessel.history = MotionHistory{{0.0, 1.0}, {{}, {}}, "still.csv"};
  EXPECT_TRUE(says(recorded, message));
  d.environment.waves.front().type = WaveType::airy;
  EXPECT_FALSE(says(d, message));
}

TEST(model_findings, raos_that_disagree_with_long_waves_are_reported) {
  Description d = first_model();
  d.vessel.motion = VesselMotion::raos;
  d.vessel.raos = testing::bgl1_raos();
  d.environment.water_depth = 89.0;
  EXPECT_FALSE(says(d, "check the conventions"));
  for (std::complex<double>& value : d.vessel.raos->values) value = -value;
  EXPECT_TRUE(says(d, "check the conventions (vessel.motion.convention)"));
}

TEST(model_findings, an_assumed_yield_stress_reserves_the_verdict) {
  Description d = first_model();
  EXPECT_FALSE(has_code(model_findings(build_model(d)), FindingCode::yield_assumed));
  d.pipe.segments.push_back({"thick", 20.0, d.pipe.section});
  d.pipe.segments.back().section.steel.yield_assumed = true;
  d.pipe.segments.back().section.steel.yield_stress = 415e6;
  const Findings findings = serious_findings(model_findings(build_model(d)));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].object, "segment thick");
  EXPECT_NE(findings[0].message.find("assumption, 415 MPa"), std::string::npos) << findings[0].message;
}

TEST(model_findings, a_mooring_line_that_is_to_be_pulled_beyond_its_strength_is_reported) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-moored.yaml").description.value();
  const std::string message = "is more than its breaking load";
  EXPECT_FALSE(says(d, message));
  d.moorings->lines[2].tension = 30e6;  // MN for kN
  EXPECT_TRUE(says(d, "'" + d.moorings->lines[2].name + "', 3e+04 kN, " + message));
}

}  // namespace
}  // namespace overbend
