/// Clumps and buoys: exact derivatives, the equilibria that they must have, energies that belong to the forces.
#include "system/line_points.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace overbend {
namespace {

LinePointDescription make_buoy(double net, double mass, double tether = 0.0) {
  LinePointDescription d;
  d.kind = PointKind::buoy;
  d.mass = mass;
  d.net_force = net;
  d.drag_area = 3.0;
  d.added_mass = 0.6 * mass;
  d.tether = tether;
  return d;
}

LinePointDescription make_clump(double net, double mass, double tether = 0.0) {
  LinePointDescription d = make_buoy(net, mass, tether);
  d.kind = PointKind::clump;
  return d;
}

/// A current, a bed of 89 m, moving water, a node that moves.
struct Setting {
  Model model;
  LineEnvironment env;
  std::vector<double> water;
  Vec3 v = Vec3(0.7, -0.4, -0.5), acc = Vec3(0.3, 0.9, -0.2);
  double velocity_share = 7.0, acceleration_share = 30.0;

  Setting() : model(build_model(described())) {
    env = line_environment(model, LayRoute(Vec3::Zero(), -Vec3::UnitX()));
    env.bed_offset = -89.0;
    water = {0.4, -0.2, 0.3, 0.5, 0.1, -0.6, 0.8, 0.1};
  }
  static Description described() {
    Description d = testing::plain_description();
    d.environment.current = {{0.0, 1.0, 0.3}, {20.0, 0.7, 1.0}, {89.0, 0.3, 2.0}};
    return d;
  }

  Vec3 force(const LinePoint& point, const Vec3& r, const Vec3& moved, BlockTridiagonal* tangent) const {
    std::vector<double> q(6, 0.0), speed(6, 0.0), a(6, 0.0), residual(6, 0.0);
    for (int i = 0; i < 3; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      q[k] = r(i) + moved(i);
      speed[k] = v(i) + velocity_share * moved(i);
      a[k] = acc(i) + acceleration_share * moved(i);
    }
    LineMotion motion;
    motion.v = speed.data();
    motion.acc = a.data();
    motion.velocity_share = velocity_share;
    motion.acceleration_share = acceleration_share;
    motion.water = water.data();
    add_point_forces({&point, 1}, env, q.data(), motion, residual.data(), tangent);
    return Vec3(residual[0], residual[1], residual[2]);
  }
};

struct Place {
  const char* name;
  LinePointDescription point;
  double z;
};

class line_points : public ::testing::TestWithParam<Place> {};

TEST_P(line_points, tangent_is_the_total_derivative_of_the_force) {
  const Setting s;
  const LinePoint point = line_point(s.model, GetParam().point, 0);
  const Vec3 r(1.0, 2.0, GetParam().z);
  BlockTridiagonal tangent(1);
  tangent.set_zero();
  const Vec3 force = s.force(point, r, Vec3::Zero(), &tangent);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 3; ++k) {
    const Vec3 slope =
        (s.force(point, r, kStep * Vec3::Unit(k), nullptr) - s.force(point, r, -kStep * Vec3::Unit(k), nullptr)) /
        (2.0 * kStep);
    for (int i = 0; i < 3; ++i) {
      // Rounding of forces of 1e5 N over 1e-6 m, and the curvature of forces that turn within centimetres.
      EXPECT_NEAR(tangent.diag(0)[i * kRowWidth + k], slope(i), 1e-6 * slope.norm() + 1e-7 * force.norm() + 2e-4)
          << i << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(from_surface_to_bed, line_points,
                         ::testing::Values(Place{"deep", make_buoy(50e3, 1e3), -40.0},
                                           Place{"at the surface", make_buoy(50e3, 1e3), 1.0},
                                           Place{"in the air", make_buoy(50e3, 1e3), 9.0},
                                           Place{"on a tether", make_buoy(50e3, 1e3, 20.0), -40.0},
                                           Place{"afloat on its tether", make_buoy(50e3, 2e3, 20.0), -18.3},
                                           Place{"a clump", make_clump(-50e3, 6e3), -40.0},
                                           Place{"a clump on the bed", make_clump(-50e3, 6e3), -89.004},
                                           Place{"a hung clump", make_clump(-50e3, 6e3, 10.0), -60.0},
                                           Place{"a hung clump that lies", make_clump(-50e3, 6e3, 10.0), -79.0045}));

TEST(line_point, under_water_pulls_with_its_net_force_and_in_air_with_its_weight) {
  const Model model = build_model(testing::plain_description());
  for (const LinePointDescription& d : {make_buoy(50e3, 1e3), make_clump(-50e3, 6e3)}) {
    const LinePoint point = line_point(model, d, 0);
    for (const double z : {-30.0, 30.0}) {
      std::vector<double> q{0.0, 0.0, z, 1.0, 0.0, 0.0}, residual(6, 0.0);
      add_point_forces({&point, 1}, LineEnvironment{}, q.data(), {}, residual.data(), nullptr);
      EXPECT_NEAR(-residual[2], z < 0.0 ? d.net_force : -d.mass * kGravity, 1e-9 * 6e4);
    }
  }
}

TEST(line_point, without_mass_weighs_what_its_net_force_asks_for) {
  const Model model = build_model(testing::plain_description());
  EXPECT_DOUBLE_EQ(line_point(model, make_clump(-9806.65, 0.0), 0).mass, 1000.0);
  EXPECT_DOUBLE_EQ(line_point(model, make_buoy(9806.65, 0.0), 0).mass, 0.0);
}

TEST(line_point, sphere_has_lost_half_its_buoyancy_with_its_middle_in_the_surface) {
  EXPECT_DOUBLE_EQ(point_wetting(BuoyShape::sphere, 2.0, 0.0).share, 0.5);
  // Cap of height h of a sphere of radius a: pi h^2 (3 a - h)/3 of 4/3 pi a^3.
  EXPECT_NEAR(point_wetting(BuoyShape::sphere, 2.0, 1.0).share, 1.0 * (6.0 - 1.0) / (4.0 * 8.0), 1e-15);
  EXPECT_DOUBLE_EQ(point_wetting(BuoyShape::cylinder, 2.0, 1.0).share, 0.25);
}

TEST(line_point, on_a_slack_tether_leaves_the_line_alone) {
  const Model model = build_model(testing::plain_description());
  LineEnvironment env;
  env.bed_offset = -89.0;
  const auto pull = [&](const LinePointDescription& d, double z) {
    const LinePoint point = line_point(model, d, 0);
    std::vector<double> q{0.0, 0.0, z, 1.0, 0.0, 0.0}, residual(6, 0.0);
    add_point_forces({&point, 1}, env, q.data(), {}, residual.data(), nullptr);
    return -residual[2];
  };
  EXPECT_NEAR(pull(make_buoy(50e3, 1e3, 20.0), -40.0), 50e3, 1e-6);
  EXPECT_EQ(pull(make_buoy(50e3, 1e3, 20.0), -10.0), 0.0);
  EXPECT_NEAR(pull(make_clump(-50e3, 6e3, 10.0), -60.0), -50e3, 1e-6);
  EXPECT_EQ(pull(make_clump(-50e3, 6e3, 10.0), -80.0), 0.0);
}

TEST(line_point, energy_changes_by_the_power_of_what_is_not_stored) {
  const Setting s;
  for (const LinePointDescription& d : {make_buoy(50e3, 1e3), make_clump(-50e3, 6e3)}) {
    const LinePoint point = line_point(s.model, d, 0);
    for (const double z : {0.5, -40.0, -89.003}) {
      // A free node: all forces on the point sum to its momentum's change, so that residual . v = 0 at this
      // acceleration.
      Setting free = s;
      const Vec3 r(1.0, 2.0, z);
      const Vec3 point_force = free.force(point, r, Vec3::Zero(), nullptr);
      Setting more = s;
      more.acc += Vec3::UnitX();
      const double inertia = more.force(point, r, Vec3::Zero(), nullptr).x() - point_force.x();
      free.acc -= point_force / inertia;
      ASSERT_LT(free.force(point, r, Vec3::Zero(), nullptr).norm(), 1e-6 * point_force.norm());
      const auto energy = [&](double t) {
        std::vector<double> q(6, 0.0), v(6, 0.0), a(6, 0.0);
        for (int i = 0; i < 3; ++i) {
          const std::size_t k = static_cast<std::size_t>(i);
          q[k] = r(i) + t * free.v(i);
          v[k] = free.v(i) + t * free.acc(i);
          a[k] = free.acc(i);
        }
        LineMotion motion;
        motion.v = v.data();
        motion.acc = a.data();
        motion.water = free.water.data();
        LineEnergy sum;
        add_point_energy({&point, 1}, free.env, q.data(), motion, sum);
        return sum;
      };
      constexpr double kStep = 1e-5;
      const LineEnergy line_energy = energy(0.0), after = energy(kStep), before = energy(-kStep);
      const auto stored = [](const LineEnergy& e) { return e.kinetic + e.gravity + e.seabed; };
      const double power = (stored(after) - stored(before)) / (2.0 * kStep);
      EXPECT_NEAR(power, line_energy.fluid_power - line_energy.seabed_loss, 1e-5 * (std::abs(power) + 1e4)) << z;
    }
  }
}

}  // namespace
}  // namespace overbend
