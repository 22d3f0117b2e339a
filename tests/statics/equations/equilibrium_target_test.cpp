#include "statics/equations/equilibrium_target.h"

#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/starting_point.h"

namespace overbend {
namespace {

/// The J-lay reference case on its first guess.
struct Guess {
  Model model =
      build_model(read_model(OVERBEND_SOURCE_DIR "/validation/static_cases/J12-D400-T560.yaml").description.value());
  LayPlane plane = lay_plane(model, model.mean_pose);
  StartingPoint from = starting_point(model, plane);
  StaticSystem system{model, model.mean_pose, build_mesh(model, from.zones)};
  LineState state = sample_shape(system, from.shape);

  TargetEquation equation(EquilibriumTarget::Kind kind, double value, const LineState& line_state) const {
    return target_equation({kind, value}, plane, system.line(), line_state);
  }
};

// In the strained tangent the tension is not linear: the step is short enough for its square to vanish.
TEST(equilibrium_target, changes_with_its_node_as_its_gradient_says) {
  constexpr double kStep = 1e-6;
  const Guess guess;
  for (const auto kind : {EquilibriumTarget::Kind::top_tension, EquilibriumTarget::Kind::anchor_distance}) {
    const TargetEquation equation = guess.equation(kind, 500.0, guess.state);
    const std::size_t first = 6 * static_cast<std::size_t>(equation.node) + (equation.tangent ? 3 : 0);
    for (std::size_t i = 0; i < 3; ++i) {
      LineState less = guess.state, more = guess.state;
      less.q[first + i] -= kStep;
      more.q[first + i] += kStep;
      const double change = guess.equation(kind, 500.0, more).error - guess.equation(kind, 500.0, less).error;
      EXPECT_NEAR(change / (2.0 * kStep), equation.gradient(static_cast<Eigen::Index>(i)),
                  1e-6 * equation.gradient.norm());
    }
  }
}

TEST(equilibrium_target, errs_by_what_the_value_is_beyond_what_is_asked_for) {
  const Guess guess;
  const auto error = [&](double asked) {
    return guess.equation(EquilibriumTarget::Kind::anchor_distance, asked, guess.state).error;
  };
  EXPECT_NEAR(error(100.0) - error(130.0), 30.0, 1e-10);
  EXPECT_NEAR(error(0.0), (Eigen::Map<const Vec3>(guess.state.q.data()) - guess.plane.tensioner_W).head<2>().norm(),
              1e-9);  // the far end lies in the plane of the lay
}

}  // namespace
}  // namespace overbend
