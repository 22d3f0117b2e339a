// Bodies in addition the vessel: what their keys fill, and what the reader rejects by name.
#include <gtest/gtest.h>

#include "base/constants.h"
#include "modelfile/reading/yaml_reader.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

const std::string kModel = R"(overbend: 1
environment: {water_depth: 50 m, seabed: {stiffness: 100 kN/m^2}}
vessel: {heading: 90 deg, motion: fixed}
bodies:
  - name: tug
    place: {x: 200 m, y: 10 m}
    heading: 270 deg
    motion: {harmonic: {heave: {amplitude: 1 m, period: 8 s}}}
moorings:
  types:
    rope: {diameter: 80 mm, mass: 10 kg/m, axial_stiffness: 20 MN}
lines:
  - name: hawser
    ends: [{body: vessel, at: {x: 60 m, y: 0 m, z: 5 m}}, {body: tug, at: {x: -12 m, y: 0 m, z: 3 m}}]
    type: rope
    length: 155 m
)";

std::string with(const std::string& before, const std::string& after) {
  std::string text = kModel;
  const auto sample = text.find(before);
  EXPECT_NE(sample, std::string::npos) << before;
  return text.replace(sample, before.size(), after);
}

/// The one complaint, which names the line, the key and what is wrong.
void expect_complaint(const std::string& text, const std::string& key, const std::string& message) {
  const std::vector<std::string> errors = read_model_text(text, "tug.yaml").diagnostics.lines(Severity::error);
  ASSERT_EQ(errors.size(), 1U) << message;
  EXPECT_NE(errors.front().find("tug.yaml:"), std::string::npos) << errors.front();
  EXPECT_NE(errors.front().find(key), std::string::npos) << errors.front();
  EXPECT_NE(errors.front().find(message), std::string::npos) << errors.front();
}

TEST(body_keys, fill_a_body_and_the_ends_that_are_on_it) {
  const ModelReading reading = read_model_text(kModel, "tug.yaml");
  ASSERT_TRUE(reading.description) << reading.diagnostics.lines(Severity::error).front();
  const Description& d = *reading.description;
  ASSERT_EQ(d.bodies.size(), 1U);
  const BodyDescription& tug = d.bodies[0];
  EXPECT_EQ(tug.name, "tug");
  EXPECT_EQ(tug.place, Vec3(200.0, 10.0, 0.0));
  EXPECT_NEAR(tug.hull.heading, 270.0 * kDegree, 1e-12);
  EXPECT_EQ(tug.hull.length, 30.0);  // of a tug, where it is not given
  EXPECT_EQ(tug.hull.motion, VesselMotion::harmonic);
  EXPECT_EQ(tug.hull.harmonic.at("heave").period, 8.0);
  EXPECT_EQ(d.vessel.motion, VesselMotion::fixed);
  EXPECT_EQ(d.lines[0].first.body, "vessel");
  EXPECT_EQ(d.lines[0].second.body, "tug");
  EXPECT_EQ(d.lines[0].second.at, Vec3(-12.0, 0.0, 3.0));
  EXPECT_TRUE(reading.diagnostics.lines(Severity::warning).empty());
}

TEST(body_keys, reject_an_end_on_a_body_that_is_not_there) {
  expect_complaint(with("{body: tug, at", "{body: tgu, at"), "body", "did you mean 'tug'");
}

TEST(body_keys, reject_a_second_body_of_a_name_and_the_name_of_the_vessel) {
  expect_complaint(with("    heading: 270 deg", "  - name: tug\n    place: {x: 0 m, y: 0 m}\n    heading: 270 deg"),
                   "name", "again");
  expect_complaint(with("    heading: 270 deg", "  - name: vessel\n    place: {x: 0 m, y: 0 m}\n    heading: 270 deg"),
                   "bodies", "that of the lay vessel");
}

TEST(body_keys, reject_a_body_without_a_place_and_an_end_without_a_point) {
  expect_complaint(with("    place: {x: 200 m, y: 10 m}\n", ""), "place", "bodies[0]");
  expect_complaint(with(", at: {x: -12 m, y: 0 m, z: 3 m}", ""), "at", "the point of the body");
}

/// The motion of a body is prescribed: what would let it float is no key of it.
TEST(body_keys, reject_a_hull_that_floats_free) {
  const std::string text = with("{harmonic: {heave: {amplitude: 1 m, period: 8 s}}}", "{coupled: {mass: 500 t}}");
  const std::vector<std::string> errors = read_model_text(text, "tug.yaml").diagnostics.lines(Severity::error);
  ASSERT_FALSE(errors.empty());
  EXPECT_NE(errors.front().find("bodies[0].motion.coupled"), std::string::npos) << errors.front();
  EXPECT_NE(errors.front().find("raos, history, harmonic"), std::string::npos) << errors.front();
}

TEST(body_keys, reject_two_sources_of_a_motion) {
  expect_complaint(with("period: 8 s}}}", "period: 8 s}}, history: tug.csv}"), "motion", "1 of");
}

TEST(body_keys, warn_of_a_body_that_no_line_is_on) {
  const ModelReading reading = read_model_text(with("{body: tug, at", "{body: vessel, at"), "tug.yaml");
  ASSERT_TRUE(reading.description);
  const std::vector<std::string> warnings = reading.diagnostics.lines(Severity::warning);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings.front().find("no line is attached to this body"), std::string::npos);
}

TEST(lift_keys, move_bodies_by_their_names) {
  const std::string stages = "operation:\n  type: lift\n  stages:\n    - {name: ahead, bodies: {tug: {x: 5 m}}}\n";
  const ModelReading reading = read_model_text(kModel + stages, "tug.yaml");
  ASSERT_TRUE(reading.description) << reading.diagnostics.lines(Severity::error).front();
  const std::vector<BodyOffset>& bodies = reading.description->operation.lay.stages.at(0).bodies;
  ASSERT_EQ(bodies.size(), 1U);
  EXPECT_EQ(bodies[0].body, "tug");
  EXPECT_EQ(bodies[0].offset.x, 5.0);
  expect_complaint(kModel + "operation:\n  type: lift\n  stages:\n    - {name: ahead, bodies: {tow: {x: 5 m}}}\n",
                   "bodies", "the unknown body 'tow'");
}

TEST(lift_keys, move_no_vessel_that_floats_free) {
  std::string text = with("motion: fixed", "hydrostatics: {heave: 10 MN/m, roll: 1000 MN*m, pitch: 10000 MN*m}");
  text += "operation:\n  type: lift\n  stages:\n    - {name: ahead, vessel: {x: 5 m}}\n";
  expect_complaint(text, "vessel", "free-floating");
}

}  // namespace
}  // namespace overbend
