// A stinger on hinges as the file gives it.
#include <gtest/gtest.h>

#include "base/constants.h"
#include "model/lay_stage.h"
#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

const std::string kTank = "{name: aft, from: {x: 2 m, z: -3 m}, to: {x: 9 m, z: -6 m}, diameter: 1.2 m, weight: 30 kN}";

/// The good model with other keys in its stinger, which has a box at 5.23 m and one at 9 m.
ModelReading read(const std::string& keys, const std::string& more = {}) {
  std::string text = testing::kGoodModel;
  const std::string text_place = "  stinger:\n";
  text.insert(text.find(text_place) + text_place.size(), keys);
  return read_model_text(text + more, "model.yaml");
}

/// The same with its boxes in two sections.
ModelReading read_sections(const std::string& first, const std::string& second) {
  std::string text = testing::kGoodModel;
  const std::size_t from = text.find("    boxes:\n", text.find("  stinger:\n")), to = text.find("analysis:");
  text.replace(from, to - from,
               "    sections:\n      - {boxes: [{x: 5.23 m, z: -4.5 m}], " + first +
                   "}\n      - {boxes: [{x: 9 m, z: -5.7 m}, {x: 14 m, z: -8 m}], " + second + "}\n\n");
  return read_model_text(text, "model.yaml");
}

Description good(const ModelReading& reading) {
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return reading.description.value_or(Description{});
}

void expect_error(const ModelReading& reading, const std::string& key, const std::string& message) {
  const std::vector<std::string> errors = reading.diagnostics.lines(Severity::error);
  ASSERT_EQ(errors.size(), 1U) << (errors.empty() ? "" : errors[1]);
  EXPECT_NE(errors[0].find(key), std::string::npos) << errors[0];
  EXPECT_NE(errors[0].find(message), std::string::npos) << errors[0];
}

TEST(stinger_keys, fill_one_section) {
  const Description d =
      good(read("    hinge: {x: 0 m, z: -1.5 m}\n"
                "    body: {weight: 150 kN, at: {x: 4 m, z: -3 m}, buoyancy: 100 kN, buoyancy_at: {x: 5 m, z: -4 m}}\n"
                "    tanks: [" +
                kTank +
                "]\n"
                "    limits: [-3 deg, 5 deg]\n"
                "    hinge_friction: 20 kN*m\n"
                "    springs: [{on_barge: {x: -1 m, z: 5 m}, on_stinger: {x: 8 m, z: -4 m}, stiffness: 900 kN/m, type: "
                "strut}]\n"));
  ASSERT_EQ(d.supports.sections.size(), 1U);
  const StingerSectionDescription& section = d.supports.sections[0];
  EXPECT_EQ(section.hinge.z, -1.5);
  EXPECT_FALSE(section.angle);
  EXPECT_TRUE(section.floats());
  ASSERT_TRUE(section.body && section.body->buoyancy_at && section.limits);
  EXPECT_EQ(section.body->weight, 150e3);
  EXPECT_EQ(section.body->at.x, 4.0);
  EXPECT_EQ(section.body->buoyancy, 100e3);
  EXPECT_EQ(section.body->buoyancy_at->z, -4.0);
  ASSERT_EQ(section.tanks.size(), 1U);
  EXPECT_EQ(section.tanks[0].name, "aft");
  EXPECT_EQ(section.tanks[0].to.x, 9.0);
  EXPECT_EQ(section.tanks[0].ballast, 0.0);
  EXPECT_DOUBLE_EQ(section.limits->up, -3.0 * kDegree);
  EXPECT_DOUBLE_EQ(section.limits->down, 5.0 * kDegree);
  EXPECT_EQ(section.hinge_friction, 20e3);
  ASSERT_EQ(section.springs.size(), 1U);
  EXPECT_EQ(section.springs[0].name, "spring 1");
  EXPECT_EQ(section.springs[0].stiffness, 900e3);
  EXPECT_FALSE(section.springs[0].wire);
}

TEST(stinger_keys, fill_sections_with_their_boxes) {
  const Description d = good(read_sections("hinge: {x: 0 m, z: -1.5 m}, angle: 2 deg",
                                           "name: tail, hinge: {x: 7 m, z: -5 m}, tanks: [" + kTank + "]"));
  ASSERT_EQ(d.supports.sections.size(), 2U);
  EXPECT_EQ(d.supports.sections[0].name, "section 1");
  EXPECT_DOUBLE_EQ(d.supports.sections[0].angle.value(), 2.0 * kDegree);
  EXPECT_EQ(d.supports.sections[1].name, "tail");
  EXPECT_TRUE(d.supports.sections[1].floats());
  ASSERT_EQ(d.supports.boxes.size(), 5U);
  EXPECT_EQ(d.supports.boxes[2].name, "stinger 1");
  EXPECT_EQ(d.supports.boxes[2].section, 0);
  EXPECT_EQ(d.supports.boxes[4].name, "stinger 3");
  EXPECT_EQ(d.supports.boxes[4].section, 1);
  EXPECT_EQ(d.supports.boxes[4].roller, "flat");
}

TEST(stinger_keys, leave_a_stinger_without_hinge_fixed) {
  EXPECT_TRUE(good(read("")).supports.sections.empty());
}

TEST(stinger_keys, need_a_hinge) {
  expect_error(read("    angle: 2 deg\n"), "supports.stinger.hinge", "missing");
}

TEST(stinger_keys, are_of_the_stinger_or_of_its_sections) {
  std::string text = "    sections: [{hinge: {x: 0 m, z: -1 m}, boxes: [{x: 20 m, z: -9 m}]}]\n";
  expect_error(read(text), "supports.stinger.boxes", "sections");
}

TEST(stinger_keys, have_stops_in_order_and_the_angle_between_them) {
  const std::string hinge = "    hinge: {x: 0 m, z: -1.5 m}\n";
  expect_error(read(hinge + "    limits: [5 deg, -3 deg]\n"), "supports.stinger.limits[1]", "more than");
  expect_error(read(hinge + "    limits: [-3 deg]\n"), "supports.stinger.limits", "exactly 2");
  expect_error(read(hinge + "    limits: [-3 deg, 5 deg]\n    angle: 6 deg\n"), "supports.stinger.angle", "between");
}

TEST(stinger_keys, name_tanks_once) {
  expect_error(read("    hinge: {x: 0 m, z: -1.5 m}\n    tanks: [" + kTank + ", " + kTank + "]\n"), "tanks[1].name",
               "again");
}

TEST(stinger_keys, list_sections_and_their_boxes_astern) {
  expect_error(read_sections("hinge: {x: 7 m, z: -5 m}", "hinge: {x: 0 m, z: -1.5 m}"), "sections[1].hinge.x",
               "more than");
}

TEST(stinger_keys, give_a_tank_a_length) {
  expect_error(read("    hinge: {x: 0 m, z: -1.5 m}\n    tanks: [{from: {x: 1 m, z: 0 m}, to: {x: 1 m, z: 0 m}, "
                    "diameter: 1 m}]\n"),
               "tanks[0].to", "another place");
}

const std::string kFloating = "    hinge: {x: 0 m, z: -1.5 m}\n    tanks: [" + kTank + "]\n";

TEST(ballast_operation, changes_the_tank_at_its_stages) {
  const Description d =
      good(read(kFloating, "\noperation: {type: ballast, tank: aft, stages: [{weight: 40 kN}, {ballast: 0.3}]}\n"));
  const std::vector<LayStageDescription> stages = lay_stages(d);
  ASSERT_EQ(stages.size(), 2U);
  const Description first = make_stage_description(d, stages[0]), second = make_stage_description(d, stages[1]);
  EXPECT_EQ(first.supports.sections[0].tanks[0].weight, 40e3);
  EXPECT_EQ(first.supports.sections[0].tanks[0].ballast, 0.0);
  EXPECT_EQ(second.supports.sections[0].tanks[0].weight, 30e3);
  EXPECT_EQ(second.supports.sections[0].tanks[0].ballast, 0.3);
  EXPECT_EQ(second.tensioner.tension, d.tensioner.tension);
}

TEST(ballast_operation, names_a_tank_that_is_there) {
  const auto with = [](const std::string& operation) {
    return read(kFloating, "\noperation: {type: ballast, " + operation + "}\n");
  };
  expect_error(with("tank: fore, stages: [{ballast: 0.3}]"), "operation.tank", "aft");
  expect_error(with("stages: [{ballast: 0.3}]"), "operation.tank", "missing");
  expect_error(with("tank: aft, stages: [{tension: 300 kN}]"), "operation.stages[0].ballast", "missing");
  expect_error(with("tank: aft, stages: {from: 1 m, to: 2 m}"), "operation.stages", "a list of stages");
}

}  // namespace
}  // namespace overbend
