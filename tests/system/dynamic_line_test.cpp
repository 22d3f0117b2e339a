#include "system/dynamic_line.h"

#include <gtest/gtest.h>

#include "dynamics/run_setup.h"
#include "support/bgl1_in_time.h"

namespace overbend {
namespace {

/// The BGL-1 lying still on its rollers, held by its brake.
class StandingLine {
 public:
  StandingLine()
      : at_(testing::workable()),
        setup_(make_setup(at_.model, at_.start, at_.statics.top_tension, dynamic_options(at_.model))),
        tensioner_(tensioner_place(at_.model, at_.start)) {
    setup_.line.surroundings = [this](double /*time*/, Surroundings& now) {
      now.vessel.pose = at_.model.mean_pose;
      now.vessel.pose.p_WV.z() -= sunk;
      const DirectionMotion direction = direction_motion(now.vessel, tensioner_.direction_V);
      now.top.place = point_motion(now.vessel, tensioner_.place_V).place;
      now.top.direction = direction.direction;
      now.anchor = anchor_motion(at_.start);
    };
  }
  const DynamicLine& line() const { return setup_.line; }
  DynamicState state() const { return state_at_rest(setup_.line, at_.start.state.q, 0.0); }

  double sunk = 0.0;  ///< The barge, and its rollers with it [m].

 private:
  testing::Case at_;
  RunSetup setup_;
  TensionerPlace tensioner_;
};

TEST(renewed_contacts, give_the_step_of_a_full_tangent_where_rollers_sink_away_from_the_pipe) {
  StandingLine standing;
  const DynamicLine& line = standing.line();
  DynamicSystem system(line);
  const StepShares shares{60.0, 3600.0, 0.02};  // of a step of about 1/30 s
  DynamicState state = standing.state();
  const DynamicState before = state;
  system.set_time(0.0, state);
  system.evaluate(state, before, shares, true);
  const std::uint64_t signature = system.contact_signature();
  system.hold(true);
  std::vector<double> dq(state.q.size());
  ASSERT_TRUE(system.solve_factored(dq));

  standing.sunk = 0.004;  // rollers give a millimetre under the pipe
  system.set_time(0.0, state);
  const auto step = [&](bool with_tangent, const auto& solve) {
    system.evaluate(state, before, shares, with_tangent);
    system.hold(with_tangent);
    solve();
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(dq.data(), static_cast<Eigen::Index>(dq.size())));
  };
  const Eigen::VectorXd old = step(false, [&] { system.solve_again(dq); });
  ASSERT_NE(system.contact_signature(), signature);
  const Eigen::VectorXd renewed = step(false, [&] {
    ASSERT_TRUE(system.renew_contacts(state, shares));
    system.solve_again(dq);
  });
  const Eigen::VectorXd full = step(true, [&] { ASSERT_TRUE(system.solve_factored(dq)); });
  EXPECT_GT((old - full).norm(), 0.3 * full.norm());
  EXPECT_LT((renewed - full).norm(), 1e-9 * full.norm());  // rounding: the line itself has not moved
}

}  // namespace
}  // namespace overbend
