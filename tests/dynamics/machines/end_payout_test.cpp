/// Winches, brakes, dragging anchors and parting lines, against the elastic catenary and the balance of momentum.
#include "dynamics/machines/end_payout.h"

#include <gtest/gtest.h>

#include "moorings/catenary.h"
#include "support/allocation_count.h"
#include "support/line_cases.h"

namespace overbend {
namespace {

constexpr double kLength = 1007.339, kSpan = 1000.0, kDepth = 89.0, kFairlead = 3.0;

LineTypeDescription wire() {
  LineTypeDescription type = testing::cable_type(16.3418, 0.0512, 165.48e6, 2e3, 1025.0);
  type.drag_normal = 1.8;
  type.drag_diameter = 0.064;
  return type;
}

/// A mooring line of BGL-1 on a bed without friction, its fairlead the second end.
Description moored_wire() {
  Description d = testing::water_alone(1025.0, kDepth);
  d.lines = {testing::free_line(wire(), kLength, Vec3(0.0, 0.0, -kDepth), Vec3(kSpan, 0.0, kFairlead))};
  return d;
}

/// Tensions at both ends of the same line as a catenary.
struct Tensions {
  double fairlead, anchor;
};
Tensions catenary_tensions(double length, double span) {
  const CatenaryLine line = catenary_line({{"", length, wire()}}, {}, 0.0, kGravity);
  const CatenarySite site{kFairlead, -kDepth, true, -kDepth, 0.0};
  const CatenarySolution catenary_solution = solve_catenary(line, site, span);
  return {catenary_solution.tension(), catenary_solution.anchor_tension()};
}

Vec3 force_at(const Instant& instant, LineEnd end) {
  return Eigen::Map<const Vec3>(instant.assembly->line(0).end_force(end).data());
}

/// Keeps the largest tension, and looks at every step.
class Steps : public SimulationObserver {
 public:
  void stepped(const Instant& instant) override {
    const double tension = force_at(instant, LineEnd::last).norm();
    max_magnitude = std::max(max_magnitude, tension);
    if (look) look(instant, tension);
  }
  double max_magnitude = 0.0;
  std::function<void(const Instant&, double)> look;
};

struct WinchCase {
  explicit WinchCase(const Description& d) : rest(d), ends(rest.setup.system.attachments) {}
  Attachment& fairlead() { return ends.at(1); }
  Attachment& anchor() { return ends.at(0); }
  /// Runs from rest; what is left of it.
  Simulation& run(double duration, double build_up = 0.0, std::optional<double> fixed_step = {}) {
    DynamicOptions options;
    options.duration = duration;
    options.build_up = build_up;
    options.output_step = 0.5;
    options.max_step = 0.1;
    options.fixed_step = fixed_step;
    RunStart start = rest.start(options);
    System& system = start.setup.system;
    system.attachments = ends;
    if (commanded) command_speed(start.state.attachments.at(1).machine, *commanded);
    if (left) return_to_law(system.attachments.at(1).winch->tension, 0.0, start.state.attachments.at(1).machine);
    made.emplace(rest.model, std::move(start), options);
    made->observe(rows);
    return *made;
  }
  const SystemState& state() const { return *made->present().state; }
  const PayoutState& payout(std::size_t end) const { return state().attachments.at(end).payout; }
  double tension(LineEnd end = LineEnd::last) const { return force_at(made->present(), end).norm(); }

  testing::RestingLines rest;
  std::vector<Attachment> ends;
  Steps rows;
  std::optional<double> commanded;  ///< Speed of the winch from the start [m/s].
  bool left = false;                ///< And no longer.
  std::optional<Simulation> made;
};

class winch : public ::testing::TestWithParam<double> {};

/// Five metres at 0.1 m/s, begun and ended over two periods of the sag: no tension is further than 1 % from that of a
/// line at rest with the length of the instant. Without drag across: the water holds back a sag that changes, by 3 % of
/// the tension here, which is no blow.
TEST_P(winch, that_pays_out_and_hauls_in_smoothly_keeps_to_the_curve_of_rest) {
  Description d = moored_wire();
  d.lines[0].segments[0].type.drag_normal = 0.0;
  WinchCase winch_case(d);
  ASSERT_TRUE(winch_case.rest.rest.converged());
  WinchLaw law;
  const double done = add_move(law.program, 1.0, GetParam(), 0.1, 20.0);
  winch_case.fairlead().winch = law;
  Simulation& run = winch_case.run(done + 20.0);
  double worst = 0.0;
  winch_case.rows.look = [&](const Instant& instant, double tension) {
    const double length = kLength + law.program.at(instant.state->time).length;
    const double rest = catenary_tensions(length, kSpan).fairlead;
    worst = std::max(worst, std::abs(tension / rest - 1.0));
  };
  ASSERT_TRUE(run.advance(run.end())) << run.failure()->what;
  EXPECT_LT(worst, 0.01);
  EXPECT_NEAR(winch_case.payout(1).moved, GetParam(), 1e-9);
  const double rest = catenary_tensions(kLength + GetParam(), kSpan).fairlead;
  EXPECT_NEAR(winch_case.tension(), rest, 0.002 * rest);
  EXPECT_LT(std::abs(run.energy().drift()), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(five_metres, winch, ::testing::Values(5.0, -5.0));

/// A swing of the fairlead away from the anchor and back, once in a period [s]. Three quarters of it the fairlead
/// is at rest, nearest to the anchor.
Description swinging_wire(double amplitude, double period) {
  Description d = moored_wire();
  d.lines[0].second.amplitude = Vec3(amplitude, 0.0, 0.0);
  d.lines[0].second.period = period;
  return d;
}

TEST(winch, whose_brake_renders_keeps_the_tension_it_bears_and_the_line_is_longer_by_that) {
  WinchCase winch_case(swinging_wire(2.0, 60.0));
  WinchLaw law;
  law.brake = 350e3;
  winch_case.fairlead().winch = law;
  Simulation& run = winch_case.run(45.0);
  ASSERT_TRUE(run.advance(run.end())) << run.failure()->what;
  EXPECT_LT(winch_case.rows.max_magnitude, 1.01 * law.brake);  // half a percent for every 0.1 m/s
  EXPECT_GT(winch_case.rows.max_magnitude, law.brake);
  EXPECT_GT(winch_case.payout(1).rendered_length, 0.5);
  EXPECT_EQ(winch_case.payout(1).rendered_length, winch_case.payout(1).moved);
  const double rest = catenary_tensions(kLength + winch_case.payout(1).moved, kSpan - 2.0).fairlead;
  EXPECT_NEAR(winch_case.tension(), rest, 0.02 * rest);
  EXPECT_LT(std::abs(run.energy().drift()), 1e-3);
}

TEST(winch, stops_hauling_in_at_the_tension_at_which_it_stalls) {
  WinchCase winch_case(moored_wire());
  WinchLaw law;
  law.stall = 350e3;
  add_move(law.program, 1.0, -5.0, 0.2, 3.0);
  winch_case.fairlead().winch = law;
  Simulation& run = winch_case.run(40.0);
  ASSERT_TRUE(run.advance(run.end())) << run.failure()->what;
  EXPECT_LT(winch_case.rows.max_magnitude, 1.02 * law.stall);  // what swings on after it has stopped
  const double rest = catenary_tensions(kLength + winch_case.payout(1).moved, kSpan).fairlead;
  EXPECT_NEAR(rest, law.stall, 0.01 * law.stall);
  EXPECT_GT(winch_case.payout(1).moved, -2.0);
  EXPECT_GT(winch_case.payout(1).stalled_time, 10.0);
}

TEST(winch, that_keeps_a_tension_hauls_in_until_it_is_there) {
  WinchCase winch_case(moored_wire());
  WinchLaw law;
  law.tension.mode = TensionerMode::controlled;
  law.tension.wanted = 330e3;
  law.tension.low = 325e3;
  law.tension.high = 335e3;
  law.tension.delay = 2.0;
  law.tension.velocity = 0.1;
  law.tension.acceleration = 0.05;
  law.tension.resolution = 3.0;
  winch_case.fairlead().winch = law;
  Simulation& run = winch_case.run(60.0);
  run.advance(2.0);
  EXPECT_EQ(winch_case.payout(1).moved, 0.0);  // within the delay
  ASSERT_TRUE(run.advance(run.end())) << run.failure()->what;
  EXPECT_NEAR(winch_case.tension(), law.tension.wanted, 5e3);
  const double rest = catenary_tensions(kLength + winch_case.payout(1).moved, kSpan).fairlead;
  EXPECT_NEAR(rest, law.tension.wanted, 5e3);
  EXPECT_LT(winch_case.rows.max_magnitude, law.tension.high + 2e3);
}

TEST(anchor, drags_at_its_holding_power_and_stays_where_it_was_dragged_to) {
  WinchCase winch_case(swinging_wire(2.0, 60.0));
  const double holding =
      0.5 * (catenary_tensions(kLength, kSpan).anchor + catenary_tensions(kLength, kSpan + 2.0).anchor);
  winch_case.anchor().holding = holding;
  Simulation& run = winch_case.run(45.0);
  double max_value = 0.0;
  winch_case.rows.look = [&](const Instant& instant, double) {
    max_value =
        std::max(max_value, held_end_load(instant.assembly->system().attachments[0], (*instant.assembly).line(0)));
  };
  ASSERT_TRUE(run.advance(run.end())) << run.failure()->what;
  EXPECT_LT(max_value, 1.01 * holding);  // half a percent for every 0.1 m/s
  EXPECT_GT(max_value, holding);
  const Vec3 dragged = winch_case.payout(0).dragged;
  EXPECT_GT(dragged.x(), 0.2);
  EXPECT_EQ(winch_case.payout(0).rendered_length, dragged.x());
  const double rest = catenary_tensions(kLength, kSpan - 2.0 - dragged.x()).fairlead;
  EXPECT_NEAR(winch_case.tension(), rest, 0.02 * rest);
  EXPECT_LT(std::abs(run.energy().drift()), 1e-3);
}

/// A line that hangs straight down in air and is released above: until the news has come down with the speed of sound,
/// the lower end bears what it did, and the whole gains the momentum of its weight and of that.
TEST(parted_line, gains_the_momentum_of_the_force_it_lost) {
  Description d = testing::water_alone(1025.0, 1.0);
  LineTypeDescription type = testing::cable_type(16.0, 0.0, 16e6, 10.0, 1025.0);  // sound at 1,000 m/s
  type.diameter = 0.05;
  d.lines = {testing::free_line(type, 300.0, Vec3(0.0, 0.0, 10.0), Vec3(0.0, 0.0, 311.0))};
  WinchCase winch_case(d);
  ASSERT_TRUE(winch_case.rest.rest.converged());
  winch_case.fairlead().parts_at = 0.05;
  Simulation& run = winch_case.run(0.2);
  const double below = winch_case.rest.first[0].norm(), weight = 16.0 * kGravity * 300.0;
  ASSERT_GT(below, 10e3);
  ASSERT_TRUE(run.advance(0.2)) << run.failure()->what;
  EXPECT_TRUE(winch_case.state().attachments[1].parted);
  EXPECT_NEAR(winch_case.tension(LineEnd::first), below, 0.01 * below);
  const std::vector<double>& v = winch_case.state().lines[0].v;
  const LineMesh& mesh = run.system().lines[0].mesh;
  double momentum = 0.0;
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    const double h = mesh.length[e];
    const double* const sample = v.data() + 6 * e;
    momentum += 16.0 * h * (0.5 * (sample[2] + sample[8]) + h / 12.0 * (sample[5] - sample[11]));
  }
  const double expected = -(weight + below) * 0.15;
  EXPECT_NEAR(momentum, expected, 0.01 * std::abs(expected));
}

/// 0.2 m/s within 2 s.
WinchLaw commanded_winch() {
  WinchLaw law;
  law.tension.velocity = 0.2;
  law.tension.acceleration = 0.1;
  law.tension.limit = 5.0;
  return law;
}

TEST(commanded_winch, pays_out_what_its_speed_and_its_ramp_make_with_a_balance_of_energy_that_closes) {
  WinchCase winch_case(moored_wire());
  winch_case.fairlead().winch = commanded_winch();
  winch_case.commanded = 0.1;  // reached in a second
  Simulation& run = winch_case.run(20.0);
  ASSERT_TRUE(run.advance(20.0)) << run.failure()->what;
  EXPECT_NEAR(winch_case.payout(1).moved, 0.1 * (20.0 - 0.5), 1e-12);
  EXPECT_EQ(winch_case.payout(1).rate, 0.1);
  EXPECT_EQ(winch_case.state().attachments[1].machine.state, TensionerState::pay_out);
  EXPECT_NEAR(winch_case.state().attachments[1].machine.tension, winch_case.tension(), 1e-9 * winch_case.tension());
  EXPECT_LT(std::abs(run.energy().drift()), 1e-3);
}

TEST(commanded_winch, stops_where_its_range_ends) {
  WinchCase winch_case(moored_wire());
  winch_case.fairlead().winch = commanded_winch();
  winch_case.commanded = 0.5;  // more than it has
  Simulation& run = winch_case.run(40.0);
  ASSERT_TRUE(run.advance(40.0)) << run.failure()->what;
  EXPECT_NEAR(winch_case.payout(1).moved, 5.0, 1e-5);
  EXPECT_EQ(winch_case.payout(1).rate, 0.0);
  EXPECT_EQ(winch_case.state().attachments[1].machine.state, TensionerState::at_limit);
}

TEST(commanded_winch, stalls_as_one_with_a_program_does) {
  WinchCase winch_case(moored_wire());
  winch_case.fairlead().winch = commanded_winch();
  winch_case.fairlead().winch->stall = 350e3;
  winch_case.commanded = -0.2;
  Simulation& run = winch_case.run(40.0);
  ASSERT_TRUE(run.advance(run.end())) << run.failure()->what;
  EXPECT_LT(winch_case.rows.max_magnitude, 1.02 * 350e3);  // what swings on after it has stopped
  const double rest = catenary_tensions(kLength + winch_case.payout(1).moved, kSpan).fairlead;
  EXPECT_NEAR(rest, 350e3, 0.01 * 350e3);
  EXPECT_GT(winch_case.payout(1).stalled_time, 10.0);
}

TEST(commanded_winch, renders_at_what_its_brake_bears) {
  WinchCase winch_case(swinging_wire(2.0, 60.0));
  winch_case.fairlead().winch = commanded_winch();
  winch_case.fairlead().winch->brake = 350e3;
  winch_case.commanded = 0.0;
  Simulation& run = winch_case.run(45.0);
  ASSERT_TRUE(run.advance(run.end())) << run.failure()->what;
  EXPECT_LT(winch_case.rows.max_magnitude, 1.01 * 350e3);
  EXPECT_GT(winch_case.payout(1).rendered_length, 0.5);
}

// From the command it goes to the speed of its program at 0.1 m/s2, and then with it.
TEST(commanded_winch, goes_back_to_its_program_when_it_is_left) {
  WinchCase winch_case(moored_wire());
  WinchLaw law = commanded_winch();
  add_move(law.program, 0.0, 3.0, 0.1, 2.0);
  winch_case.fairlead().winch = law;
  winch_case.commanded = -0.1;
  winch_case.left = true;
  Simulation& run = winch_case.run(60.0);
  ASSERT_TRUE(run.advance(4.0));
  EXPECT_FALSE(winch_case.state().attachments[1].machine.commanded);
  EXPECT_NEAR(winch_case.payout(1).rate, 0.1, 1e-9);
  ASSERT_TRUE(run.advance(60.0));
  EXPECT_NEAR(winch_case.payout(1).moved, 3.0, 0.05);
}

TEST(end_payout, allocate_nothing_in_a_step) {
  WinchCase winch_case(swinging_wire(2.0, 20.0));
  WinchLaw law;
  law.brake = 350e3;
  add_move(law.program, 0.0, 1.0, 0.2, 3.0);
  winch_case.fairlead().winch = law;
  winch_case.anchor().holding = 300e3;
  Simulation& run = winch_case.run(20.0);
  ASSERT_TRUE(run.advance(1.0));
  const long before = testing::allocation_count();
  ASSERT_TRUE(run.advance(10.0)) << run.failure()->what;
  EXPECT_EQ(testing::allocation_count(), before);
}

}  // namespace
}  // namespace overbend
