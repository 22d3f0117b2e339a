// A pipe over a sleeper in time.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "dynamics/run/simulation.h"
#include "dynamics/setup/laid_tail.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/statics.h"

namespace overbend {
namespace {

/// BP24-sleeper with friction and damping of the bed, rollers soft enough for steps of a tenth of a second.
Description over_sleeper() {
  Description d = read_model(OVERBEND_SOURCE_DIR "/validation/bed_cases/BP24-sleeper.yaml").description.value();
  d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = 0.4;
  d.environment.seabed.damping = 5e3;
  for (RollerKindDescription& kind : d.rollers) kind.stiffness = 2e7;
  d.tensioner.mode = TensionerMode::locked;
  d.mesh.overbend_element = 2.0;
  d.mesh.max_element_length = 8.0;
  d.dynamics = DynamicSettings{};
  d.dynamics->build_up = 1.0;
  return d;
}

struct InTime {
  explicit InTime(const Description& d, double duration)
      : model(build_model(d)), start(solve_statics(model).solution.value()) {
    DynamicOptions options = dynamic_options(model);
    options.duration = duration;
    simulation = std::make_unique<Simulation>(model, start, *d.tensioner.tension, options);
  }
  Model model;
  StaticSolution start;
  std::unique_ptr<Simulation> simulation;
};

TEST(uneven_bed_in_time, pipe_at_rest_stays_at_rest) {
  InTime run(over_sleeper(), 2.0);
  const std::vector<double> before = run.start.state.q;
  while (run.simulation->step()) {
  }
  EXPECT_FALSE(run.simulation->failure());
  const std::vector<double>& after = run.simulation->present().pipe().q;
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) ASSERT_NEAR(after[i], before[i], 1e-5) << i;
}

TEST(uneven_bed_in_time, energy_of_a_pipe_that_rocks_on_the_sleeper_is_accounted_for) {
  Description d = over_sleeper();
  d.environment.waves.front().type = WaveType::airy;
  d.environment.waves.front().height = 3.0;
  d.environment.waves.front().period = 8.0;
  InTime run(d, 6.0);
  const std::vector<double> before = run.start.state.q;
  while (run.simulation->step()) {
  }
  EXPECT_FALSE(run.simulation->failure());
  EXPECT_NE(run.simulation->present().pipe().q, before);
  EXPECT_LT(std::abs(run.simulation->energy().drift()), 5e-3);
}

TEST(uneven_bed_in_time, laid_pipe_ends_where_statics_has_it) {
  Description d = over_sleeper();
  d.pipe.length.reset();
  const Model model = build_model(d);
  const StaticSolution start = solve_statics(model).solution.value();
  EXPECT_EQ(with_laid_tail(model, start, *d.tensioner.tension, 1.0).mesh.s, start.mesh.s);
}

}  // namespace
}  // namespace overbend
