// The keys of fatigue.
#include <gtest/gtest.h>

#include <algorithm>

#include "model/description/fatigue_enum_names.h"
#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

ModelReading read_with(const std::string& fatigue) {
  return read_model_text(testing::file_text(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml") + "\n" + fatigue, "model.yaml");
}

FatigueDescription described(const std::string& fatigue) {
  const ModelReading reading = read_with(fatigue);
  return reading.description.value().fatigue.value();
}

std::string first_error(const std::string& fatigue) {
  const std::vector<std::string> errors = read_with(fatigue).diagnostics.lines(Severity::error);
  return errors.empty() ? "" : errors.front();
}

TEST(fatigue_keys, an_empty_group_is_enough) {
  const FatigueDescription fatigue = described("fatigue: {}\n");
  EXPECT_TRUE(fatigue.spots.empty());
  EXPECT_EQ(fatigue.weld_time, 300.0);
  EXPECT_EQ(fatigue.move_time, 60.0);
  EXPECT_EQ(fatigue.budget, 0.1);
  EXPECT_FALSE(read_with("").description.value().fatigue);
}

TEST(fatigue_keys, every_key_fills_its_member) {
  const FatigueDescription fatigue = described(R"(fatigue:
  hi_lo: 1.5 mm
  thickness: 30 mm
  weld_time: 4 min
  move_time: 45 s
  joint: 24.4 m
  budget: 0.2
  design_factor: 3
  spots:
    - {name: cap, curve: E, medium: air}
    - {name: root, surface: inside, curve: F3, stress_factor: 1.4}
)");
  EXPECT_DOUBLE_EQ(fatigue.hi_lo, 0.0015);
  EXPECT_DOUBLE_EQ(fatigue.thickness.value(), 0.030);
  EXPECT_DOUBLE_EQ(fatigue.weld_time, 240.0);
  EXPECT_DOUBLE_EQ(fatigue.move_time, 45.0);
  EXPECT_DOUBLE_EQ(fatigue.joint.value(), 24.4);
  EXPECT_EQ(fatigue.budget, 0.2);
  EXPECT_EQ(fatigue.design_factor, 3.0);
  ASSERT_EQ(fatigue.spots.size(), 2U);
  EXPECT_FALSE(fatigue.spots[0].inside);
  EXPECT_EQ(fatigue.spots[0].curve, FatigueCurve::e);
  EXPECT_EQ(fatigue.spots[0].medium, FatigueMedium::air);
  EXPECT_TRUE(fatigue.spots[1].inside);
  EXPECT_EQ(fatigue.spots[1].curve, FatigueCurve::f3);
  EXPECT_EQ(fatigue.spots[1].stress_factor, 1.4);
}

TEST(fatigue_keys, what_cannot_be_meant_is_rejected) {
  EXPECT_NE(first_error("fatigue: {weld_time: 0 s, move_time: 0 s}\n").find("no time per joint"), std::string::npos);
  EXPECT_NE(first_error("fatigue: {joint: 12.2 mm}\n").find("from 0.1 m"), std::string::npos);  // no endless way
  EXPECT_NE(first_error("fatigue: {spots: [{name: a}, {name: a}]}\n").find("fatigue.spots"), std::string::npos);
  EXPECT_NE(first_error("fatigue: {budget: 0}\n").find("fatigue.budget"), std::string::npos);
  EXPECT_NE(first_error("fatigue: {design_factor: 0.5}\n").find("fatigue.design_factor"), std::string::npos);
  EXPECT_NE(first_error("fatigue: {spots: [{name: a, curve: Q}]}\n").find("W3"), std::string::npos);
}

TEST(fatigue_enum_names, every_enumerator_has_one_word_of_its_own) {
  for (int i = 0; i <= static_cast<int>(FatigueCurve::w3); ++i) {
    const auto curve = static_cast<FatigueCurve>(i);
    EXPECT_EQ(from_enum_name<FatigueCurve>(enum_name(curve)), curve);
  }
  EXPECT_EQ(enum_names<FatigueCurve>().size(), 14U);
  EXPECT_EQ(enum_names<FatigueMedium>().size(), 3U);
}

}  // namespace
}  // namespace overbend
