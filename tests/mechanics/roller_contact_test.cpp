#include "mechanics/roller_contact.h"

#include <gtest/gtest.h>

#include "mechanics/contact_cells.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

/// A roller across a pipe that runs along x, its face up.
PlacedRoller level_roller(const Vec3& center) {
  return {center, Vec3::UnitY(), Vec3::UnitZ(), 0.3, 0.15, 1e8};
}

/// Straight line of `n` nodes along x at height z, lateral offset y.
std::vector<double> straight(int n, double h, double y, double z) {
  std::vector<double> q;
  for (int i = 0; i < n; ++i) {
    for (const double v : {i * h, y, z, 1.0, 0.0, 0.0}) {
      q.push_back(v);
    }
  }
  return q;
}

TEST(roller_contact, distance_of_a_straight_pipe_is_its_height_over_the_axis) {
  const std::vector<double> q = straight(5, 1.0, 0.1, 0.5);
  const std::vector<double> h(4, 1.0);
  const PlacedRoller roller = level_roller(Vec3(2.3, 0.0, 0.1));
  const ClosestPoint closest = closest_point(roller, q.data(), h.data(), 0, 4);
  ASSERT_TRUE(closest.found);
  EXPECT_EQ(closest.element, 2);
  EXPECT_NEAR(closest.xi, 0.3, 1e-14);
  EXPECT_NEAR(roller_distance(roller, closest).value, 0.4, 1e-14);
}

TEST(roller_contact, a_pipe_below_the_roller_is_on_the_wrong_side_and_pushed_up) {
  const std::vector<double> q = straight(5, 1.0, 0.0, -0.7);
  const std::vector<double> h(4, 1.0);
  const PlacedRoller roller = level_roller(Vec3(2.3, 0.0, 0.1));
  const ClosestPoint closest = closest_point(roller, q.data(), h.data(), 0, 4);
  const RollerDistance d = roller_distance(roller, closest);
  EXPECT_NEAR(d.value, -0.8, 1e-14);
  EXPECT_NEAR(d.direction.z(), 1.0, 1e-14);
}

TEST(roller_contact, beyond_the_face_the_end_of_the_axis_counts_and_the_overrun_is_reported) {
  const std::vector<double> q = straight(5, 1.0, 0.7, 0.4);
  const std::vector<double> h(4, 1.0);
  const PlacedRoller roller = level_roller(Vec3(2.3, 0.0, 0.1));
  const ClosestPoint closest = closest_point(roller, q.data(), h.data(), 0, 4);
  ASSERT_TRUE(closest.beyond_face);
  EXPECT_NEAR(closest.off_end, 0.4, 1e-14);
  const RollerDistance d = roller_distance(roller, closest);
  EXPECT_NEAR(d.value, 0.5, 1e-14);  // 0.4 aside, 0.3 up
  EXPECT_NEAR(d.direction.y(), 0.8, 1e-14);
}

// Above the end of the roller it can still rest on that; below the roller it can only be when it went over the end.
TEST(roller_contact, a_pipe_that_lies_next_to_a_bottom_roller_or_under_it_has_left_the_box) {
  const std::vector<double> h(4, 1.0);
  const PlacedRoller roller = level_roller(Vec3(2.3, 0.0, 0.1));
  const auto neighbour = [&](RollerPosition position, double y, double z) {
    const std::vector<double> q = straight(5, 1.0, y, z);
    return has_left_box_sideways(position, roller, closest_point(roller, q.data(), h.data(), 0, 4), 0.2);
  };
  const RollerPosition bottom = RollerPosition::bottom;
  EXPECT_FALSE(neighbour(bottom, 0.29, 0.45));
  EXPECT_FALSE(neighbour(bottom, 0.45, 0.45));  // 0.15 beyond the end
  EXPECT_TRUE(neighbour(bottom, 0.55, 0.45));
  EXPECT_TRUE(neighbour(bottom, -0.55, 0.45));
  EXPECT_TRUE(neighbour(bottom, 0.32, -0.5));
  EXPECT_TRUE(neighbour(bottom, 0.0, -0.5));
  EXPECT_FALSE(neighbour(RollerPosition::port, 0.55, -0.5));
}

TEST(roller_contact, height_over_a_roller_is_negative_next_to_and_below_it) {
  const std::vector<double> h(4, 1.0);
  const PlacedRoller roller = level_roller(Vec3(2.3, 0.0, 0.1));
  for (const double y : {0.0, 0.32, 5.0}) {
    for (const double z : {-0.6, 0.3, 0.9}) {
      const std::vector<double> q = straight(5, 1.0, y, z);
      const ClosestPoint closest = closest_point(roller, q.data(), h.data(), 0, 4);
      EXPECT_NEAR(height_above_roller(roller, closest, 0.2), z - 0.2 - 0.25,
                  1e-14);  // underside, and top of the roller
    }
  }
}

class roller_contact_derivatives : public ::testing::TestWithParam<double> {};

TEST_P(roller_contact_derivatives, gradient_and_hessian_are_the_derivatives_with_the_closest_point_moving) {
  const double h = 1.1;
  const std::vector<double> q = testing::wavy_line(3, h, Vec3(0.0, GetParam(), 0.0), 9);
  const std::vector<double> lengths(2, h);
  PlacedRoller roller = level_roller(Vec3(1.6, 0.2, 0.0));
  roller.axis = Vec3(0.1, 0.9, 0.3).normalized();
  roller.normal = Vec3(0.0, -0.3, 0.9).normalized();
  const ClosestPoint closest = closest_point(roller, q.data(), lengths.data(), 0, 2);
  ASSERT_TRUE(closest.found);
  const auto distance = [&](const std::vector<double>& line) {
    const ClosestPoint p = closest_point(roller, line.data(), lengths.data(), 0, 2);
    return roller_distance(roller, p).value;
  };
  const ElementVector dofs = testing::element_dofs(q, closest.element);
  const RollerDistance d = roller_distance(roller, closest);
  const RollerDistanceDerivatives exact = roller_distance_derivatives(roller, closest, d, dofs, h);
  const auto moved = [&](int i, double di, int j, double dj) {
    std::vector<double> line = q;
    line[static_cast<std::size_t>(6 * closest.element + i)] += di;
    line[static_cast<std::size_t>(6 * closest.element + j)] += dj;
    return distance(line);
  };
  const double e = 1e-4;
  for (int i = 0; i < 12; ++i) {
    EXPECT_NEAR((moved(i, e, i, 0.0) - moved(i, -e, i, 0.0)) / (2 * e), exact.gradient(i), 1e-6);
    for (int j = 0; j < 12; ++j) {
      const double second =
          (moved(i, e, j, e) - moved(i, e, j, -e) - moved(i, -e, j, e) + moved(i, -e, j, -e)) / (4 * e * e);
      EXPECT_NEAR(second, exact.hessian(i, j), 2e-5) << i << " " << j;  // second difference, step 1e-4
    }
  }
}

INSTANTIATE_TEST_SUITE_P(on_the_face_and_beyond_it, roller_contact_derivatives, ::testing::Values(0.0, 0.8));

TEST(roller_contact, sliding_from_one_element_to_the_next_does_not_change_the_distance) {
  const std::vector<double> q = testing::wavy_line(3, 1.1, Vec3::Zero(), 9);
  const std::vector<double> h(2, 1.1);
  const Vec3 node(Eigen::Map<const Vec3>(q.data() + 6));
  const Vec3 t = Vec3(Eigen::Map<const Vec3>(q.data() + 9)).normalized();
  PlacedRoller roller = level_roller(Vec3::Zero());
  roller.half_face = 10.0;
  const auto at_offset = [&](double along) {
    roller.center = node - 0.4 * Vec3::UnitZ() + along * t;
    const ClosestPoint closest = closest_point(roller, q.data(), h.data(), 0, 2);
    return roller_distance(roller, closest).value;
  };
  const double jump = at_offset(1e-9) - at_offset(-1e-9);
  const double slope = (at_offset(1e-3) - at_offset(-1e-3)) / 2e-3;
  EXPECT_NEAR(jump, 2e-9 * slope, 1e-11);
}

TEST(contact_cells, cell_search_finds_every_contact_the_all_pairs_search_finds) {
  Description d = testing::plain_description();
  d.rollers.push_back({"v", {0.15, 0.6}, SideRollerDescription{0.15, 0.6, 1.0, 0.05}, std::nullopt, 0.0, 0.0, 0.5});
  for (int i = 0; i < 6; ++i) {
    BoxDescription box;
    box.name = "box";
    box.x = 5.0 * i;
    box.z = -0.06 * i * i;
    box.length = 3.0;
    box.rows = 3;
    box.roller = "v";
    d.supports.boxes.push_back(box);
  }
  const Supports supports = place_supports(d, 0.2445);
  const ContactCells cells = contact_cells(supports, 0.2445);
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> spread(-1.5, 1.5);
  std::vector<ElementRange> ranges;
  int contacts = 0;
  for (int trial = 0; trial < 300; ++trial) {
    // A line from far astern to the barge (against X), wavy enough to pass above, through and below the rollers.
    std::vector<double> q;
    const int nodes = 60;
    const double a = spread(generator), b = spread(generator), c = spread(generator);
    for (int i = 0; i < nodes; ++i) {
      const double x = 40.0 - i;
      for (const double v : {x, 0.3 * c * std::sin(0.2 * x), 0.24 + a - 0.08 * x + b * std::sin(0.4 * x + c), -1.0,
                             -0.06 * c * std::cos(0.2 * x), 0.08 - 0.4 * b * std::cos(0.4 * x + c)}) {
        q.push_back(v);
      }
    }
    const std::vector<double> h(static_cast<std::size_t>(nodes - 1), 1.05);
    std::vector<ElementBounds> bounds;
    for (int e = 0; e + 1 < nodes; ++e) {
      const ElementVector dofs = testing::element_dofs(q, e);
      double low = 1e9, high = -1e9, z = 1e9;
      for (const Vec3& p : {Vec3(dofs.segment<3>(0)), Vec3(dofs.segment<3>(0) + 0.35 * dofs.segment<3>(3)),
                            Vec3(dofs.segment<3>(6) - 0.35 * dofs.segment<3>(9)), Vec3(dofs.segment<3>(6))}) {
        low = std::min(low, p.x());
        high = std::max(high, p.x());
        z = std::min(z, p.z());
      }
      bounds.push_back({low, high, z});
    }
    search_cells(cells, bounds, ranges);
    for (const Roller& roller : supports.rollers) {
      const PlacedRoller placed{roller.center_S, roller.axis_S, roller.normal_S, 0.5 * roller.face, roller.radius, 1e8};
      const ClosestPoint all = closest_point(placed, q.data(), h.data(), 0, nodes - 1);
      if (!all.found) {
        continue;
      }
      const double distance = roller_distance(placed, all).value;
      if (std::abs(distance) >= 0.2445 + roller.radius + (distance < 0.0 ? kWrongSideReach : 0.0)) {
        continue;  // no contact, or beyond what the search promises
      }
      ++contacts;
      const ElementRange range = ranges[static_cast<std::size_t>(roller.box)];
      const ClosestPoint found = closest_point(placed, q.data(), h.data(), range.first, range.last);
      ASSERT_TRUE(found.found);
      EXPECT_EQ(found.element, all.element);
      EXPECT_DOUBLE_EQ(found.xi, all.xi);
    }
  }
  EXPECT_GT(contacts, 1000);
}

}  // namespace
}  // namespace overbend
