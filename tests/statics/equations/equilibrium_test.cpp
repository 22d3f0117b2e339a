#include "statics/equations/equilibrium.h"

#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/vessel_load.h"
#include "statics/solver/coupled_equilibrium.h"
#include "statics/solver/newton.h"
#include "statics/solver/starting_point.h"
#include "support/free_body.h"
#include "support/line_cases.h"

namespace overbend {
namespace {

/// A reference case on its first guess, rollers and bed touched.
struct Guess {
  explicit Guess(const char* name)
      : model(build_model(
            read_model(std::string(OVERBEND_SOURCE_DIR "/validation/static_cases/") + name).description.value())) {
    state.lines.push_back(sample_shape(system, from.shape));
  }
  Model model;
  StartingPoint from = starting_point(model, lay_plane(model, model.mean_pose));
  StaticSystem system{model, model.mean_pose, build_mesh(model, from.zones)};
  SystemState state;
};

std::vector<double> unbalance(Equilibrium& equilibrium, const EquilibriumTarget& target, SystemState& state) {
  equilibrium.evaluate(state, false);
  equilibrium.hold(false);
  std::vector<double> all = equilibrium.line().residual();
  all.push_back(equilibrium.target_equation(target, state).error);
  return all;
}

// To first order a part of Newton's step takes away that part of what is out of balance: only so where tangent, border
// and target agree with the forces. From an equilibrium, whose far force and target are then changed.
TEST(equilibrium, a_small_part_of_a_step_with_the_far_force_takes_away_that_part_of_the_unbalance) {
  Guess guess("J12-D400-T560.yaml");
  Equilibrium& equilibrium = guess.system.equilibrium();
  NewtonSettings settings;
  settings.target = guess.from.target;
  ASSERT_TRUE(solve_equilibrium(equilibrium, guess.state, settings).converged());
  guess.from.target.value *= 1.01;
  guess.state.lines[0].far_force *= 0.99;
  equilibrium.evaluate(guess.state, true);
  equilibrium.hold(true);
  equilibrium.put_target(guess.from.target, guess.state);
  Increments dq = equilibrium.increments();
  ASSERT_TRUE(equilibrium.solve(0.0, true, dq));
  ASSERT_NE(dq.back().front(), 0.0);
  const std::vector<double> whole = unbalance(equilibrium, guess.from.target, guess.state);
  const auto moved = [&](double share) {
    SystemState state = guess.state;
    equilibrium.advance(state, guess.state, dq, share);
    state.lines[0].far_force += share * dq.back().front();
    return unbalance(equilibrium, guess.from.target, state);
  };
  constexpr double kShare = 1e-3;
  const std::vector<double> low = moved(-kShare), high = moved(kShare);
  double left = 0.0, all = 0.0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const double rest = (high[i] - low[i]) / (2.0 * kShare) + whole[i];
    left += rest * rest;
    all += whole[i] * whole[i];
  }
  EXPECT_LT(left, 1e-10 * all);  // the square of the share, and rounding of the difference
}

TEST(equilibrium, without_a_free_far_force_the_step_leaves_it) {
  Guess guess("J12-D400-T560.yaml");
  Equilibrium& equilibrium = guess.system.equilibrium();
  equilibrium.evaluate(guess.state, true);
  equilibrium.hold(true);
  equilibrium.put_target(guess.from.target, guess.state);
  Increments dq = equilibrium.increments();
  ASSERT_TRUE(equilibrium.solve(0.0, false, dq));
  EXPECT_EQ(dq.back().front(), 0.0);
}

// Without friction no way matters: a step without inertia, searched by the residual, ends where the equations of rest
// do, searched by work.
TEST(equilibrium, a_free_body_and_its_lines_rest_where_a_slow_step_without_friction_takes_them) {
  System system = testing::body_with_lines(testing::floating(), 0.0);
  system.surroundings = testing::surroundings_at_rest(system);
  Assembly assembly(system);
  SystemState slowly = testing::drawn_out(system), state = slowly;
  ASSERT_TRUE(solve_coupled_equilibrium(assembly, slowly).converged);
  Equilibrium at_rest(assembly, {});
  NewtonSettings settings;
  settings.max_iterations = 1000;
  ASSERT_TRUE(solve_equilibrium(at_rest, state, settings).converged());
  EXPECT_LT((state.bodies[0].h - slowly.bodies[0].h).norm(), 1e-6);
  EXPECT_GT((state.bodies[0].h - testing::floating().drawn).norm(), 0.1);
}

/// A slack and a taut cable that share nothing.
Description two_cables() {
  Description d = testing::water_alone(1025.0, 100.0);
  const LineTypeDescription type = testing::cable_type(20.0, 0.06, 2e8, 100.0, 1025.0);
  d.lines = {testing::free_line(type, 130.0, Vec3(0.0, 0.0, -80.0), Vec3(60.0, 20.0, -5.0)),
             testing::free_line(type, 99.9, Vec3(0.0, 50.0, -80.0), Vec3(60.0, 70.0, -5.0))};
  return d;
}

// Two ways to the same place: each by itself, and both as one system.
TEST(equilibrium, lines_rest_in_one_system_where_each_rests_by_itself) {
  const testing::RestingLines alone(two_cables());
  Assembly assembly(alone.setup.system);
  SystemState state = make_initial_state(alone.setup, 0.0);
  assembly.set_time(0.0, state);
  assembly.impose_ends(state);
  Equilibrium together(assembly, {});
  NewtonSettings settings;
  settings.tolerance = 1e-10;
  settings.max_iterations = 2000;
  ASSERT_TRUE(solve_equilibrium(together, state, settings).converged());
  for (std::size_t line = 0; line < 2; ++line) {
    for (int node = 0; node < alone.line(line).mesh.nodes(); ++node) {
      const Vec3 place = Eigen::Map<const Vec3>(state.lines[line].q.data() + 6 * node);
      EXPECT_LT((place - alone.place(line, node)).norm(), 1e-5) << line << ' ' << node;  // both tolerances, softly held
    }
  }
}

/// The system of a lay with the lines of another next to its pipe.
System joined(const System& lay, const System& lines) {
  System both = lay;
  both.lines.insert(both.lines.end(), lines.lines.begin(), lines.lines.end());
  for (Attachment end : lines.attachments) {
    ++end.line;
    both.attachments.push_back(end);
  }
  return both;
}

// They share no unknowns but one Newton: each comes to where it is by itself.
TEST(equilibrium, a_lay_and_cables_next_to_it_rest_in_one_system_where_each_rests_by_itself) {
  Guess guess("J12-D400-T560.yaml");
  const testing::RestingLines cables(two_cables());
  const System both = joined(guess.system.equilibrium().assembly().system(), cables.setup.system);
  Assembly assembly(both);
  assembly.set_surroundings(0.0);
  FarEnd far_end(guess.model, guess.system.plane().route, guess.system.mesh().total_length());
  Equilibrium together(assembly, {guess.model.description.statics.history});
  together.slide(far_end, 0, guess.system.plane());
  SystemState state = guess.state;
  for (const LineState& line : make_initial_state(cables.setup, 0.0).lines) state.lines.push_back(line);
  NewtonSettings settings;
  settings.target = guess.from.target;
  settings.max_iterations = 2000;
  ASSERT_TRUE(solve_equilibrium(guess.system.equilibrium(), guess.state, settings).converged());
  settings.tolerance = 1e-10;
  ASSERT_TRUE(solve_equilibrium(together, state, settings).converged());
  EXPECT_NEAR(state.lines[0].far_force, guess.state.lines[0].far_force, 1e-7 * guess.state.lines[0].far_force);
  const std::array<double, 6>& end = assembly.line(2).end_force(LineEnd::last);
  EXPECT_LT((Vec3(end[0], end[1], end[2]) - cables.last[1]).norm(), 1e-5 * cables.last[1].norm());
}

/// The system of a lay whose vessel floats on springs.
System afloat(StaticSystem& lay, const testing::SpringBody& springs) {
  System system = lay.equilibrium().assembly().system();
  system.bodies.front().free = testing::free_body(springs);
  const LayPlane& plane = lay.plane();
  const Mat3 to_V = lay.pose().R_WV.transpose();
  testing::hold_on_body(system.attachments.back(), to_V * (plane.tensioner_W - lay.pose().p_WV),
                        to_V * *lay.held_direction());
  return system;
}

SystemState afloat(const System& system, const StaticSolution& start, const Vec6& drawn) {
  SystemState state = state_at_rest(system, {start.state.q}, 0.0);
  state.lines.front().low = start.state.low;
  state.lines.front().far_force = start.state.far_force;
  state.bodies.front().h = drawn;
  return state;
}

testing::SpringBody sea_springs(const VesselPose& pose) {
  testing::SpringBody springs;
  springs.body.mass = 5e6;  // what unbalanced forces are measured against
  springs.drawn = make_coordinates(pose.p_WV, pose.R_WV);
  springs.stiffness << 4e5, 4e5, 2e7, 1e10, 2e10, 2e10;
  return springs;
}

// Second opinions: the lay alone on the vessel where it has come to, and what the pipe does to the vessel there.
TEST(equilibrium, a_lay_and_its_floating_vessel_rest_in_one_system) {
  Model model =
      build_model(read_model(OVERBEND_SOURCE_DIR "/validation/static_cases/S16-T300.yaml").description.value());
  const StaticSolution held = solve_statics(model).solution.value();
  StaticSystem lay(model, model.mean_pose, held.mesh);
  const testing::SpringBody springs = sea_springs(model.mean_pose);
  const System system = afloat(lay, springs);
  Assembly assembly(system);
  FarEnd far_end(model, lay.plane().route, lay.mesh().total_length());
  Equilibrium together(assembly, {model.description.statics.history});
  together.slide(far_end, 0, lay.plane());
  SystemState state = afloat(system, held, springs.drawn);
  NewtonSettings settings;
  settings.target = EquilibriumTarget{EquilibriumTarget::Kind::top_tension, 300e3};
  ASSERT_TRUE(solve_equilibrium(together, state, settings).converged());
  const Vec6 moved = state.bodies.front().h - springs.drawn;
  EXPECT_GT(moved.head<3>().norm(), 0.1);
  const BodyPose pose = make_pose(state.bodies.front().h);
  model.mean_pose = {pose.place, pose.R};
  StaticSystem static_system(model, model.mean_pose, held.mesh);
  const LineState& pipe = state.lines.front();
  const Vec6 load = load_on_vessel(static_system, pipe);
  static_system.hold(false);
  EXPECT_LT(static_system.relative_residual(), 1e-8);
  EXPECT_NEAR(static_system.target_error(pipe, *settings.target), 0.0, 1.0);  // [N]
  const Vec6 pulled = springs.stiffness.cwiseProduct(moved);
  EXPECT_LT((pulled.head<3>() - load.head<3>()).norm(), 1e-6 * load.head<3>().norm());
  EXPECT_LT((pulled.tail<3>() - pose.E.transpose() * load.tail<3>()).norm(), 1e-6 * load.tail<3>().norm());
}

// The same cable in a system whose model has the smaller stiffness.
TEST(equilibrium, a_limit_on_the_axial_stiffness_makes_the_cable_as_soft) {
  Description soft = two_cables();
  for (FreeLineDescription& line : soft.lines) line.segments[0].type.axial_stiffness = 1e6;
  const testing::RestingLines reference(soft);
  const testing::RestingLines stiff(two_cables());
  Assembly assembly(stiff.setup.system);
  Continuation continuation;
  continuation.max_axial_stiffness = 1e6;
  assembly.set(continuation);
  SystemState state = make_initial_state(stiff.setup, 0.0);
  ASSERT_TRUE(solve_lines_one_by_one(assembly, state).converged());
  const std::array<double, 6>& end = assembly.line(1).end_force(LineEnd::last);
  EXPECT_LT((Vec3(end[0], end[1], end[2]) - reference.last[1]).norm(), 1e-5 * reference.last[1].norm());
  EXPECT_GT((stiff.last[1] - reference.last[1]).norm(), 0.05 * reference.last[1].norm());
}

}  // namespace
}  // namespace overbend
