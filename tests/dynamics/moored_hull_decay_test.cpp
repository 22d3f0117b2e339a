/// BGL-1 without its pipe on eight quasi-static lines: decays in still water.
#include <gtest/gtest.h>

#include "dynamics/integrator/time_step.h"
#include "dynamics/setup/quasi_static_lines.h"
#include "moorings/bgl1_spread.h"
#include "support/free_body.h"
#include "support/hull_case.h"

namespace overbend {
namespace {

using namespace testing;

/// The hull at rest as drawn, ballasted against the lines' pull, from which one freedom is displaced.
class Decay {
 public:
  Decay() : hull_(made_bgl1_hull().hull), assembly_(made()), stepper_(assembly_, {1.0, 1e-9, 30}) {}
  Decay(const Decay&) = delete;
  Decay& operator=(const Decay&) = delete;

  /// Time between the first two passages of the rest in one direction [s]; half of it where there was but one.
  double period(int freedom, double kick) {
    SystemState state = state_at_rest(system_, {}, 0.0), next;
    trim(state);
    const double rest = state.bodies[0].h(freedom);
    state.bodies[0].h(freedom) += kick;
    state.bodies[0].slow = slow_motion_at_rest(state.bodies[0].h);
    assembly_.set_time(0.0, state);
    assembly_.impose_ends(state);
    EXPECT_TRUE(assembly_.find_accelerations(state));
    state.bodies[0].algorithmic_acceleration = state.bodies[0].acc;
    next = state;
    double first = 0.0;
    int passages = 0;
    while (state.time < 200.0) {
      const double before = state.bodies[0].h(freedom) - rest;
      EXPECT_TRUE(stepper_.step(state, kStep, next).converged()) << state.time;
      std::swap(state, next);
      const double after = state.bodies[0].h(freedom) - rest;
      if (before * after > 0.0) continue;
      const double passed = state.time - kStep * after / (after - before);
      if (++passages == 1) first = passed;
      if (passages == 3) return passed - first;
    }
    return 0.0;
  }

 private:
  static constexpr double kStep = 0.25;  // [s]

  const System& made() {
    system_.bodies.resize(1);
    FreeBody& body = system_.bodies[0].free.emplace(free_hull(hull_, force_scale(lines_.spread, std::nullopt), 120.0));
    body.springs = quasi_static_lines(lines_.spread, {});
    system_.surroundings = surroundings_at_rest(system_);
    return system_;
  }
  /// Heave, roll and pitch as drawn.
  void trim(SystemState& state) {
    assembly_.set_time(0.0, state);
    assembly_.impose_ends(state);
    SystemState system_state = state;
    assembly_.evaluate(system_state, state, {}, false);
    for (Eigen::Index i = 2; i < 5; ++i) hull_.ballast(i) += assembly_.body_residual()[static_cast<std::size_t>(i)];
  }

  MooredCase lines_ = moored_case(bgl1_barge());
  Hull hull_;
  System system_;
  Assembly assembly_;
  TimeStepper stepper_;
};

/// Eigenvalues of hull, fitted memory and the lines' stiffness, by an independent prototype; the kicks are so small
/// that the lines are linear.
TEST(moored_hull, swings_with_the_periods_of_hull_water_and_lines) {
  const struct {
    int freedom;
    double kick, period;
  } modes[] = {{0, 0.05, 66.96}, {1, 0.05, 77.15}, {5, 0.001, 44.64}};
  for (const auto& mode : modes) {
    EXPECT_NEAR(Decay().period(mode.freedom, mode.kick), mode.period, 0.005 * mode.period) << mode.freedom;
  }
}

}  // namespace
}  // namespace overbend
