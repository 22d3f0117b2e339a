/// The line kernel in motion: exact derivatives, energies that belong to the forces.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mechanics/quadrature.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

/// Height of the line, and what it may meet there.
struct Place {
  double z = 0.0;
  bool uneven = false;
  SoilModel soil = SoilModel::linear;
};

using testing::dense;

/// A soft line in waves and current, moving at random; velocities and accelerations follow the unknowns like those of
/// an integrator.
struct MovingSetting {
  Model model;
  LineElements elements;
  LineEnvironment env;
  std::vector<double> q, v, acc, water, slip;
  double velocity_share = 7.0, acceleration_share = 30.0, step = 0.05;
  int nodes = 12;
};

std::vector<double> random_values(std::size_t n, double size, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::vector<double> values(n);
  for (double& value : values) {
    value = size * (2.0 * static_cast<double>(generator() >> 11) * 0x1.0p-53 - 1.0);
  }
  return values;
}

MovingSetting setting(const Place& place) {
  Description d = testing::plain_description();
  d.environment.seabed.slope = 0.05;
  if (place.uneven) d.environment.seabed.bathymetry = testing::hummocks();
  d.environment.seabed.soil = place.soil;
  d.environment.seabed.bearing_force = 40e3;
  d.environment.seabed.slope_towards = 1.0;
  d.environment.seabed.friction_lateral = 0.5;
  d.environment.seabed.friction_axial = 0.3;
  d.environment.seabed.damping = 2e3;
  d.environment.current = {{0.0, 1.0, 0.3}, {20.0, 0.7, 1.0}, {89.0, 0.3, 2.0}};
  d.pipe.section.steel.youngs_modulus = 2e4;  // a soft pipe, so that rounding of stiff terms does not hide the loads
  d.pipe.section.hydrodynamics.drag_axial = 0.1;
  d.pipe.section.hydrodynamics.added_mass_axial = 0.2;
  MovingSetting s{build_model(d), {}, {}, {}, {}, {}, {}, {}};
  std::vector<double> lengths;
  for (int i = 0; i + 1 < s.nodes; ++i) {
    lengths.push_back(1.0 + 0.05 * i);
  }
  s.elements = line_elements(s.model, lengths, std::vector<int>(lengths.size(), 0));
  s.env = line_environment(s.model, LayRoute(Vec3(0.0, 0.01, 0.0), -Vec3::UnitX()));
  s.q = testing::wavy_line(s.nodes, 1.1, Vec3(0.0, 0.0, place.z), 5);
  s.v = random_values(s.q.size(), 1.5, 1);
  s.acc = random_values(s.q.size(), 2.0, 2);
  s.water = random_values(static_cast<std::size_t>(kWaterValues * s.nodes), 1.0, 3);
  s.slip = random_values(static_cast<std::size_t>(kGaussPoints * kBedDirections) * s.elements.padded(), 0.05, 4);
  return s;
}

/// With the unknowns moved by `dq`, velocities and accelerations following.
std::vector<double> residual(const MovingSetting& s, const std::vector<double>& dq, BlockTridiagonal* tangent,
                             Isa isa = best_isa()) {
  std::vector<double> q = s.q, v = s.v, acc = s.acc;
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] += dq[i];
    v[i] += s.velocity_share * dq[i];
    acc[i] += s.acceleration_share * dq[i];
  }
  AlignedDoubles slip(s.slip.begin(), s.slip.end()), next(s.slip.size());
  LineMotion motion{v.data(), acc.data(),     s.velocity_share, s.acceleration_share,
                    s.step,   s.water.data(), slip.data(),      next.data()};
  std::vector<double> r(q.size(), 0.0);
  LineTarget target{r.data(), nullptr, nullptr, nullptr};
  if (tangent != nullptr) {
    target = {r.data(), tangent->diag(0), tangent->upper(0), tangent->lower(0)};
  }
  add_line_forces(s.elements, s.env, {q.data(), nullptr}, motion, target, isa);
  return r;
}

class moving_line : public ::testing::TestWithParam<Place> {};

TEST_P(moving_line, tangent_is_the_total_derivative_of_the_force) {
  const MovingSetting s = setting(GetParam());
  const std::vector<double> zero(s.q.size(), 0.0);
  BlockTridiagonal tangent(s.nodes);
  residual(s, zero, &tangent);
  const Eigen::MatrixXd exact = dense(tangent);
  const double step = 1e-6;
  for (int j = 0; j < exact.cols(); ++j) {
    std::vector<double> up = zero, down = zero;
    up[static_cast<std::size_t>(j)] = step;
    down[static_cast<std::size_t>(j)] = -step;
    const std::vector<double> r1 = residual(s, up, nullptr);
    const std::vector<double> r0 = residual(s, down, nullptr);
    for (int i = 0; i < exact.rows(); ++i) {
      const double difference = (r1[static_cast<std::size_t>(i)] - r0[static_cast<std::size_t>(i)]) / (2.0 * step);
      // Central difference of forces up to 1e5 N that carry 1e-11 N of rounding, over 1e-6.
      ASSERT_NEAR(exact(i, j), difference, 1e-6 * std::abs(exact(i, j)) + 2e-3) << i << " " << j;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(from_air_to_seabed, moving_line,
                         ::testing::Values(Place{3.0}, Place{-1.2}, Place{-30.0}, Place{-90.0}, Place{-90.0, true},
                                           Place{-90.0, true, SoilModel::hyperbolic},
                                           Place{-90.0, false, SoilModel::bilinear}));

TEST(moving_line_kernel, at_rest_in_calm_water_gives_the_static_forces) {
  MovingSetting s = setting({-5.0});
  s.v.assign(s.v.size(), 0.0);
  s.acc.assign(s.acc.size(), 0.0);
  s.water.assign(s.water.size(), 0.0);
  const std::vector<double> moving = residual(s, s.v, nullptr);
  std::vector<double> at_rest(s.q.size(), 0.0);
  add_line_forces(s.elements, s.env, {s.q.data(), nullptr}, {at_rest.data(), nullptr, nullptr, nullptr}, best_isa());
  for (std::size_t i = 0; i < at_rest.size(); ++i) {
    EXPECT_NEAR(moving[i], at_rest[i], 1e-9);  // rounding of forces of 1e4 N
  }
}

TEST(moving_line_kernel, gives_the_same_on_every_instruction_set) {
  const MovingSetting s = setting({-90.0});
  const std::vector<double> zero(s.q.size(), 0.0);
  const std::vector<double> expected = residual(s, zero, nullptr, Isa::baseline);
  for (const Isa isa : {Isa::avx2, Isa::avx512}) {
    if (isa > best_isa()) {
      continue;
    }
    const std::vector<double> got = residual(s, zero, nullptr, isa);
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_NEAR(got[i], expected[i], 1e-8);  // rounding of fused multiply-adds, forces of 1e5 N
    }
  }
}

/// Along a path q + t v + t^2 acc / 2 the work of all forces is the change of all energies: the rate of energy from
/// the kernel's sums equals the power of its forces.
TEST_P(moving_line, energies_change_at_the_power_of_the_forces) {
  const MovingSetting s = setting(GetParam());
  const double dt = 1e-5;
  const auto energy_at = [&](double t) {
    std::vector<double> q = s.q, v = s.v;
    for (std::size_t i = 0; i < q.size(); ++i) {
      q[i] += t * s.v[i] + 0.5 * t * t * s.acc[i];
      v[i] += t * s.acc[i];
    }
    AlignedDoubles slip(s.slip.begin(), s.slip.end());
    LineMotion motion{v.data(), s.acc.data(), 0.0, 0.0, 0.0, s.water.data(), slip.data(), nullptr};
    return line_energy(s.elements, s.env, {q.data(), nullptr}, motion, best_isa());
  };
  const auto stored = [](const LineEnergy& e) { return e.kinetic + e.strain + e.gravity + e.seabed; };
  const double rate = (stored(energy_at(dt)) - stored(energy_at(-dt))) / (2.0 * dt);
  const LineEnergy present = energy_at(0.0);

  // Residual = inertia + internal - external; its power is what is stored and lost minus what the water does. The
  // stretch that the energy sees is the one after the step's return mapping, so the step is 0 here.
  AlignedDoubles slip(s.slip.begin(), s.slip.end()), next(s.slip.size());
  LineMotion motion{s.v.data(), s.acc.data(), 0.0, 0.0, 0.0, s.water.data(), slip.data(), next.data()};
  std::vector<double> r(s.q.size(), 0.0);
  add_line_forces(s.elements, s.env, {s.q.data(), nullptr}, motion, {r.data(), nullptr, nullptr, nullptr}, best_isa());
  motion.bed_slip = next.data();
  const LineEnergy mapped = line_energy(s.elements, s.env, {s.q.data(), nullptr}, motion, best_isa());
  double power = 0.0, size = 0.0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    power += r[i] * s.v[i];
    size += std::abs(r[i] * s.v[i]);
  }
  EXPECT_NEAR(power, rate + mapped.seabed_loss - present.fluid_power, 1e-7 * size);  // difference over 1e-5 s
}

}  // namespace
}  // namespace overbend
