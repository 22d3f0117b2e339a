/// BGL-1 afloat under its pipe on eight mooring lines of elements.
#include "dynamics/mooring_lines.h"

#include <gtest/gtest.h>

#include "dynamics/dynamic_obstacle.h"
#include "dynamics/simulation.h"
#include "modelfile/yaml_reader.h"
#include "statics/moored_lay.h"

namespace overbend {
namespace {

Description moored() {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-moored.yaml").description.value();
  d.environment.waves.components = 40;
  d.mesh.overbend_element = 1.0;
  d.mesh.touchdown_element = 3.0;
  d.mesh.longest_element = 8.0;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 1.0;
  d.dynamics->build_up = 2.0;
  return d;
}

struct Moored {
  explicit Moored(const Description& d) : model(build_model(d)), lay(solve_lay(model)) {}
  Model model;
  LayOutcome lay;
  double tension() const { return model.description.tensioner.tension.value(); }
};

double fairlead_tension(const Simulation& simulation, std::size_t line) {
  const std::array<double, 6>& force = simulation.now().assembly->line(line).end_force(LineEnd::last);
  return Vec3(force[0], force[1], force[2]).norm();
}

TEST(mooring_lines, hold_the_barge_in_calm_water_with_the_tensions_of_the_catenaries) {
  Description d = moored();
  d.environment.waves.type = WaveType::none;
  d.environment.current.clear();
  // The catenaries were pulled out over a bed that rubs; elements come to rest on one that does not.
  for (MooringLineDescription& line : d.moorings->lines) {
    for (LineSegmentDescription& segment : line.segments) segment.type.friction = 0.0;
  }
  const Moored at(d);
  ASSERT_FALSE(at.lay.failure) << at.lay.failure->why;
  ASSERT_FALSE(dynamic_obstacle(at.model));
  Simulation simulation(at.model, *at.lay.solution, at.tension(), dynamic_options(at.model));
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->what;
  ASSERT_EQ(simulation.moorings().size(), 8u);
  const HullState first = simulation.now().state->bodies.at(0);
  EXPECT_LT(first.acc.head<3>().norm(), 1e-6 * kGravity);
  EXPECT_LT(first.h.head<2>().norm(), 0.02);  // as drawn, but for elements in place of catenaries
  for (std::size_t i = 0; i < 8; ++i) {
    const double catenary = at.lay.moorings->rest.moorings[i].fairlead_tension;
    EXPECT_NEAR(fairlead_tension(simulation, i + 1), catenary, 0.002 * catenary) << i;
  }
  while (simulation.step()) {
  }
  ASSERT_FALSE(simulation.failure());
  EXPECT_LT((simulation.now().state->bodies[0].h - first.h).norm(), 1e-5);
}

TEST(mooring_lines, let_the_barge_start_at_rest_under_the_mean_drift_of_its_sea) {
  Description d = moored();
  d.environment.current.clear();
  const Moored at(d);
  ASSERT_FALSE(at.lay.failure) << at.lay.failure->why;
  const auto start_of = [&](std::optional<bool> mean_drift) {
    Model model = at.model;
    model.description.statics.mean_drift = mean_drift;
    const Simulation simulation(model, *at.lay.solution, at.tension(), dynamic_options(model));
    EXPECT_FALSE(simulation.failure());
    return simulation.now().state->bodies.at(0);
  };
  const HullState drifted = start_of(std::nullopt), undrifted = start_of(false);
  EXPECT_LT(drifted.acc.head<3>().norm(), 1e-6 * kGravity);
  EXPECT_LT(drifted.acc.tail<3>().norm(), 1e-7);
  // 217.8 kN from the beam shift the barge on lines that balance the pipe by 1.184 m; these few components have less.
  const Sea sea = make_sea(d.environment.waves, d.environment.water_depth, 0.0, d.environment.waves.seed);
  const CoupledHullDescription& hull = *d.vessel.coupled;
  const double drift = mean_drift(make_hull_waves(*hull.data, sea, hull.wave_drift, d.vessel.draught, 0.0), 0.0)(1);
  const double expected = 1.184 * drift / 217.8e3;
  EXPECT_NEAR(drifted.h(1) - undrifted.h(1), expected, 0.03 * expected);
  EXPECT_LT(std::abs(undrifted.h(1)), 0.02);
}

TEST(mooring_lines, go_with_the_barge_through_waves_and_keep_account_of_their_energy) {
  const Moored at(moored());
  ASSERT_FALSE(at.lay.failure) << at.lay.failure->why;
  Simulation simulation(at.model, *at.lay.solution, at.tension(), dynamic_options(at.model));
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->what;
  simulation.advance(0.5);
  const DynamicCheckpoint checkpoint = simulation.checkpoint();
  simulation.advance(1.0);
  ASSERT_FALSE(simulation.failure());
  EXPECT_LT(std::abs(simulation.energy().drift()), 5e-3);  // of little that has passed so soon
  Simulation resumed(at.model, *at.lay.solution, at.tension(), dynamic_options(at.model));
  resumed.restore(checkpoint);
  resumed.advance(1.0);
  EXPECT_EQ(simulation.now().state->bodies[0].h, resumed.now().state->bodies[0].h);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(simulation.now().state->lines[i].q, resumed.now().state->lines[i].q) << i;
  }
}

TEST(mooring_lines, are_refused_in_time_where_more_is_asked_of_them_than_to_hold) {
  const auto refused = [](const std::function<void(Description&)>& change) {
    Description d = moored();
    change(d);
    return dynamic_obstacle(build_model(d)).has_value();
  };
  EXPECT_FALSE(refused([](Description&) {}));
  EXPECT_TRUE(refused([](Description& d) { d.moorings->model = MooringModel::quasi_static; }));
  EXPECT_TRUE(refused([](Description& d) { d.operation.type = OperationType::pull_ahead; }));
  EXPECT_TRUE(refused([](Description& d) { d.moorings->winches.front().mode = WinchMode::tension; }));
  EXPECT_TRUE(refused([](Description& d) { d.moorings->lines.front().fails_at = 100.0; }));
  EXPECT_TRUE(refused([](Description& d) { d.vessel.motion = VesselMotion::fixed; }));
}

}  // namespace
}  // namespace overbend
