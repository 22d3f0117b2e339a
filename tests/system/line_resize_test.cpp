#include "system/line_resize.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/simd.h"
#include "dynamics/integrator/time_step.h"
#include "mechanics/quadrature.h"
#include "support/moving_rod.h"

namespace overbend {
namespace {

using testing::first_end;
using testing::first_rod;
using testing::hold;
using testing::last_end;
using testing::rod_system;

constexpr double kEA = 5e6, kEI = 2e4, kMass = 50.0;

System pendulum(int elements = 10) {
  System system = rod_system({.EA = kEA, .EI = kEI, .mass = kMass, .weight = kMass * kGravity}, 20.0, elements);
  hold(last_end(system), true, false);
  last_end(system).place = Vec3(0.0, 0.0, 30.0);
  return system;
}

/// A smooth bent shape in motion, by functions of the arc length.
LineState swinging(const System& system) {
  std::vector<double> q;
  for (const double s : first_rod(system).mesh.s) {
    q.insert(q.end(), {s - 20.0, 1.5 * std::sin(0.2 * s), 30.0 + 0.01 * s * s, 1.0, 0.3 * std::cos(0.2 * s), 0.02 * s});
  }
  LineState state = state_at_rest(system, {q}, 0.0).lines.front();
  for (std::size_t i = 0; i < q.size(); ++i) {
    state.v[i] = std::sin(0.7 * static_cast<double>(i));
    state.acc[i] = std::cos(0.3 * static_cast<double>(i));
    state.algorithmic_acceleration[i] = std::cos(0.4 * static_cast<double>(i));
  }
  return state;
}

LineEnergy compute_line_energy(const Line& line, const LineState& state) {
  LineMotion motion;
  motion.v = state.v.data();
  motion.acc = state.acc.data();
  motion.bed_slip = state.bed_slip.data();
  return line_energy(line.elements, line.environment, {state.q.data(), nullptr}, motion, best_isa());
}

double compute_line_mass(const Line& line) {
  double mass = 0.0;
  for (std::size_t e = 0; e < line.mesh.length.size(); ++e) mass += line.elements.mass[e] * line.elements.length[e];
  return mass;
}

TEST(line_resize, a_split_keeps_shape_mass_and_motion) {
  System system = pendulum();
  Line& line = first_rod(system);
  LineState state = swinging(system);
  const LineState old = state;
  const Line old_line = line;
  const LineEnergy before = compute_line_energy(line, state);
  split_element(line, state, 4, 0.3);
  EXPECT_EQ(line.mesh.nodes(), 12);
  EXPECT_EQ(state.q.size(), 72U);
  EXPECT_DOUBLE_EQ(line.mesh.s[5], 8.6);
  EXPECT_DOUBLE_EQ(line.mesh.length[4] + line.mesh.length[5], 2.0);
  EXPECT_DOUBLE_EQ(compute_line_mass(line), kMass * 20.0);
  const LineEnergy after = compute_line_energy(line, state);
  EXPECT_NEAR(after.kinetic, before.kinetic, 1e-12 * before.kinetic);
  EXPECT_NEAR(after.gravity, before.gravity, 1e-12 * before.gravity);
  for (const double share : {0.1, 0.25, 0.6, 0.9}) {  // the shape and every rate, against those of the old element
    const bool lower = share < 0.3;
    const NodeMotion a = motion_within(old_line, old, 4, share);
    const NodeMotion b = motion_within(line, state, lower ? 4 : 5, lower ? share / 0.3 : (share - 0.3) / 0.7);
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(a.q[i], b.q[i], 1e-12);
      EXPECT_NEAR(a.v[i], b.v[i], 1e-12);
      EXPECT_NEAR(a.acc[i], b.acc[i], 1e-12);
      EXPECT_NEAR(a.algorithmic_acceleration[i], b.algorithmic_acceleration[i], 1e-12);
    }
  }
}

/// A bar that moves on through a machine at its upper end at a speed: every point of it has that speed.
TEST(line_resize, material_of_a_fed_element_has_the_speed_of_the_material) {
  constexpr double kSpeed = 0.2, kRamp = 0.03, kStretch = 1e-3;
  System system = rod_system({.EA = kEA, .EI = kEI, .mass = kMass}, 4.0, 2);
  Line& line = first_rod(system);
  LineState state =
      state_at_rest(system, {testing::straight(system, Vec3::Zero(), Vec3::UnitX(), kStretch)}, 0.0).lines[0];
  for (std::size_t node = 0; node < 2; ++node) {  // the last node stays at the machine
    state.v[6 * node] = -kSpeed * (1.0 + kStretch);
    state.acc[6 * node] = state.algorithmic_acceleration[6 * node] = -kRamp * (1.0 + kStretch);
  }
  split_element(line, state, 1, 0.4, {kSpeed, kRamp});
  EXPECT_NEAR(state.v[12], -kSpeed * (1.0 + kStretch), 1e-14);
  EXPECT_NEAR(state.v[15], 0.0, 1e-14);
  EXPECT_NEAR(state.acc[12], -kRamp * (1.0 + kStretch), 1e-14);
  EXPECT_NEAR(state.acc[15], 0.0, 1e-14);
}

TEST(line_resize, merging_undoes_a_split) {
  System system = pendulum();
  Line& line = first_rod(system);
  LineState state = swinging(system);
  for (std::size_t i = 0; i < state.bed_slip.size(); ++i) state.bed_slip[i] = 0.25;
  line.points.resize(1);
  line.points[0].node = 7;
  state.contacts.resize(3);
  state.contacts[0].element = 4;
  state.contacts[0].xi = 0.8;
  state.contacts[1].element = 4;
  state.contacts[1].xi = 0.2;
  state.contacts[2].element = 8;
  const LineState old = state;
  split_element(line, state, 4, 0.5);
  EXPECT_EQ(line.points[0].node, 8);
  EXPECT_EQ(state.contacts[0].element, 5);
  EXPECT_NEAR(state.contacts[0].xi, 0.6, 1e-15);
  EXPECT_EQ(state.contacts[1].element, 4);
  EXPECT_NEAR(state.contacts[1].xi, 0.4, 1e-15);
  EXPECT_EQ(state.contacts[2].element, 9);
  merge_elements(line, state, 5);
  EXPECT_EQ(state.q, old.q);
  EXPECT_EQ(state.v, old.v);
  EXPECT_EQ(state.algorithmic_acceleration, old.algorithmic_acceleration);
  EXPECT_EQ(line.points[0].node, 7);
  EXPECT_EQ(line.mesh.elements(), 10);
  EXPECT_EQ(line.elements.count, 10);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(state.contacts[i].element, old.contacts[i].element);
    EXPECT_NEAR(state.contacts[i].xi, old.contacts[i].xi, 1e-15);
  }
  const std::size_t stride = line.elements.padded();
  for (std::size_t row = 0; row < static_cast<std::size_t>(kGaussPoints * kBedDirections); ++row) {
    EXPECT_DOUBLE_EQ(state.bed_slip[row * stride + 4], 0.25);
    EXPECT_DOUBLE_EQ(state.bed_slip[row * stride + 9], 0.25);
  }
}

TEST(line_resize, an_appended_element_is_of_its_kind_and_leaves_the_others_alone) {
  System system = pendulum(8);  // a full batch: the arrays grow by one
  Line& line = first_rod(system);
  LineState state = swinging(system);
  const LineState old = state;
  ElementKind kind{0, {}, nullptr};
  kind.constants.EA = 7.0;
  kind.constants.mass = 3.0;
  append_element(line, state, node_motion(state, 8), 0.5, kind);
  EXPECT_EQ(line.elements.padded(), 16U);
  EXPECT_EQ(line.elements.EA[8], 7.0);
  EXPECT_EQ(line.elements.EA[9], 0.0);
  EXPECT_EQ(line.elements.length[9], 1.0);
  EXPECT_EQ(line.elements.EA[7], kEA);
  EXPECT_DOUBLE_EQ(line.mesh.s.back(), 20.5);
  EXPECT_DOUBLE_EQ(compute_line_mass(line), 20.0 * kMass + 1.5);
  drop_element(line, state, LineEnd::last);
  EXPECT_EQ(state.q, old.q);
  EXPECT_EQ(state.bed_slip, old.bed_slip);
  EXPECT_EQ(line.mesh.s.back(), 20.0);
  drop_element(line, state, LineEnd::first);
  EXPECT_EQ(line.mesh.s.front(), 2.5);
  EXPECT_EQ(state.q[0], old.q[6]);
}

// In time ---------------------------------------------------------------------------------------------------------

struct Swing {
  double top_force = 0.0, energy = 0.0;
  Vec3 tip = Vec3::Zero();
};

/// A heavy rod hung up by its end, released from a shallow curve; at `split_at` steps an element is split (or not).
Swing swing(int elements, int split_at, int steps) {
  constexpr double kStep = 4e-3;
  System system = pendulum(elements);
  system.surroundings = [&system](double, Surroundings& surroundings) { set_attachment_motions(system, surroundings); };
  first_rod(system).force_scale = kMass * kGravity * 20.0;
  std::vector<double> q;
  for (const double s : first_rod(system).mesh.s) q.insert(q.end(), {s - 20.0, 0.0, 30.0, 1.0, 0.0, 0.0});
  SystemState state = state_at_rest(system, {q}, 0.0), next = state;
  std::optional<Assembly> assembly;
  std::optional<TimeStepper> stepper;
  const auto renew = [&] {
    assembly.emplace(system);
    stepper.emplace(*assembly, StepSettings{0.9, 1e-9, 20});
    assembly->set_time(state.time, state);
  };
  renew();
  for (int i = 0; i <= steps; ++i) {
    if (i == split_at) {
      split_element(first_rod(system), state.lines[0], elements / 2, 0.5);
      renew();
    }
    if (i == steps) break;
    const StepReport report = stepper->step(state, kStep, next);
    EXPECT_TRUE(report.converged());
    state = next;
  }
  SystemState system_state = state;
  assembly->set_time(system_state.time, system_state);
  assembly->evaluate(system_state, state, {}, false);
  const InstantEnergy energy = assembly->energy(state);
  const std::array<double, 6>& force = assembly->line(0).end_force(LineEnd::last);
  return {Vec3(force[0], force[1], force[2]).norm(), energy.line.kinetic + energy.line.strain,
          Vec3(Eigen::Map<const Vec3>(state.lines[0].q.data()))};
}

TEST(line_resize, a_split_in_a_swinging_line_keeps_energy_and_end_force) {
  const Swing before = swing(20, -1, 250), after = swing(20, 250, 250);
  EXPECT_NEAR(after.energy, before.energy, 1e-6 * before.energy);
  EXPECT_NEAR(after.top_force, before.top_force, 1e-6 * before.top_force);
}

TEST(line_resize, a_line_split_in_its_swing_goes_on_as_one_that_was_not) {
  const Swing whole = swing(20, -1, 350), split = swing(20, 150, 350);
  EXPECT_NEAR((split.tip - whole.tip).norm(), 0.0, 2e-3);
  EXPECT_GT((whole.tip - Vec3(-20.0, 0.0, 30.0)).norm(), 5.0);
}

}  // namespace
}  // namespace overbend
