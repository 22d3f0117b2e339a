#include "mechanics/roller_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/simd.h"
#include "mechanics/roller_contact.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

using Map = Eigen::Map<const Vec3>;

/// A line that winds, of elements of different length, and rollers beside, under and through it.
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

Vec3 velocity_at(const Passage& passage, const ClosestPoint& at) {
  const HermiteValues n = hermite(at.xi, passage.length[static_cast<std::size_t>(at.element)]);
  return Eigen::Map<const Eigen::Matrix<double, 3, 4>>(passage.v.data() + 6 * at.element) * n.value;
}

class roller_kernel : public ::testing::TestWithParam<Isa> {};

TEST_P(roller_kernel, sees_every_roller_where_the_search_one_by_one_finds_it) {
  if (GetParam() > best_isa()) GTEST_SKIP() << "this machine has no such registers";
  const Passage passage;
  std::vector<RollerLook> looks;
  std::vector<ClosestPoint> found;
  for (const PlacedRoller& roller : passage.rollers) {
    found.push_back(closest_point(roller, passage.q.data(), passage.length.data(), 0, passage.elements()));
    ASSERT_TRUE(found.back().found);
    looks.push_back({roller.center.data(), roller.axis.data(), roller.normal.data(), roller.half_face,
                     std::clamp(found.back().xi + 0.1, 0.0, 1.0), found.back().element});
  }
  std::vector<RollerMeeting> meetings(looks.size());
  meet_rollers(passage.line(), looks, meetings, GetParam());
  int beyond = 0, within = 0, elsewhere = 0;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const ClosestPoint& at = found[i];
    const RollerMeeting& seen = meetings[i];
    if (!seen.found) {
      ++elsewhere;  // closest to the axis in one element, to its end in another
      EXPECT_TRUE(at.beyond_face);
      continue;
    }
    const RollerDistance distance = roller_distance(passage.rollers[i], at);
    ++(at.beyond_face ? beyond : within);
    ASSERT_EQ(seen.element, at.element);
    EXPECT_EQ(seen.beyond_face, at.beyond_face);
    EXPECT_NEAR(seen.xi, at.xi, 1e-8);
    EXPECT_NEAR(seen.off_end, at.off_end, 1e-8);
    EXPECT_NEAR(seen.distance, distance.value, 1e-10);
    EXPECT_LT((Map(seen.place) - at.place).norm(), 1e-7);
    EXPECT_LT((Map(seen.tangent) - at.tangent).norm(), 1e-7);
    EXPECT_LT((Map(seen.reference) - at.reference).norm(), 1e-13);
    EXPECT_LT((Map(seen.direction) - distance.direction).norm(), 1e-6);
    EXPECT_LT((Map(seen.velocity) - velocity_at(passage, at)).norm(), 1e-7);
    const HermiteValues n = hermite(at.xi, passage.length[static_cast<std::size_t>(at.element)]);
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(seen.shape[j], n.value(j), 1e-7);
  }
  EXPECT_GT(within, 100);
  EXPECT_GT(beyond, 50);
  EXPECT_LT(elsewhere, 30);
}

TEST_P(roller_kernel, finds_nothing_in_an_element_that_does_not_pass_the_roller) {
  if (GetParam() > best_isa()) GTEST_SKIP() << "this machine has no such registers";
  const Passage passage;
  std::vector<RollerLook> looks;
  for (const PlacedRoller& roller : passage.rollers) {
    const ClosestPoint at = closest_point(roller, passage.q.data(), passage.length.data(), 0, passage.elements());
    const int wrong = at.element >= 5 ? at.element - 5 : at.element + 5;
    looks.push_back({roller.center.data(), roller.axis.data(), roller.normal.data(), roller.half_face, 0.5, wrong});
  }
  std::vector<RollerMeeting> meetings(looks.size());
  meet_rollers(passage.line(), looks, meetings, GetParam());
  for (const RollerMeeting& seen : meetings) EXPECT_FALSE(seen.found);
}

INSTANTIATE_TEST_SUITE_P(every_instruction_set, roller_kernel,
                         ::testing::Values(Isa::baseline, Isa::avx2, Isa::avx512));

}  // namespace
}  // namespace overbend
