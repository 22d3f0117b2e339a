#include "system/assembly.h"

#include <gtest/gtest.h>

#include "dynamics/run_setup.h"
#include "support/bgl1_in_time.h"

namespace overbend {
namespace {

/// The BGL-1 lying still on its rollers, held by its brake.
class StandingPipe {
 public:
  StandingPipe()
      : at_(testing::workable()),
        setup_(make_setup(at_.model, at_.start, at_.statics.top_tension, dynamic_options(at_.model))) {
    setup_.system.surroundings = [this](double /*time*/, Surroundings& now) {
      now.bodies.front().pose = at_.model.mean_pose;
      now.bodies.front().pose.p_WV.z() -= sunk;
      lead_attachments(setup_.system, now);
    };
  }
  const System& system() const { return setup_.system; }
  SystemState state() const { return state_at_rest(setup_.system, {at_.start.state.q}, 0.0); }

  double sunk = 0.0;  ///< The barge, and its rollers with it [m].

 private:
  testing::Case at_;
  RunSetup setup_;
};

Eigen::VectorXd vector_of(const Increments& dq) {
  return Eigen::Map<const Eigen::VectorXd>(dq[0].data(), static_cast<Eigen::Index>(dq[0].size()));
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
    return vector_of(dq);
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

}  // namespace
}  // namespace overbend
