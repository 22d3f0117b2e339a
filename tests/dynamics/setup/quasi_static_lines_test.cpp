#include "dynamics/setup/quasi_static_lines.h"

#include <gtest/gtest.h>

#include <numbers>

#include "dynamics/integrator/dynamic_checkpoint.h"
#include "dynamics/integrator/energy_account.h"
#include "dynamics/integrator/time_step.h"
#include "moorings/bgl1_spread.h"
#include "moorings/move_path.h"
#include "support/allocation_count.h"
#include "support/free_body.h"

namespace overbend {
namespace {

using namespace testing;

constexpr double kStiffness = 1.8479e5;  ///< Stiffness of eight lines at 300 kN [N/m].
constexpr double kPeriod = 66.96;        ///< Period of surge on them [s].

/// The barge in surge alone: a mass that makes the period of surge, a damper, the pull of the pipe.
class SurgingBarge {
 public:
  SurgingBarge(const MooringSpread& spread, const std::vector<LengthTable>& programs, double pull, double damping)
      : assembly_(made(spread, programs, pull, damping)),
        stepper_(assembly_, {1.0, 1e-10, 30}),
        state(state_at_rest(system_, {}, 0.0)) {
    for (const int freedom : {1, 2, 3, 4, 5}) assembly_.hold_body(0, freedom, true);
  }
  SurgingBarge(const SurgingBarge&) = delete;
  SurgingBarge& operator=(const SurgingBarge&) = delete;

  void begin() {
    assembly_.set_time(state.time, state);
    assembly_.impose_ends(state);
    ASSERT_TRUE(assembly_.find_accelerations(state));
    state.bodies[0].algorithmic_acceleration = state.bodies[0].acc;
    const SystemState before = state;
    assembly_.evaluate(state, before, {}, false);
    next_ = state;
    energy.start(assembly_.energy(state), 1.0);
  }
  void step(double h) {
    ASSERT_TRUE(stepper_.step(state, h, next_).converged()) << state.time;
    energy.add(assembly_.energy(next_), h);
    std::swap(state, next_);
  }
  double surge() const { return state.bodies[0].h(0); }
  const std::vector<LineEndForces>& lines() const { return state.bodies[0].lines; }

 private:
  const System& made(const MooringSpread& spread, const std::vector<LengthTable>& programs, double pull,
                     double damping) {
    SpringBody barge;
    barge.body.mass = kStiffness * std::pow(kPeriod / (2.0 * std::numbers::pi), 2);
    barge.body.inertia = 1e10 * Mat3::Identity();
    barge.damping(0) = damping * 2.0 * std::sqrt(kStiffness * barge.body.mass);
    barge.pull(0) = pull;
    system_.bodies.resize(1);
    FreeBody& body = system_.bodies[0].free.emplace(free_body(barge));
    body.springs = quasi_static_lines(spread, programs);
    body.force_scale = force_scale(spread, std::nullopt);
    system_.surroundings = surroundings_at_rest(system_);
    return system_;
  }

  System system_;
  Assembly assembly_;
  TimeStepper stepper_;
  SystemState next_;

 public:
  SystemState state;
  EnergyAccount energy;
};

/// Surge and tensions of a pull-ahead of one joint.
struct Move {
  double overshoot = 0.0, min_value = 1e300, max_value = 0.0;  ///< [m, N]
};
Move move_ahead(double speed, double ramp, MoveShape shape = MoveShape::trapezoid) {
  BargeAtWork barge;
  const MooringSpread start = barge.spread;
  MoveProfile profile;
  profile.shape = shape;
  profile.distance = 12.0;
  profile.speed = speed;
  profile.ramp = ramp;
  profile.period = kPeriod;
  LengthsByDistance lengths;
  for (const double distance : move_positions(profile)) {
    plan_lengths(barge.spread, barge.hull, offset_ahead(HullOffset::Zero(), distance), barge.wished);
    lengths.add(distance, barge.spread);
  }
  SurgingBarge run(start, winch_tables(lengths, profile), -205.6e3, 0.05);
  run.begin();
  Move move;
  while (run.state.time < 300.0) {
    run.step(0.25);
    move.overshoot = std::max(move.overshoot, run.surge() - 12.0);
    for (const LineEndForces& line : run.lines()) {
      move.min_value = std::min(move.min_value, line.fairlead_tension());
      move.max_value = std::max(move.max_value, line.fairlead_tension());
    }
  }
  return move;
}

/// Numbers of an independent prototype of the same model, three digits given: 2 %.
TEST(quasi_static_lines, carry_the_barge_a_joint_ahead_as_the_prototype_does) {
  const struct {
    double speed, ramp, overshoot, min_value, max_value;
  } cases[] = {{0.10, 10.0, 0.99, 220e3, 402e3},
               {0.15, 10.0, 1.39, 205e3, 433e3},
               {0.20, 10.0, 1.18, 192e3, 466e3},
               {0.15, 30.0, 1.00, 216e3, 410e3}};
  for (const auto& want : cases) {
    const Move move = move_ahead(want.speed, want.ramp);
    EXPECT_NEAR(move.overshoot, want.overshoot, 0.02 * want.overshoot) << want.speed << " " << want.ramp;
    EXPECT_NEAR(move.min_value, want.min_value, 0.02 * want.min_value) << want.speed << " " << want.ramp;
    EXPECT_NEAR(move.max_value, want.max_value, 0.02 * want.max_value) << want.speed << " " << want.ramp;
  }
}

TEST(quasi_static_lines, let_the_barge_overshoot_less_where_it_is_pulled_in_two_parts) {
  const Move plain = move_ahead(0.15, 10.0), parts = move_ahead(0.15, 10.0, MoveShape::zero_vibration);
  EXPECT_LT(parts.overshoot, 0.5 * plain.overshoot);
}

TEST(quasi_static_lines, give_the_hull_the_periods_of_their_stiffness) {
  const MooredCase c = moored_case(bgl1_barge());
  SurgingBarge run(c.spread, {}, 0.0, 0.0);
  run.state.bodies[0].h(0) = 0.05;
  run.begin();
  double last = run.surge(), crossing = 0.0;
  while (crossing == 0.0) {
    run.step(0.25);
    if (run.surge() <= 0.0) crossing = run.state.time - 0.25 * run.surge() / (run.surge() - last);
    last = run.surge();
  }
  EXPECT_NEAR(4.0 * crossing, kPeriod, 0.002 * kPeriod);
}

TEST(quasi_static_lines, do_no_work_that_the_account_does_not_know) {
  const auto error = [](double h) {
    BargeAtWork barge;
    LengthTable haul = smooth_table({0.0, 10.0, 20.0}, {0.0, -1.0, -2.0});
    SurgingBarge run(barge.spread, {haul, {}, {}, {}, {}, {}, {}, haul}, -205.6e3, 0.05);
    run.state.bodies[0].h(0) = 1.0;
    run.begin();
    while (run.state.time < 30.0) run.step(h);
    return std::abs(run.energy.balance().drift());
  };
  const double coarse = error(0.5), fine = error(0.25);
  EXPECT_LT(fine, 1e-4);
  EXPECT_GT(coarse / fine, 3.0);  // second order
}

TEST(quasi_static_lines, resume_bit_for_bit_and_ask_the_heap_for_nothing) {
  BargeAtWork barge;
  SurgingBarge run(barge.spread, {}, -205.6e3, 0.05);
  run.state.bodies[0].h(0) = 2.0;
  run.begin();
  for (int i = 0; i < 20; ++i) run.step(0.25);
  DynamicCheckpoint checkpoint;
  save_state(checkpoint, run.state);
  SurgingBarge again(barge.spread, {}, -205.6e3, 0.05);
  again.begin();
  restore_state(checkpoint, again.state);
  const long before = allocation_count();
  run.step(0.25);
  EXPECT_EQ(allocation_count(), before);
  again.step(0.25);
  EXPECT_EQ(run.state.bodies[0].h, again.state.bodies[0].h);
  EXPECT_EQ(run.lines()[3].pull, again.lines()[3].pull);
  EXPECT_EQ(run.lines()[3].sink, again.lines()[3].sink);
}

TEST(quasi_static_lines, that_cannot_reach_stop_the_step) {
  BargeAtWork barge;
  barge.spread.lines[2].line.set_first_segment(600.0);
  const std::vector<BodySpring> springs = quasi_static_lines(barge.spread, {});
  EXPECT_FALSE(springs[2].force(springs[2].place_V, 0.0, {}).force.allFinite());
  EXPECT_TRUE(springs[1].force(springs[1].place_V, 0.0, {}).force.allFinite());
}

}  // namespace
}  // namespace overbend
