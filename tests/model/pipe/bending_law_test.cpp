#include "model/pipe/bending_law.h"

#include <gtest/gtest.h>

#include "model/material_description.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

SteelDescription steel_with_curve(std::vector<CurvePoint> points) {
  SteelDescription steel;
  steel.outside_diameter = 0.4064;
  steel.wall_thickness = 0.0191;
  steel.yield_stress = 450e6;
  steel.material.law = MaterialLaw::moment_curvature;
  steel.material.moment_curvature = std::move(points);
  return steel;
}

/// Moment over curvature of a pipe with a smooth curve whose first slope is 45 MN m2, half of that of its steel
/// section.
std::vector<CurvePoint> soft_curve() {
  return {{0.004, 180e3}, {0.006, 262e3}, {0.008, 330e3}, {0.01, 385e3}, {0.014, 455e3}, {0.02, 500e3}};
}

}  // namespace

TEST(bending_law, a_moment_curve_softer_than_the_steel_section_rules_from_its_first_point_on) {
  const SteelDescription steel = steel_with_curve(soft_curve());
  const BendingLaw law = *bending_law(steel, {});
  EXPECT_NEAR(law.EI, 45e6, 1.0);
  for (const CurvePoint& point : soft_curve()) {
    EXPECT_NEAR(monotonic(law, {0, 0.0}, point.x).moment, point.y, 0.02 * point.y) << point.x;
  }
  EXPECT_NEAR(monotonic(law, {0, 0.0}, 0.002).moment, 90e3, 1e-6);
}

TEST(bending_law, the_section_bends_as_its_moment_curve_begins) {
  SectionDescription pipe;
  pipe.steel = steel_with_curve(soft_curve());
  EXPECT_NEAR(derive_section("pipe", pipe, 10e3).EI, 45e6, 1.0);
  EXPECT_NEAR(derive_section("pipe", pipe, 10e3).second_moment,
              second_moment(pipe.steel.outside_diameter, pipe.steel.wall_thickness), 1e-18);
}

TEST(bending_law, a_curve_that_is_reproduced_roughly_is_warned_of) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
  d.pipe.section.steel = steel_with_curve(soft_curve());
  EXPECT_TRUE(material_findings(build_model(d)).empty());
  d.pipe.section.steel = steel_with_curve({{0.01, 450e3}, {0.02, 500e3}});  // a corner that no round pipe has
  const std::vector<std::string> warnings = messages(material_findings(build_model(d)));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("is reproduced only within 11"), std::string::npos) << warnings[0];
}

}  // namespace overbend
