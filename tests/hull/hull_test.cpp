#include "hull/hull.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "support/allocation_count.h"
#include "support/hull_case.h"

namespace overbend {
namespace {

/// Everything that can act, in a sea.
Hull burdened() {
  Hull hull = testing::bgl1_in(testing::long_crested(3.0, 9.0, 1.2, 5), WaveDrift::newman);
  hull.drift_damping = wave_drift_damping(testing::bgl1_hydrodynamics(), testing::long_crested(3.0, 9.0, 1.2, 5), 0.0);
  hull.current.form = HullCurrentModel::strips;
  hull.current.velocity = {0.5, 0.8};
  hull.current.length = 120.0;
  hull.current.beam = 30.0;
  hull.current.draught = 5.182;
  hull.current.reference_V = hull.reference_V;
  hull.current.transverse = 0.8;
  hull.current.longitudinal = 0.5;
  hull.current.wetted_surface = 5155.0;
  hull.munk = 2e7;
  hull.wind.velocity = {9.0, -7.0};
  hull.wind.areas = {{"side", 500.0, Vec3(12.0, 0.0, 6.0), 1.0, 1.0, false},
                     {"front", 200.0, Vec3::Zero(), 1.0, 1.0, true}};
  hull.damping.quadratic << 1e4, 2e4, 3e4, 4e8, 5e8, 6e8;
  hull.ballast << 0.0, 0.0, 1e6, 2e6, 3e6, 0.0;
  hull.loads = {{Vec3(-57.0, 4.0, 3.0), Vec3(2e5, -3e5, 4e5), Vec3(1e6, 2e6, -3e6)}};
  hull.station_keeping = StationKeeping{Vec3(3.0, -4.0, 0.1), {Vec3(2e5, 3e5, 5e8), Vec3(1e6, 2e6, 3e9)}};
  return hull;
}

HullState moving() {
  HullState s = make_static_hull(burdened(), (Vec6() << 2.0, -3.0, 1.2, 0.06, -0.03, 7.1).finished());
  s.v << 0.4, -0.5, 0.3, 0.03, 0.02, 0.012;
  s.acc << 0.1, 0.2, -0.3, 0.01, -0.02, 0.005;
  s.slow.value += Vec3(0.5, -0.4, 0.02);
  s.slow.rate << 0.2, 0.1, 0.004;
  return s;
}

TEST(hull, tangent_agrees_with_differences) {
  const Hull hull = burdened();
  const HullState before = moving();
  HullState hull_state = before;
  const double step = 0.02;
  hull_state.h += step * before.v;
  const HullWeights weights{1.0, 150.0, 2.4e4};
  HullBalance exact, a, b;
  balance_hull(hull, hull_state, before, step, weights, 30.0, exact);
  const Vec6 scale = (Vec6() << 1.0, 1.0, 1.0, 1.0, 1.0, 1.0).finished() * 1e-6;
  double max_value = exact.tangent.cwiseAbs().maxCoeff();
  for (int k = 0; k < 6; ++k) {
    const Vec6 e = scale(k) * Vec6::Unit(k);
    HullState ahead = hull_state, behind = hull_state;
    ahead.h += e;
    ahead.v += weights.damping * e;
    ahead.acc += weights.mass * e;
    behind.h -= e;
    behind.v -= weights.damping * e;
    behind.acc -= weights.mass * e;
    balance_hull(hull, ahead, before, step, weights, 30.0, a);
    balance_hull(hull, behind, before, step, weights, 30.0, b);
    const Vec6 slope = (a.residual - b.residual) / (2.0 * scale(k));
    EXPECT_LT((exact.tangent.col(k) - slope).cwiseAbs().maxCoeff(), 1e-10 * max_value) << k;
  }
}

/// Coefficients of a table are of steady flow: a hull that follows the waves is not damped by them.
TEST(hull, current_by_a_table_flows_past_the_slow_hull) {
  Hull by_table = burdened(), without = by_table;
  by_table.current.form = HullCurrentModel::table;
  by_table.current.table = {155.0, 620.0, 120.0, {}};
  for (int i = 0; i < 12; ++i) {
    const double a = 30.0 * i * kDegree;
    by_table.current.table.rows.push_back({a, 0.7 * std::cos(a), 0.9 * std::sin(a), 0.1 * std::sin(2.0 * a)});
  }
  without.current.form = HullCurrentModel::none;
  const HullState before = moving();
  HullState hull_state = before;
  hull_state.h += 0.1 * before.v;
  const auto current = [&](const HullState& to, const HullState& from) {
    HullBalance a, b;
    balance_hull(by_table, to, from, 0.1, {1.0, 20.0, 400.0}, 30.0, a);
    balance_hull(without, to, from, 0.1, {1.0, 20.0, 400.0}, 30.0, b);
    return Vec6(a.residual - b.residual);
  };
  HullState faster = hull_state;
  faster.v *= 3.0;
  const Vec6 slow = current(hull_state, before);
  EXPECT_GT(slow.norm(), 1e4);
  EXPECT_LT((current(faster, before) - slow).norm(), 1e-6 * slow.norm());
  HullState drifting = before;
  drifting.slow.rate *= 3.0;
  EXPECT_GT((current(hull_state, drifting) - slow).norm(), 1e-2 * slow.norm());
}

TEST(hull, what_surrounds_it_is_found_once_in_a_step) {
  const Hull hull = burdened();
  const HullState before = moving();
  HullState first = before, second = before;
  first.h += 0.1 * before.v;
  second.h = first.h + (Vec6() << 0.02, -0.01, 0.03, 0.002, 0.001, 1e-3).finished();
  second.v *= 1.5;
  HullBalance of_step, alone;
  balance_hull(hull, first, before, 0.1, {1.0, 20.0, 400.0}, 30.0, of_step);
  balance_hull(hull, second, before, 0.1, {1.0, 20.0, 400.0}, 30.0, of_step);
  balance_hull(hull, second, before, 0.1, {1.0, 20.0, 400.0}, 30.0, alone);
  EXPECT_EQ(of_step.residual, alone.residual);
  EXPECT_EQ(of_step.tangent, alone.tangent);
  // The sea of another instant is another, once the step is said to be over.
  balance_hull(hull, second, before, 0.1, {1.0, 20.0, 400.0}, 31.0, alone);
  EXPECT_EQ(of_step.residual, alone.residual);
  alone.surroundings.reset();
  balance_hull(hull, second, before, 0.1, {1.0, 20.0, 400.0}, 31.0, alone);
  EXPECT_GT((of_step.residual - alone.residual).norm(), 1e-3 * alone.residual.norm());
}

TEST(hull, tangent_at_rest_includes_what_follows_its_heading) {
  Hull hull = burdened();
  hull.mean_drift_from_start = true;
  const HullState start = make_static_hull(hull, (Vec6() << 2.0, -3.0, 1.2, 0.06, -0.03, 7.1).finished());
  HullBalance exact, a, b;
  balance_hull(hull, start, start, 0.0, {}, kBeforeWaves, exact);
  for (int k = 0; k < 6; ++k) {
    HullState ahead = start, behind = start;
    ahead.h(k) += 1e-6;
    behind.h(k) -= 1e-6;
    balance_hull(hull, ahead, start, 0.0, {}, kBeforeWaves, a);
    balance_hull(hull, behind, start, 0.0, {}, kBeforeWaves, b);
    const Vec6 slope = (a.residual - b.residual) / 2e-6;
    EXPECT_LT((exact.tangent.col(k) - slope).norm(), 1e-6 * hull.hydrostatics.norm()) << k;
  }
}

TEST(hull, mean_drift_acts_before_the_waves_only_where_it_is_asked_for) {
  Hull hull = testing::bgl1_in(testing::long_crested(4.0, 12.9, 0.5 * kPi, 1), WaveDrift::newman);
  hull.build_up = 100.0;
  const HullState rest = make_static_hull(hull, hull.drawn);
  HullBalance out;
  balance_hull(hull, rest, rest, 0.0, {}, kBeforeWaves, out);
  EXPECT_EQ(out.residual.norm(), 0.0);
  hull.mean_drift_from_start = true;
  balance_hull(hull, rest, rest, 0.0, {}, kBeforeWaves, out);
  EXPECT_NEAR(-out.residual(1), 218e3, 4e3);
  // Half way through the build-up half of what varies is there.
  HullBalance half, whole;
  const HullWeights moving{1.0, 1.0, 1.0};
  balance_hull(hull, rest, rest, 0.0, moving, -50.0, half);
  const WaveForce f = wave_force(hull.waves, -50.0, rest.slow.value);
  EXPECT_NEAR(-half.residual(1), f.mean_drift(1) + 0.5 * (f.drift(1) - f.mean_drift(1) + f.first_order(1)), 1.0);
}

TEST(hull, steady_forces_are_current_with_munks_moment_and_the_drift_that_is_asked_for) {
  Hull hull = testing::bgl1_in(testing::long_crested(4.0, 12.9, 0.5 * kPi, 1), WaveDrift::newman);
  hull.current.form = HullCurrentModel::strips;
  hull.current.velocity = {0.7, 0.7};  // towards the port bow of a hull that heads east
  hull.current.length = 120.0;
  hull.current.draught = 5.182;
  hull.current.transverse = 0.8;
  const SteadyForces at_rest = steady_forces(hull, 0.0);
  EXPECT_EQ(at_rest.drift.norm(), 0.0);
  EXPECT_EQ(at_rest.wind.norm(), 0.0);
  hull.munk = 6.9e6;
  hull.mean_drift_from_start = true;
  const SteadyForces forces = steady_forces(hull, 0.0);
  EXPECT_EQ(forces.drift, mean_drift(hull.waves, 0.0));
  // The flow turns the hull across itself: bow to starboard.
  EXPECT_NEAR(forces.current(5) - at_rest.current(5), -6.9e6 * 0.49, 1.0);
  HullBalance out;
  const HullState rest = make_static_hull(hull, hull.drawn);
  balance_hull(hull, rest, rest, 0.0, {}, kBeforeWaves, out);
  EXPECT_LT((forces.sum() + out.residual).norm(), 1e-6 * forces.sum().norm());
}

TEST(hull, answer_turns_with_the_world) {
  // Hull, waves, current, wind and loads turned by an angle: the same forces, turned.
  const double angle = 217.0 * kPi / 180.0;
  Hull hull = burdened(), turned = hull;
  hull.waves = make_hull_waves(testing::bgl1_hydrodynamics(), testing::regular_sea(1.0, 0.83, 1.2, 0.3),
                               WaveDrift::newman, 5.182, 0.0);
  turned.waves = make_hull_waves(testing::bgl1_hydrodynamics(), testing::regular_sea(1.0, 0.83, 1.2 + angle, 0.3),
                                 WaveDrift::newman, 5.182, angle);
  const Mat3 R = turned_about_z(angle);
  const auto turn = [&](const Vec6& a) -> Vec6 {
    Vec6 b = a;
    b.head<3>() = R * a.head<3>().eval();
    return b;
  };
  turned.drawn = turn(hull.drawn) + angle * Vec6::Unit(5);
  turned.current.velocity = (R * Vec3(0.5, 0.8, 0.0)).head<2>();
  turned.wind.velocity = (R * Vec3(9.0, -7.0, 0.0)).head<2>();
  turned.loads[0].force_W = R * hull.loads[0].force_W;
  turned.loads[0].moment_W = R * hull.loads[0].moment_W;
  turned.station_keeping->wanted = R * Vec3(3.0, -4.0, 0.0) + Vec3(0.0, 0.0, 0.1 + angle);
  const HullState state = moving();
  HullState second_hull_state = state;
  second_hull_state.h = turn(state.h) + angle * Vec6::Unit(5);
  second_hull_state.v = turn(state.v);
  second_hull_state.acc = turn(state.acc);
  second_hull_state.slow.value =
      R * Vec3(state.slow.value.x(), state.slow.value.y(), 0.0) + Vec3(0, 0, state.slow.value.z() + angle);
  second_hull_state.slow.rate = R * state.slow.rate;
  HullBalance a, b;
  balance_hull(hull, state, state, 0.0, {1.0, 50.0, 2500.0}, 12.0, a);
  balance_hull(turned, second_hull_state, second_hull_state, 0.0, {1.0, 50.0, 2500.0}, 12.0, b);
  EXPECT_LT((turn(a.residual) - b.residual).norm(), 1e-9 * a.residual.norm());
}

TEST(hull, steps_do_not_allocate_and_resume_bit_for_bit) {
  const Hull hull = burdened();
  const GeneralizedAlpha scheme(0.8);
  HullSprings springs;
  springs.stiffness.diagonal() << 2e5, 2e5, 0.0, 0.0, 0.0, 5e8;
  HullState state = make_static_hull(hull, hull.drawn), scratch = state;
  find_hull_acceleration(hull, springs, 0.0, state);
  for (int i = 1; i <= 20; ++i) ASSERT_TRUE(hull_step(hull, springs, scheme, 0.1 * i, 0.1, state, scratch).converged);
  HullState copy = state;
  const long before = testing::allocation_count();
  for (int i = 21; i <= 40; ++i) hull_step(hull, springs, scheme, 0.1 * i, 0.1, state, scratch);
  EXPECT_EQ(testing::allocation_count(), before);
  HullState second_hull_state = make_static_hull(hull, Vec6::Zero());
  for (int i = 21; i <= 40; ++i) hull_step(hull, springs, scheme, 0.1 * i, 0.1, copy, second_hull_state);
  EXPECT_EQ(copy.h, state.h);
  EXPECT_EQ(copy.v, state.v);
  EXPECT_EQ(copy.radiation.values, state.radiation.values);
  EXPECT_EQ(copy.slow.value, state.slow.value);
}

}  // namespace
}  // namespace overbend
