#include "system/assembly.h"

#include <gtest/gtest.h>

#include "dynamics/setup/run_setup.h"
#include "support/bgl1_in_time.h"
#include "support/fixtures.h"
#include "support/free_body.h"
#include "support/moving_rod.h"

namespace overbend {
namespace {

/// The BGL-1 lying still on its rollers, held by its brake.
class StandingPipe {
 public:
  StandingPipe()
      : at_(testing::workable()),
        setup_(make_setup(at_.model, at_.start, at_.statics.top_tension, dynamic_options(at_.model))) {
    setup_.system.surroundings = [this](double /*time*/, Surroundings& surroundings) {
      surroundings.bodies.front().pose = at_.model.mean_pose;
      surroundings.bodies.front().pose.p_WV.z() -= sunk;
      set_attachment_motions(setup_.system, surroundings);
    };
  }
  const System& system() const { return setup_.system; }
  SystemState state() const { return state_at_rest(setup_.system, {at_.start.state.q}, 0.0); }

  double sunk = 0.0;  ///< The barge, and its rollers with it [m].

 private:
  testing::TimedLay at_;
  RunSetup setup_;
};

Eigen::VectorXd stack_increments(const Increments& dq, std::size_t part = 0) {
  return Eigen::Map<const Eigen::VectorXd>(dq[part].data(), static_cast<Eigen::Index>(dq[part].size()));
}

TEST(renewed_contacts, give_the_step_of_a_full_tangent_where_rollers_sink_away_from_the_pipe) {
  StandingPipe standing;
  Assembly assembly(standing.system());
  const Weights weights{60.0, 3600.0, 0.02};  // of a step of about 1/30 s
  SystemState state = standing.state();
  const SystemState before = state;
  assembly.set_time(0.0, state);
  assembly.evaluate(state, before, weights, true);
  const std::uint64_t signature = assembly.contact_signature();
  assembly.hold(true);
  Increments dq = assembly.increments();
  ASSERT_TRUE(assembly.solve_factored(dq));

  standing.sunk = 0.004;  // rollers give a millimetre under the pipe
  assembly.set_time(0.0, state);
  const auto step = [&](bool with_tangent, const auto& solve) {
    assembly.evaluate(state, before, weights, with_tangent);
    assembly.hold(with_tangent);
    solve();
    return stack_increments(dq);
  };
  const Eigen::VectorXd old = step(false, [&] { assembly.solve_again(dq); });
  ASSERT_NE(assembly.contact_signature(), signature);
  const Eigen::VectorXd renewed = step(false, [&] {
    ASSERT_TRUE(assembly.renew_contacts(state, weights));
    assembly.solve_again(dq);
  });
  const Eigen::VectorXd full = step(true, [&] { ASSERT_TRUE(assembly.solve_factored(dq)); });
  EXPECT_GT((old - full).norm(), 0.3 * full.norm());
  EXPECT_LT((renewed - full).norm(), 1e-9 * full.norm());  // rounding: the line itself has not moved
}

// The cable has been stretched and turned since: what else there is stands, so that a full tangent changes nothing
// more.
TEST(renewed_line, gives_the_step_of_a_full_tangent) {
  System system = testing::body_with_lines(testing::floating());
  system.surroundings = testing::surroundings_at_rest(system);
  Assembly assembly(system);
  SystemState state = testing::drawn_out(system);
  const SystemState before = state;
  const Weights weights{60.0, 3600.0, 0.02};
  assembly.set_time(0.0, state);
  const auto solved = [&](bool with_tangent, const auto& solve) {
    assembly.impose_ends(state);
    assembly.evaluate(state, before, weights, with_tangent);
    assembly.hold(with_tangent);
    Increments dq = assembly.increments();
    EXPECT_TRUE(solve(dq));
    return dq;
  };
  const auto fully = [&](Increments& dq) { return assembly.solve_factored(dq); };
  solved(true, fully);
  for (std::size_t i = 2; i + 6 < state.lines[0].q.size(); i += 6) state.lines[0].q[i] += i % 4 == 0 ? 0.2 : -0.2;
  const Increments old = solved(false, [&](Increments& dq) {
    assembly.solve_again(dq);
    return true;
  });
  const Increments renewed = solved(false, [&](Increments& dq) {
    const bool regular = assembly.renew_lines(state, before, weights, {1, 0});
    assembly.solve_again(dq);
    return regular;
  });
  const Increments full = solved(true, fully);
  for (std::size_t part = 0; part < full.size(); ++part) {  // the cable's, the rod's, the body's
    const double size = stack_increments(full, part).norm();
    EXPECT_GT((stack_increments(old, part) - stack_increments(full, part)).norm(), 1e-3 * size) << part;
    EXPECT_LT((stack_increments(renewed, part) - stack_increments(full, part)).norm(), 1e-8 * size) << part;
  }
}

/// A soft rod that swings from one end.
System pendulum(double length, int elements) {
  System system = testing::rod_system({400.0, 1.0, 1.2, 1.2 * kGravity}, length, elements);
  testing::first_end(system).hold_place = true;
  testing::first_rod(system).force_scale = 1.2 * length * kGravity;
  return system;
}

/// Both in one system.
System combined_system(const System& system, const System& second_system) {
  System both = system;
  both.lines.push_back(second_system.lines.front());
  for (Attachment end : second_system.attachments) {
    end.line = 1;
    both.attachments.push_back(end);
  }
  return both;
}

std::vector<double> level(const System& system) {
  return testing::straight(system, Vec3::Zero(), Vec3::UnitX());
}

/// The system released level and followed for `steps`.
SystemState swung(const System& system, const std::vector<std::vector<double>>& q, int steps) {
  Assembly assembly(system);
  TimeStepper stepper(assembly, {0.8, 1e-11, 20});
  SystemState state = state_at_rest(system, q, 0.0);
  assembly.set_time(0.0, state);
  EXPECT_TRUE(assembly.find_accelerations(state));
  for (LineState& line : state.lines) line.algorithmic_acceleration = line.acc;
  SystemState next = state;
  for (int i = 0; i < steps; ++i) {
    EXPECT_TRUE(stepper.step(state, 1e-3, next).converged());
    std::swap(state, next);
  }
  return state;
}

double max_deviation(const std::vector<double>& a, const std::vector<double>& b) {
  double max_value = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) max_value = std::max(max_value, std::abs(a[i] - b[i]));
  return max_value;
}

TEST(assembly, of_two_lines_of_different_lengths_moves_each_as_it_moves_alone) {
  const System shorter = pendulum(2.0, 4), longer = pendulum(9.0, 30);
  constexpr int kSteps = 300;
  const SystemState both = swung(combined_system(shorter, longer), {level(shorter), level(longer)}, kSteps);
  const SystemState first = swung(shorter, {level(shorter)}, kSteps);
  const SystemState second = swung(longer, {level(longer)}, kSteps);
  EXPECT_GT(max_deviation(level(longer), second.lines[0].q), 0.3);  // it has swung
  EXPECT_LT(max_deviation(both.lines[0].q, first.lines[0].q), 1e-9);
  EXPECT_LT(max_deviation(both.lines[1].q, second.lines[0].q), 1e-9);
}

TEST(line_assembly, at_rest_is_that_of_a_motion_without_rates) {
  StandingPipe standing;
  const System& system = standing.system();
  SystemState state = standing.state();
  const SystemState before = state;
  Assembly moving(system);
  moving.set_time(0.0, state);
  moving.evaluate(state, before, {}, false);
  BlockTridiagonal tangent(system.lines[0].mesh.nodes());
  LineAssembly resting(system.lines[0], system.bodies, tangent);
  resting.evaluate_at_rest(moving.surroundings().bodies, state.lines[0], LayHistory::laying, false);
  // The friction of the bed alone is another law: at rest it is a spring to the route, in motion it remembers.
  double load = 0.0, difference = 0.0;
  const std::size_t nodes = system.lines[0].mesh.s.size();
  for (std::size_t node = nodes / 2; node < nodes; ++node) {
    for (std::size_t i = 6 * node; i < 6 * node + 3; ++i) {
      difference = std::max(difference, std::abs(resting.cuts()[i] - moving.line(0).cuts()[i]));
      load = std::max(load, std::abs(resting.cuts()[i]));
    }
  }
  EXPECT_GT(load, 1e5);
  EXPECT_LT(difference, 1e-9 * load);
  int carrying = 0;
  for (int i = 0; i < resting.contacts().count(); ++i) {
    const RollerContact &a = resting.contacts().contacts()[static_cast<std::size_t>(i)],
                        &b = moving.line(0).contacts().contacts()[static_cast<std::size_t>(i)];
    if (a.normal <= 0.0) continue;
    ++carrying;
    EXPECT_NEAR(a.penetration, b.penetration, 1e-12);
    EXPECT_NEAR(a.normal, b.normal, 1e-6 * a.normal);
  }
  EXPECT_GT(carrying, 10);
}

}  // namespace
}  // namespace overbend
