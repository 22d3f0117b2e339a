// A stinger on its hinge with the pipe on it, in time.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/run/simulation.h"
#include "dynamics/setup/unsupported_in_dynamics.h"
#include "model/pipe/section.h"
#include "modelfile/reading/yaml_reader.h"
#include "seafiles/hydrodynamics_reader.h"
#include "statics/moored/moored_lay.h"
#include "statics/recovery/recovery.h"

namespace overbend {
namespace {

/// A reference case of statics in calm water, on a coarse mesh and rollers that give, for a short time.
Description calm(const std::string& name) {
  Description d = read_model(std::string(OVERBEND_SOURCE_DIR) + "/validation/operation_cases/" + name + ".yaml")
                      .description.value();
  d.rollers.front().stiffness = 2e7;
  d.mesh.overbend_element = 1.5;
  d.mesh.touchdown_element = 4.0;
  d.mesh.max_element_length = 10.0;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 4.0;
  d.dynamics->build_up = 2.0;
  return d;
}

/// A lay at rest, and its simulation.
struct InTime {
  explicit InTime(const Description& description) : model(build_model(description)) {
    start = solve_lay(model).solution.value();
    statics = recover_state(model, start);
  }
  Simulation simulation() const { return {model, start, statics.top_tension, dynamic_options(model)}; }

  Model model;
  StaticSolution start;
  StaticResults statics;
};

HingeReading reading(const Simulation& simulation) {
  return simulation.present().assembly->hinged().reading(0);
}

TEST(floating_stinger, begins_in_the_equilibrium_of_statics_and_stays_there) {
  const InTime lay(calm("HS16-tanks"));
  const StingerSectionResult& at_rest = lay.statics.stinger.at(0);
  Simulation simulation = lay.simulation();
  ASSERT_FALSE(simulation.failure());
  const HingeReading first = reading(simulation);
  EXPECT_NEAR(first.angle, at_rest.angle, 1e-12);
  EXPECT_NEAR(first.force.norm(), at_rest.hinge_force, 2e-3 * at_rest.hinge_force);
  EXPECT_NEAR(first.draught, at_rest.draught, 1e-6);
  ASSERT_TRUE(simulation.advance(simulation.end()));
  EXPECT_NEAR(reading(simulation).angle, at_rest.angle, 1e-5);
  EXPECT_NEAR(reading(simulation).force.norm(), at_rest.hinge_force, 5e-3 * at_rest.hinge_force);
}

TEST(floating_stinger, in_a_current_begins_in_the_equilibrium_of_statics_and_stays_there) {
  Description d = calm("HS16-tanks");
  const double static_angle = InTime(d).statics.stinger.at(0).angle;
  d.environment.current = {{0.0, 0.8, d.vessel.heading}, {d.environment.water_depth, 0.8, d.vessel.heading}};
  const InTime lay(d);
  const StingerSectionResult& at_rest = lay.statics.stinger.at(0);
  EXPECT_GT(std::abs(at_rest.angle - static_angle), 1e-3);
  Simulation simulation = lay.simulation();
  ASSERT_FALSE(simulation.failure());
  EXPECT_NEAR(reading(simulation).force.norm(), at_rest.hinge_force, 2e-3 * at_rest.hinge_force);
  ASSERT_TRUE(simulation.advance(simulation.end()));
  EXPECT_NEAR(reading(simulation).angle, at_rest.angle, 2e-5);
}

TEST(floating_stinger, that_rests_on_a_stop_begins_with_the_moment_that_the_stop_carries) {
  const InTime lay(calm("HS16-stop"));
  const StingerSectionResult& at_rest = lay.statics.stinger.at(0);
  ASSERT_TRUE(at_rest.at_stop);
  Simulation simulation = lay.simulation();
  EXPECT_NEAR(reading(simulation).stop_moment, at_rest.stop_moment, 5e-3 * std::abs(at_rest.stop_moment));
  ASSERT_TRUE(simulation.advance(simulation.end()));
  EXPECT_NEAR(reading(simulation).stop_moment, at_rest.stop_moment, 0.02 * std::abs(at_rest.stop_moment));
  EXPECT_NEAR(reading(simulation).angle, at_rest.angle, 1e-5);
}

/// A barge that pitches under a stinger on tanks, in regular waves.
Description pitching() {
  Description d = calm("HS16-tanks");
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.harmonic["pitch"] = {0.01, 7.0, 0.0};
  d.environment.waves.front().type = WaveType::airy;
  d.environment.waves.front().height = 1.0;
  d.environment.waves.front().period = 7.0;
  return d;
}

TEST(floating_stinger, on_a_pitching_barge_exchanges_no_energy_but_what_is_accounted_for) {
  const InTime lay(pitching());
  Simulation simulation = lay.simulation();
  double low = 9.0, high = -9.0;
  while (simulation.step()) {
    low = std::min(low, reading(simulation).angle);
    high = std::max(high, reading(simulation).angle);
  }
  ASSERT_TRUE(simulation.finished());
  EXPECT_GT(high - low, 2e-3);
  EXPECT_LT(std::abs(simulation.energy().drift()), 0.01);
}

TEST(floating_stinger, resumes_from_a_checkpoint_bit_for_bit) {
  const InTime lay(pitching());
  Simulation whole = lay.simulation(), resumed = lay.simulation();
  ASSERT_TRUE(whole.advance(0.0));
  const DynamicCheckpoint checkpoint = whole.checkpoint();
  resumed.restore(checkpoint);
  ASSERT_TRUE(whole.advance(1.0));
  ASSERT_TRUE(resumed.advance(1.0));
  EXPECT_EQ(reading(whole).angle, reading(resumed).angle);
  EXPECT_EQ(whole.present().state->lines[0].q, resumed.present().state->lines[0].q);
}

TEST(floating_stinger, that_the_ship_holds_is_part_of_the_vessel) {
  Description d = calm("HS16-tanks");
  d.supports.sections.front().angle = 0.01;
  const InTime lay(d);
  const Simulation simulation = lay.simulation();
  EXPECT_TRUE(simulation.present().assembly->hinged().empty());
  EXPECT_EQ(simulation.system().bodies.size(), 1U);
}

/// The barge floats free, held by springs in surge, sway and yaw.
Description afloat() {
  Description d = pitching();
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
  d.station_keeping->stiffness = Vec3(1.8479e5, 1.8479e5, 5.1281e8);
  d.station_keeping->damping = Vec3(4e5, 4e5, 1e9);
  return d;
}

// Hull, pipe and stinger reach equilibrium together before they are released: the far end pulls the hull by a metre
// against its springs, the pipe lies otherwise on the rollers, and the stinger, which floats softly, turns by half a
// degree.
TEST(floating_stinger, on_a_hull_that_floats_free_starts_from_rest_and_keeps_account_of_its_energy) {
  const InTime lay(afloat());
  ASSERT_FALSE(unsupported_in_dynamics(lay.model));
  Simulation simulation = lay.simulation();
  ASSERT_FALSE(simulation.failure());
  const std::vector<HullState> first = simulation.present().state->bodies;
  ASSERT_EQ(first.size(), 2U);
  EXPECT_LT(first[0].acc.head<3>().norm(), 1e-6 * kGravity);
  EXPECT_LT(std::abs(first[1].acc(kHingeFreedom)), 1e-5);
  EXPECT_NEAR(reading(simulation).angle, lay.statics.stinger.at(0).angle, 0.02);
  ASSERT_TRUE(simulation.advance(simulation.end()));
  EXPECT_GT(std::abs(simulation.present().state->bodies[0].h(2) - first[0].h(2)), 1e-3);
  EXPECT_LT(std::abs(simulation.energy().drift()), 0.01);
}

}  // namespace
}  // namespace overbend
