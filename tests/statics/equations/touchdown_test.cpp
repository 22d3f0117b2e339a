#include "statics/equations/touchdown.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/fixtures.h"

namespace overbend {
namespace {

/// A circle of radius R that touches the bed at `s0` from the anchor, straight on the bed before.
struct Arc {
  static constexpr double kRadius = 200.0, kStart = 85.0, kDepth = 89.0;
  Model model = build_model(testing::plain_description());
  LineMesh mesh;
  LineState state;

  Arc() {
    const double pipe = model.sections.front().outer_radius();
    for (int i = 0; i <= 120; ++i) {
      const double s = 2.5 * i, angle = std::max(s - kStart, 0.0) / kRadius;
      mesh.s.push_back(s);
      const double x = std::min(s, kStart) + kRadius * std::sin(angle);
      // A millimetre in the bed before the arc, as a pipe that rests on it.
      const double z = -kDepth + pipe - 1e-3 + kRadius * (1.0 - std::cos(angle));
      for (const double value : {x, 0.0, z, std::cos(angle), 0.0, std::sin(angle)}) state.q.push_back(value);
      if (i > 0) {
        mesh.length.push_back(2.5);
        mesh.section.push_back(0);
      }
    }
  }
};

TEST(touchdown, is_where_the_underside_of_an_arc_meets_the_bed) {
  const Arc arc;
  const StaticSystem system(arc.model, arc.model.mean_pose, arc.mesh);
  const std::optional<ElementPlace> place = find_touchdown(system, arc.state);
  ASSERT_TRUE(place);
  const double off = std::acos(1.0 - 1e-3 / Arc::kRadius) * Arc::kRadius;  // the arc has risen by that millimetre
  EXPECT_NEAR(place->s, Arc::kStart + off, 0.02);                          // the cubic between nodes is no circle
  EXPECT_NEAR(bed_clearance(system, arc.state, place->element, place->xi), 0.0, 1e-9);
}

TEST(touchdown, the_waterline_is_where_the_axis_goes_under) {
  const Arc arc;
  const StaticSystem system(arc.model, arc.model.mean_pose, arc.mesh);
  const std::optional<ElementPlace> place = find_waterline(system, arc.state);
  ASSERT_TRUE(place);
  const double rise = Arc::kDepth - arc.model.sections.front().outer_radius() + 1e-3;
  EXPECT_NEAR(place->s, Arc::kStart + Arc::kRadius * std::acos(1.0 - rise / Arc::kRadius), 1e-3);
}

TEST(touchdown, a_line_clear_of_the_bed_has_none) {
  Arc arc;
  for (std::size_t i = 2; i < arc.state.q.size(); i += 6) arc.state.q[i] += 0.5;
  const StaticSystem system(arc.model, arc.model.mean_pose, arc.mesh);
  EXPECT_FALSE(find_touchdown(system, arc.state));
}

}  // namespace
}  // namespace overbend
