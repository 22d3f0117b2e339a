#include "model/pipe/line_types.h"

#include <gtest/gtest.h>

#include <numbers>

#include "model/pipe/section.h"

namespace overbend {
namespace {

constexpr double kWater = 1025.0 * kGravity;

// The wire of BGL-1's representative set: 16.34 kg/m, 165.5 MN, 2,594 kN, 139.6 N/m in water.
TEST(line_types, wire_of_64_mm_has_the_numbers_of_its_table) {
  const LineTypeDescription wire = wire_rope(0.064, RopeCore::wire);
  EXPECT_NEAR(wire.weight_in_air / kGravity, 16.342, 5e-4);
  EXPECT_NEAR(wire.axial_stiffness, 165.478e6, 1e3);
  EXPECT_NEAR(*wire.breaking_load, 2594.4e3, 0.1e3);
  EXPECT_NEAR(submerged_weight(wire, kWater), 139.57, 0.01);
  EXPECT_EQ(wire.drag_diameter, 0.064);
  EXPECT_EQ(wire.drag_normal, 1.8);
  EXPECT_EQ(wire.made_from, "six-strand wire rope of 64 mm with a wire core");
}

TEST(line_types, fibre_core_is_lighter_softer_and_weaker) {
  const LineTypeDescription wire = wire_rope(0.05, RopeCore::wire), fibre = wire_rope(0.05, RopeCore::fibre);
  EXPECT_NEAR(fibre.weight_in_air / wire.weight_in_air, 3610.9 / 3989.7, 1e-12);
  EXPECT_LT(fibre.axial_stiffness, wire.axial_stiffness);
  EXPECT_LT(*fibre.breaking_load, *wire.breaking_load);
}

// Steel of 7,850 kg/m3 has the displaced volume where the volume's diameter is right: 20,000 d^2 / (pi/4 1.8^2 d^2).
TEST(line_types, chain_displaces_the_volume_of_its_steel) {
  for (const ChainLink link : {ChainLink::studless, ChainLink::studlink}) {
    const LineTypeDescription type = chain(0.076, link);
    const double weight_in_water = submerged_weight(type, kWater);
    EXPECT_NEAR(1.0 - weight_in_water / type.weight_in_air, 1025.0 / 7850.0, 0.002);
  }
}

TEST(line_types, chain_has_the_numbers_of_its_table) {
  const LineTypeDescription studless = chain(0.1, ChainLink::studless);
  EXPECT_NEAR(studless.weight_in_air / kGravity, 200.0, 1e-9);
  EXPECT_NEAR(studless.axial_stiffness, 8.56e8 - 3.93e4, 1.0);
  EXPECT_NEAR(*studless.breaking_load, 91.1 + 1.21e7 - 2.19e6, 1.0);
  EXPECT_NEAR(studless.drag_diameter, 0.18, 1e-12);
  // Along the line the table's coefficient stands on the area shown, the line's on pi times that.
  const LineTypeDescription studlink = chain(0.1, ChainLink::studlink);
  EXPECT_NEAR(std::numbers::pi * studlink.drag_axial, 0.741, 1e-12);
}

}  // namespace
}  // namespace overbend
