/// The BGL-1 floating free under its pipe, held by springs in surge, sway and yaw: the first instant and some seconds.
#include <gtest/gtest.h>

#include "dynamics/run/simulation.h"
#include "dynamics/setup/unsupported_in_dynamics.h"
#include "modelfile/reading/yaml_reader.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend {
namespace {

constexpr double kSurge = 1.8479e5;  ///< Stiffness of eight mooring lines of 64 mm wire at 300 kN [N/m].

/// The example, coarse, from held to floating free.
Description afloat() {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
  d.environment.waves.front().hs = 1.5;
  d.environment.waves.front().tp = 8.0;
  d.environment.waves.front().components = 40;
  d.mesh.overbend_element = 1.0;
  d.mesh.touchdown_element = 3.0;
  d.mesh.max_element_length = 8.0;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 1.0;
  d.dynamics->build_up = 2.0;
  HydrodynamicsSource source;
  source.path = OVERBEND_SOURCE_DIR "/data/bgl1/bgl1";
  source.origin_V = Vec3(0.0, 0.0, 0.818);
  Diagnostics diagnostics;
  CoupledHullDescription hull;
  hull.data = read_hydrodynamics(source, diagnostics);
  hull.mass = 19121.58e3;
  hull.centre_of_gravity = source.origin_V;
  hull.gyration = Vec3(10.5, 30.0, 30.0);
  hull.current.stated = true;
  d.vessel.coupled = hull;
  d.vessel.motion = VesselMotion::coupled;
  d.station_keeping.emplace();
  d.station_keeping->stiffness = Vec3(kSurge, kSurge, 5.1281e8);
  d.station_keeping->damping = Vec3(4e5, 4e5, 1e9);
  return d;
}

TEST(free_hull, under_its_pipe_starts_from_rest_and_keeps_account_of_its_energy) {
  const Model model = build_model(afloat());
  ASSERT_FALSE(unsupported_in_dynamics(model));
  const StaticSolution start = solve_statics(model).solution.value();
  const double tension = model.description.tensioner.tension.value();
  Simulation simulation(model, start, tension, dynamic_options(model));
  ASSERT_FALSE(simulation.failure());
  const HullState first = simulation.present().state->bodies.at(0);
  EXPECT_LT(first.acc.head<3>().norm(), 1e-6 * kGravity);
  EXPECT_LT(first.acc.tail<3>().norm(), 1e-7);
  EXPECT_NEAR(simulation.tension(), tension, 1e-4 * tension);
  // The pipe's far end pulls with the horizontal force of statics; in addition the current pushes hull and pipe.
  EXPECT_GT(std::abs(first.h(0)), 0.5 * start.state.far_force / kSurge);
  EXPECT_LT(std::abs(first.h(2) - 0.818), 2e-3);  // ballasted: as drawn
  EXPECT_LT(std::abs(first.h(4)), 1e-3);
  while (simulation.step()) {
  }
  ASSERT_FALSE(simulation.failure());
  const HullState& last = simulation.present().state->bodies.at(0);
  EXPECT_GT((last.h - first.h).norm(), 1e-3);
  EXPECT_LT(std::abs(simulation.energy().drift()), 3e-3);  // of little that has passed so soon
}

TEST(free_hull, resumes_from_a_checkpoint_bit_for_bit) {
  const Model model = build_model(afloat());
  const StaticSolution start = solve_statics(model).solution.value();
  const double tension = model.description.tensioner.tension.value();
  Simulation whole(model, start, tension, dynamic_options(model));
  whole.advance(0.0);
  const DynamicCheckpoint checkpoint = whole.checkpoint();
  whole.advance(0.5);
  Simulation resumed(model, start, tension, dynamic_options(model));
  resumed.restore(checkpoint);
  resumed.advance(0.5);
  EXPECT_EQ(whole.time(), resumed.time());
  EXPECT_EQ(whole.present().state->bodies[0].h, resumed.present().state->bodies[0].h);
  EXPECT_EQ(whole.present().state->bodies[0].radiation.values, resumed.present().state->bodies[0].radiation.values);
  EXPECT_EQ(whole.present().state->lines[0].q, resumed.present().state->lines[0].q);
}

}  // namespace
}  // namespace overbend
