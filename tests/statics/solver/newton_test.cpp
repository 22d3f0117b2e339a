#include "statics/solver/newton.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/starting_point.h"

namespace overbend {
namespace {

/// The J-lay reference case on its first guess.
struct Start {
  Model model =
      build_model(read_model(OVERBEND_SOURCE_DIR "/validation/static_cases/J12-D400-T560.yaml").description.value());
  StartingPoint from = starting_point(model, lay_plane(model, model.mean_pose));
  StaticSystem system{model, model.mean_pose, build_mesh(model, from.zones)};
  LineState state = sample_shape(system, from.shape);

  NewtonReport solve(NewtonSettings settings = {}) {
    settings.target = from.target;
    return solve_equilibrium(system, state, settings);
  }
};

TEST(newton, meets_the_tension_and_the_balance_together) {
  Start start;
  const NewtonReport report = start.solve();
  ASSERT_TRUE(report.converged());
  start.system.evaluate(start.state, false);
  EXPECT_NEAR(start.system.target_error(start.state, start.from.target), 0.0, 1e-9 * start.system.total_weight());
}

TEST(newton, every_step_from_nearby_falls_threefold_and_the_last_gains_four_digits) {
  Start start;
  NewtonSettings near;
  near.tolerance = 1e-3;
  ASSERT_TRUE(start.solve(near).converged());
  std::vector<double> residuals;
  for (int i = 0; i < 5; ++i) {
    NewtonSettings settings;
    settings.max_iterations = 0;
    residuals.push_back(start.solve(settings).residual);
  }
  // Gauss points that touch or leave the bed keep the first steps from doubling their digits; with the exact tangent
  // each still falls, and the last, where nothing changes contact, gains four digits.
  for (std::size_t i = 1; i + 1 < residuals.size(); ++i) {
    EXPECT_LT(residuals[i], residuals[i - 1] / 3.0);
  }
  EXPECT_LT(residuals.back(), 1e-4 * residuals[residuals.size() - 2]);
  EXPECT_LT(residuals.back(), 1e-10);
}

TEST(newton, a_state_that_is_not_a_number_is_lost_and_never_converged) {
  Start start;
  start.state.q[100] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(start.solve().end, NewtonEnd::lost);
}

}  // namespace
}  // namespace overbend
