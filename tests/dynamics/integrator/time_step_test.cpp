#include "dynamics/integrator/time_step.h"

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
    now_.lines.front().algorithmic_acceleration = now_.lines.front().acc;
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

/// A long rod at rest, and next to it a short string between two points.
System rod_and_string() {
  System system = testing::rod_system({1e6, 1e3, 10.0}, 32.0, 32);
  system.lines.push_back(testing::rod_system({1e6, 1.0, 1.0}, 4.0, 4).lines.front());
  for (const LineEnd end : {LineEnd::first, LineEnd::last}) {
    Attachment held;
    held.line = 1;
    held.end = end;
    held.hold_place = true;
    system.attachments.push_back(held);
  }
  for (Line& line : system.lines) line.force_scale = 100.0;
  system.surroundings = [](double, Surroundings& surroundings) {
    surroundings.ends[2].place = Vec3::Zero();
    surroundings.ends[3].place = Vec3(4.004, 0.0, 0.0);
  };
  return system;
}

SystemState rod_and_string_at_rest(const System& system) {
  std::vector<double> string;
  for (const double s : system.lines[1].mesh.s) string.insert(string.end(), {1.001 * s, 0.0, 0.0, 1.001, 0.0, 0.0});
  return state_at_rest(system, {testing::straight(system, Vec3(0.0, 5.0, 0.0), Vec3::UnitX()), string}, 0.0);
}

// The string stiffens as it is struck: old factors lead to its balance slowly, and the rod's are of no concern to it.
TEST(time_step, makes_factors_anew_for_the_one_line_that_needs_them) {
  const System system = rod_and_string();
  const StepSettings settings{0.8, 1e-8, 20};
  const auto struck = [&](bool anew) {
    Assembly assembly(system);
    TimeStepper stepper(assembly, settings);
    SystemState state = rod_and_string_at_rest(system), next = state;
    EXPECT_TRUE(stepper.step(state, 0.01, next).converged());
    std::swap(state, next);
    if (anew) stepper.forget();
    for (std::size_t node = 1; node < 4; ++node) state.lines[1].v[6 * node + 2] += 4.0;
    const StepReport report = stepper.step(state, 0.01, next);
    EXPECT_TRUE(report.converged());
    return std::pair{report, next};
  };
  const auto [report, state] = struck(false);
  const auto [reference, same] = struck(true);
  EXPECT_GT(state.lines[1].q[6 * 2 + 2], 0.01);
  EXPECT_EQ(report.factorisations, 0);
  EXPECT_GT(reference.factorisations, 0);
  EXPECT_LE(report.iterations, 7);
  for (std::size_t i = 0; i < state.lines[1].q.size(); ++i) {  // 1e-6 N are left, over a mass of about 1e4 N/m
    EXPECT_NEAR(state.lines[1].q[i], same.lines[1].q[i], 1e-9) << i;
  }
}

}  // namespace
}  // namespace overbend
