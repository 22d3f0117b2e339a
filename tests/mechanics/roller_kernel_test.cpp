#include "mechanics/roller_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/simd.h"
#include "mechanics/roller_contact.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

using Map = Eigen::Map<const Vec3>;

/// A line that winds, of elements of different length, and rollers next to, under and through it.
struct Passage {
  std::vector<double> q, v, length;
  std::vector<PlacedRoller> rollers;

  Passage() {
    std::mt19937_64 generator(11);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const auto direction = [&](const Vec3& near) {
      return Vec3(near + 0.4 * Vec3(any(generator), any(generator), any(generator))).normalized();
    };
    double x = 0.0;
    for (int i = 0; i < 40; ++i) {
      const Vec3 tangent = 1.001 * direction(5.0 * Vec3::UnitX());
      const Vec3 rate(any(generator), any(generator), any(generator)), turn(any(generator), any(generator), 0.0);
      q.insert(q.end(), {x, 0.2 * any(generator), 0.2 * any(generator), tangent.x(), tangent.y(), tangent.z()});
      v.insert(v.end(), {rate.x(), rate.y(), rate.z(), turn.x(), turn.y(), turn.z()});
      length.push_back(1.0 + 0.5 * std::abs(any(generator)));
      x += length.back();
    }
    length.pop_back();
    for (int i = 0; i < 301; ++i) {  // no whole number of registers
      const Vec3 axis = direction(Vec3::UnitY());
      const Vec3 normal = (Vec3::UnitZ() - Vec3::UnitZ().dot(axis) * axis).normalized();
      const Vec3 center(0.5 * x * (1.0 + 0.9 * any(generator)), 0.5 * any(generator), 0.5 * any(generator));
      rollers.push_back({center, axis, normal, 0.3, 0.15, 1e8});
    }
  }

  RolledLine line() const { return {q.data(), v.data(), length.data()}; }
  int elements() const { return static_cast<int>(length.size()); }
};

Vec3 velocity_at(const Passage& passage, const ClosestPoint& closest) {
  const HermiteValues n = hermite(closest.xi, passage.length[static_cast<std::size_t>(closest.element)]);
  return Eigen::Map<const Eigen::Matrix<double, 3, 4>>(passage.v.data() + 6 * closest.element) * n.value;
}

class roller_kernel : public ::testing::TestWithParam<Isa> {};

TEST_P(roller_kernel, sees_every_roller_where_the_search_one_by_one_finds_it) {
  if (GetParam() > best_isa()) GTEST_SKIP() << "this machine has no such registers";
  const Passage passage;
  std::vector<RollerSearch> looks;
  std::vector<ClosestPoint> found;
  for (const PlacedRoller& roller : passage.rollers) {
    found.push_back(closest_point(roller, passage.q.data(), passage.length.data(), 0, passage.elements()));
    ASSERT_TRUE(found.back().found);
    looks.push_back({roller.center.data(), roller.axis.data(), roller.normal.data(), roller.half_face,
                     std::clamp(found.back().xi + 0.1, 0.0, 1.0), found.back().element, found.back().passing});
  }
  std::vector<RollerClosestPoint> meetings(looks.size());
  find_closest_points(passage.line(), looks, meetings, GetParam());
  int beyond = 0, within = 0;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const ClosestPoint& closest = found[i];
    const RollerClosestPoint& seen = meetings[i];
    ASSERT_TRUE(seen.found);
    const RollerDistance distance = roller_distance(passage.rollers[i], closest);
    ++(closest.beyond_face ? beyond : within);
    ASSERT_EQ(seen.element, closest.element);
    EXPECT_EQ(seen.passing, closest.passing);
    EXPECT_EQ(seen.beyond_face, closest.beyond_face);
    EXPECT_NEAR(seen.xi, closest.xi, 1e-8);
    EXPECT_NEAR(seen.off_end, closest.off_end, 1e-8);
    EXPECT_NEAR(seen.distance, distance.value, 1e-10);
    EXPECT_LT((Map(seen.place) - closest.place).norm(), 1e-7);
    EXPECT_LT((Map(seen.tangent) - closest.tangent).norm(), 1e-7);
    EXPECT_LT((Map(seen.reference) - closest.reference).norm(), 1e-13);
    EXPECT_LT((Map(seen.direction) - distance.direction).norm(), 1e-6);
    EXPECT_LT((Map(seen.velocity) - velocity_at(passage, closest)).norm(), 1e-7);
    const HermiteValues n = hermite(closest.xi, passage.length[static_cast<std::size_t>(closest.element)]);
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(seen.shape[j], n.value(j), 1e-7);
  }
  EXPECT_GT(within, 100);
  EXPECT_GT(beyond, 50);
}

TEST_P(roller_kernel, finds_the_end_of_an_oblique_roller_in_another_element_than_its_axis) {
  if (GetParam() > best_isa()) GTEST_SKIP() << "this machine has no such registers";
  std::vector<double> q, length(9, 1.0);
  for (int i = 0; i < 10; ++i) q.insert(q.end(), {static_cast<double>(i), 0.0, 0.0, 1.0, 0.0, 0.0});
  const double turned = 20.0 * std::numbers::pi / 180.0, face = 0.3;
  const Vec3 axis(std::sin(turned), std::cos(turned), 0.0), center(4.75, -1.0, -0.2);
  const Vec3 end = center + face * axis;
  // The line crosses the axis at x = 4.75 + tan 20 deg, 5.114; the end, 1 / cos 20 deg - 0.3 before it, is at 4.853.
  const PlacedRoller roller{center, axis, Vec3::UnitZ(), face, 0.15, 1e8};
  const RollerSearch look{center.data(), axis.data(), roller.normal.data(), face, 0.5, 4, 5};
  std::vector<RollerClosestPoint> meetings(1);
  find_closest_points({q.data(), q.data(), length.data()}, {&look, 1}, meetings, GetParam());
  const ClosestPoint found = closest_point(roller, q.data(), length.data(), 0, 9);
  EXPECT_EQ(found.passing, 5);
  EXPECT_EQ(found.element, 4);
  const RollerClosestPoint& seen = meetings.front();
  ASSERT_TRUE(seen.found);
  EXPECT_TRUE(seen.beyond_face);
  EXPECT_EQ(seen.passing, 5);
  EXPECT_EQ(seen.element, 4);
  EXPECT_NEAR(4.0 + seen.xi, end.x(), 1e-12);
  EXPECT_NEAR(seen.off_end, 1.0 / std::cos(turned) - face, 1e-12);
  EXPECT_NEAR(seen.distance, std::hypot(end.y(), end.z()), 1e-12);
}

TEST_P(roller_kernel, finds_nothing_in_an_element_that_does_not_pass_the_roller) {
  if (GetParam() > best_isa()) GTEST_SKIP() << "this machine has no such registers";
  const Passage passage;
  std::vector<RollerSearch> looks;
  for (const PlacedRoller& roller : passage.rollers) {
    const ClosestPoint closest = closest_point(roller, passage.q.data(), passage.length.data(), 0, passage.elements());
    const int wrong = closest.element >= 5 ? closest.element - 5 : closest.element + 5;
    looks.push_back(
        {roller.center.data(), roller.axis.data(), roller.normal.data(), roller.half_face, 0.5, wrong, wrong});
  }
  std::vector<RollerClosestPoint> meetings(looks.size());
  find_closest_points(passage.line(), looks, meetings, GetParam());
  for (const RollerClosestPoint& seen : meetings) EXPECT_FALSE(seen.found);
}

INSTANTIATE_TEST_SUITE_P(every_instruction_set, roller_kernel,
                         ::testing::Values(Isa::baseline, Isa::avx2, Isa::avx512));

}  // namespace
}  // namespace overbend
