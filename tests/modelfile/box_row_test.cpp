// Boxes given as a row, and the settings of a stinger.
#include "model/vessel/box_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "base/constants.h"
#include "model/vessel/fitted_circle.h"
#include "model/vessel/supports.h"
#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

/// The good model with other boxes on the stinger.
std::string with_stinger(const std::string& keys) {
  std::string text = testing::kGoodModel;
  const std::size_t from = text.find("  stinger:\n"), to = text.find("analysis:\n");
  return text.replace(from, to - from, "  stinger:\n    roller: flat\n" + keys + "\n");
}

ModelReading read(const std::string& text) {
  return read_model_text(text, "folder/row.yaml");
}

std::vector<BoxDescription> stinger_boxes(const std::string& keys) {
  const ModelReading reading = read(with_stinger(keys));
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  std::vector<BoxDescription> boxes;
  for (const BoxDescription& box : reading.description.value_or(Description{}).supports.boxes) {
    if (box.structure == Structure::stinger) boxes.push_back(box);
  }
  return boxes;
}

bool complains(const std::string& keys, const std::string& path, const std::string& message) {
  const ModelReading reading = read(with_stinger(keys));
  for (const Diagnostic& d : reading.diagnostics.sorted()) {
    if (d.severity == Severity::error && d.key == path &&
        (d.found + " " + d.expected + " " + d.hint).find(message) != std::string::npos) {
      return true;
    }
  }
  return false;
}

const std::string kRow =
    "    radius: 150 m\n    boxes: {count: 8, spacing: 3.9 m, length: 2 m, "
    "first: {x: 4 m, z: -3 m, incline: 10 deg}}\n";

TEST(box_row, stands_on_the_circle_of_its_radius_an_arc_length_apart) {
  const std::vector<BoxDescription> boxes = stinger_boxes(kRow);
  ASSERT_EQ(boxes.size(), 8U);
  const double x0 = 4.0 - 150.0 * std::sin(10.0 * kDegree), z0 = -3.0 - 150.0 * std::cos(10.0 * kDegree);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const double turn = 10.0 * kDegree + 3.9 * static_cast<double>(i) / 150.0;
    EXPECT_NEAR(boxes[i].x, x0 + 150.0 * std::sin(turn), 1e-11);
    EXPECT_NEAR(boxes[i].z, z0 + 150.0 * std::cos(turn), 1e-11);
    EXPECT_NEAR(boxes[i].incline.value(), turn, 1e-14);
    EXPECT_EQ(boxes[i].length, 2.0);
    EXPECT_EQ(boxes[i].roller, "flat");
    EXPECT_EQ(boxes[i].name, "stinger " + std::to_string(i + 1));
  }
}

TEST(box_row, gives_the_rollers_of_the_same_boxes_in_a_list) {
  const ModelReading row = read(with_stinger(kRow));
  std::string list = "    boxes:\n";
  char text[200];
  for (const BoxDescription& box : stinger_boxes(kRow)) {
    std::snprintf(text, sizeof text, "      - {x: %.15g m, z: %.15g m, incline: %.15g rad, length: 2 m}\n", box.x,
                  box.z, box.incline.value());
    list += text;
  }
  const ModelReading listed = read(with_stinger(list));
  ASSERT_TRUE(row.description && listed.description);
  const Supports a = place_supports(*row.description, 0.2), b = place_supports(*listed.description, 0.2);
  ASSERT_EQ(a.rollers.size(), b.rollers.size());
  for (std::size_t i = 0; i < a.rollers.size(); ++i) {
    EXPECT_LT((a.rollers[i].center_S - b.rollers[i].center_S).norm(), 1e-9) << i;
    EXPECT_LT((a.rollers[i].normal_S - b.rollers[i].normal_S).norm(), 1e-9) << i;
  }
}

// The ramp of the good model ends at x = -9 m, z = -1.2 m on the chord of its two boxes.
TEST(box_row, without_a_first_box_continues_the_ramp_with_its_tangent) {
  const std::vector<BoxDescription> boxes = stinger_boxes("    radius: 120 m\n    boxes: {count: 3, spacing: 6 m}\n");
  ASSERT_EQ(boxes.size(), 3U);
  const double dip = std::atan2(2.3, 30.0);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const double turn = dip + 6.0 * static_cast<double>(i + 1) / 120.0;
    EXPECT_NEAR(boxes[i].x, -9.0 + 120.0 * (std::sin(turn) - std::sin(dip)), 1e-11);
    EXPECT_NEAR(boxes[i].z, -1.2 + 120.0 * (std::cos(turn) - std::cos(dip)), 1e-11);
    EXPECT_NEAR(boxes[i].incline.value(), turn, 1e-14);
  }
}

TEST(box_row, of_the_ramp_begins_with_the_direction_of_the_tensioner_and_the_stinger_continues_it) {
  std::string text = with_stinger("    radius: 100 m\n    boxes: {count: 2, spacing: 5 m}\n");
  const std::size_t from = text.find("    boxes:\n      - {name: ramp 1"), to = text.find("  stinger:\n");
  text.replace(from, to - from,
               "    radius: 150 m\n    boxes: {count: 4, spacing: 8 m, length: 3 m, first: {x: -39 m, z: 1.1 m}}\n");
  const ModelReading reading = read(text);
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  const std::vector<BoxDescription>& boxes = reading.description.value().supports.boxes;
  ASSERT_EQ(boxes.size(), 6U);
  EXPECT_EQ(boxes[0].x, -39.0);
  EXPECT_EQ(boxes[0].incline.value(), 0.0);
  EXPECT_EQ(boxes[3].rows, 3);
  EXPECT_NEAR(boxes[3].incline.value(), 24.0 / 150.0, 1e-14);
  EXPECT_NEAR(boxes[4].incline.value(), 24.0 / 150.0 + 5.0 / 100.0, 1e-14);
  EXPECT_NEAR(boxes[4].x, -39.0 + 150.0 * std::sin(0.16) + 100.0 * (std::sin(0.21) - std::sin(0.16)), 1e-11);
}

TEST(box_row, needs_a_radius_and_room_below_the_vertical) {
  const std::string boxes = "    boxes: {count: 8, spacing: 3.9 m, first: {x: 4 m, z: -3 m}}\n";
  EXPECT_TRUE(complains(boxes, "supports.stinger.radius", "missing"));
  EXPECT_TRUE(complains("    radius: 15 m\n" + boxes, "supports.stinger.radius", "at most 85 deg"));
  EXPECT_TRUE(complains("    radius: 150 m\n    boxes: {count: 8, spacing: 3.9 m, first: {x: -20 m, z: -3 m}}\n",
                        "supports.stinger.boxes.first.x", "more than '-9 m'"));
  EXPECT_TRUE(complains("    radius: 150 m\n    rows: 2\n" + boxes, "supports.stinger.boxes.length", "2 rows"));
  EXPECT_TRUE(complains("    radius: 150 m\n    boxes: {spacing: 3.9 m}\n", "supports.stinger.boxes.count", "missing"));
}

TEST(box_row, or_a_list_whose_radius_is_not_used_and_a_finding_says_so) {
  const std::string list = "    boxes:\n      - {x: 5 m, z: -4 m}\n      - {x: 9 m, z: -5 m}\n";
  EXPECT_TRUE(read(with_stinger(list)).description->findings.empty());
  const ModelReading reading = read(with_stinger("    radius: 500 m\n" + list));
  ASSERT_TRUE(reading.description);
  EXPECT_FALSE(reading.description->supports.stinger_radius.has_value());
  ASSERT_EQ(reading.description->findings.size(), 1U);
  const Finding& finding = reading.description->findings.front();
  EXPECT_EQ(finding.object, "supports.stinger.radius");
  EXPECT_NE(finding.message.find("'500 m' is not used for listed boxes"), std::string::npos) << finding.message;
  EXPECT_NE(finding.message.find("static.stinger_fitted_radius"), std::string::npos) << finding.message;
}

TEST(box_row, of_a_radius_has_this_radius_as_its_fitted_one_and_offsets_and_hinges_do_not_change_it) {
  const std::string hinge = "    hinge: {x: 3 m, z: -4 m}\n    angle: 7 deg\n";
  for (const std::string& stinger : {kRow, kRow + hinge}) {
    const ModelReading reading = read(with_stinger(stinger));
    ASSERT_TRUE(reading.description);
    // coordinates of some 100 m have 14 digits after the sine, over an arc that is 0.6 m high
    EXPECT_NEAR(fitted_radius(place_supports(*reading.description, 0.2), Structure::stinger).value_or(0.0), 150.0,
                1e-7);
  }
  std::string list = "    boxes:\n";
  for (const BoxDescription& box : stinger_boxes(kRow)) {
    list += "      - {x: " + std::to_string(box.x) + " m, z: " + std::to_string(box.z) + " m, offset: 0.3 m}\n";
  }
  const ModelReading listed = read(with_stinger(list));
  ASSERT_TRUE(listed.description);
  EXPECT_NEAR(fitted_radius(place_supports(*listed.description, 0.2), Structure::stinger).value_or(0.0), 150.0, 1e-3);
}

TEST(box_row, has_the_digits_of_a_straight_line_on_a_huge_radius) {
  const BoxPlace place = along_arc({1.0, 2.0, 0.1}, 1e12, 10.0);
  EXPECT_NEAR(place.x, 1.0 + 10.0 * std::cos(0.1), 1e-9);
  EXPECT_NEAR(place.z, 2.0 - 10.0 * std::sin(0.1), 1e-9);
}

TEST(stinger_settings, turn_the_sections_by_the_one_that_is_chosen) {
  const std::string hinged = kRow +
                             "    hinge: {x: 3 m, z: -4 m}\n    settings:\n      - {name: shallow, angle: -2 deg}\n"
                             "      - {name: deep, angles: [9 deg]}\n";
  for (const auto& [name, angle] : {std::pair{"shallow", -2.0}, std::pair{"deep", 9.0}}) {
    const ModelReading reading = read(with_stinger(hinged + "    setting: " + name + "\n"));
    for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
    const SupportsDescription& supports = reading.description.value().supports;
    ASSERT_EQ(supports.sections.size(), 1U);
    EXPECT_NEAR(supports.sections[0].angle.value(), angle * kDegree, 1e-15) << name;
    const Supports turned = place_supports(*reading.description, 0.2);
    EXPECT_NEAR(turned.boxes.back().inclination, 10.0 * kDegree + 27.3 / 150.0 + angle * kDegree, 1e-12);
  }
}

TEST(stinger_settings, lie_between_the_stops) {
  const std::string stinger = kRow + "    hinge: {x: 3 m, z: -4 m}\n    limits: [-8 deg, 6 deg]\n    settings:\n";
  EXPECT_TRUE(complains(stinger + "      - {name: high, angle: -30 deg}\n", "supports.stinger.settings[0].angle",
                        "between the stops"));
  EXPECT_FALSE(complains(stinger + "      - {name: high, angle: -8 deg}\n    setting: high\n",
                         "supports.stinger.settings[0].angle", "between the stops"));
}

TEST(stinger_settings, are_rejected_where_nothing_is_chosen_by_them) {
  const std::string hinge = "    hinge: {x: 3 m, z: -4 m}\n";
  EXPECT_TRUE(complains(kRow + hinge + "    settings: [{name: a, angles: [1 deg, 2 deg]}]\n",
                        "supports.stinger.settings[0].angles", "1, one for each section"));
  const std::string settings =
      "    settings:\n      - {name: shallow, angle: 2 deg}\n      - {name: deep, angle: 9 deg}\n";
  EXPECT_TRUE(complains(kRow + settings, "supports.stinger.settings[0]", "hinge"));
  EXPECT_TRUE(complains(kRow + settings + "    setting: dep\n", "supports.stinger.setting", "deep"));
  EXPECT_TRUE(complains(kRow + "    setting: deep\n", "supports.stinger.setting", "supports.stinger.settings"));
  EXPECT_TRUE(complains(kRow + "    settings: [{name: a, angle: 1 deg, angles: [1 deg]}]\n",
                        "supports.stinger.settings[0].angle", "one of them"));
  EXPECT_TRUE(complains(kRow + "    settings: [{name: a, angle: 1 deg}, {name: a, angle: 2 deg}]\n",
                        "supports.stinger.settings[1].name", "again"));
  EXPECT_TRUE(complains(kRow + "    settings: [{name: a}]\n", "supports.stinger.settings[0].angles", "each section"));
}

}  // namespace
}  // namespace overbend
