#include "dynamics/time_step.h"

#include <gtest/gtest.h>

#include "support/moving_rod.h"

namespace overbend {
namespace {

/// A rod that nothing holds and nothing loads, with its integrator.
class FreeRod {
 public:
  FreeRod() : assembly_(system_), stepper_(assembly_, {0.8, 1e-6, 20}) {
    now_ = state_at_rest(system_, {testing::straight(system_, Vec3::Zero(), Vec3::UnitX())}, 0.0);
    assembly_.set_time(0.0, now_);
    EXPECT_TRUE(assembly_.find_accelerations(now_));
    now_.lines.front().alg = now_.lines.front().acc;
    next_ = now_;
  }
  StepReport step(double h) {
    const StepReport report = stepper_.step(now_, h, next_);
    EXPECT_TRUE(report.converged());
    error_ = stepper_.local_error(now_, next_);
    std::swap(now_, next_);
    return report;
  }
  /// Moves the middle node across the rod.
  void kick(double velocity) { now_.lines.front().v[6 * 4 + 2] += velocity; }
  double error() const { return error_; }

 private:
  System system_ = testing::rod_system({1e6, 1e3, 10.0}, 8.0, 8);
  Assembly assembly_;
  TimeStepper stepper_;
  SystemState now_, next_;
  double error_ = 0.0;
};

TEST(time_step, at_rest_has_factors_that_serve_the_next_step) {
  FreeRod rod;
  EXPECT_EQ(rod.step(0.01).factorisations, 1);
  EXPECT_EQ(rod.error(), 0.0);
  rod.kick(1e-4);
  const StepReport kicked = rod.step(0.01);
  EXPECT_EQ(kicked.factorisations, 0);
  EXPECT_LE(kicked.iterations, 2);
  EXPECT_GT(rod.error(), 0.0);
}

TEST(time_step, of_another_length_makes_factors_of_its_own) {
  FreeRod rod;
  rod.kick(1e-4);
  EXPECT_EQ(rod.step(0.01).factorisations, 1);
  EXPECT_EQ(rod.step(0.01).factorisations, 0);
  EXPECT_EQ(rod.step(0.02).factorisations, 1);
}

}  // namespace
}  // namespace overbend
