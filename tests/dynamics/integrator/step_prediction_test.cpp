#include "dynamics/integrator/step_prediction.h"

#include <gtest/gtest.h>

#include <functional>

namespace overbend {
namespace {

constexpr double kStep = 0.1;
constexpr std::size_t kFreedoms = 18;  // of three nodes: more than a register holds, and no whole number of them

/// A line alone with prescribed accelerations.
class PrescribedLine {
 public:
  explicit PrescribedLine(std::function<double(int step, std::size_t freedom)> acceleration)
      : acceleration_(std::move(acceleration)) {
    now_.lines.resize(1);
    LineState& line = now_.lines.front();
    for (std::vector<double>* part : {&line.q, &line.v, &line.acc, &line.algorithmic_acceleration})
      part->assign(kFreedoms, 0.0);
    for (std::size_t i = 0; i < kFreedoms; ++i) line.acc[i] = line.algorithmic_acceleration[i] = acceleration_(0, i);
    next_ = now_;
  }

  /// Predicts a step and returns the predicted accelerations.
  std::vector<double> step(double h = kStep) {
    predict(scheme, assembly_, now_, h, {}, next_);
    LineState& line = next_.lines.front();
    const std::vector<double> predicted = line.acc;
    ++steps_;
    std::vector<double> dq(kFreedoms);
    for (std::size_t i = 0; i < kFreedoms; ++i) {
      dq[i] = (acceleration_(steps_, i) - line.acc[i]) / scheme.acceleration_share(h);
    }
    correct(scheme, h, dq, line);
    end_accelerations(scheme, now_, next_);
    std::swap(now_, next_);
    return predicted;
  }

  const LineState& line() const { return now_.lines.front(); }
  double time() const { return kStep * steps_; }

  const GeneralizedAlpha scheme{0.8};

 private:
  std::function<double(int, std::size_t)> acceleration_;
  System system_;
  Assembly assembly_{system_};
  SystemState now_, next_;
  int steps_ = 0;
};

TEST(step_prediction, foresees_the_whole_of_a_steady_change) {
  PrescribedLine line([](int step, std::size_t i) { return 1.0 + static_cast<double>(i) * kStep * step; });
  std::vector<double> predicted;
  for (int i = 0; i < 60; ++i) predicted = line.step();
  EXPECT_NEAR(line.line().acceleration_extrapolation, line.scheme.full_extrapolation, 1e-9);
  for (std::size_t i = 0; i < kFreedoms; ++i) EXPECT_NEAR(predicted[i], line.line().acc[i], 1e-9) << i;
}

TEST(step_prediction, extrapolates_nothing_of_what_alternates_from_step_to_step) {
  PrescribedLine line(
      [](int step, std::size_t i) { return (step % 2 == 0 ? 1.0 : -1.0) * (1.0 + static_cast<double>(i)); });
  for (int i = 0; i < 5; ++i) line.step();
  const std::vector<double> before = line.line().acc;
  EXPECT_EQ(line.line().acceleration_extrapolation, 0.0);
  EXPECT_EQ(line.step(), before);
}

TEST(step_prediction, foresees_nothing_after_a_step_of_another_length) {
  PrescribedLine line([](int step, std::size_t i) { return 1.0 + static_cast<double>(i) * kStep * step; });
  for (int i = 0; i < 60; ++i) line.step();
  const std::vector<double> before = line.line().acc;
  EXPECT_EQ(line.step(0.5 * kStep), before);
}

// Values and rates after steps of a steadily changing acceleration are those of its integrals: the scheme is of second
// order, and what it misses of a cubic is a constant times the square of the step.
TEST(step_prediction, corrections_lead_to_the_motion_of_the_prescribed_accelerations) {
  PrescribedLine line([](int step, std::size_t i) { return 2.0 + static_cast<double>(i) * kStep * step; });
  for (int i = 0; i < 50; ++i) line.step();
  const double t = line.time();
  for (std::size_t i = 0; i < kFreedoms; ++i) {
    const double slope = static_cast<double>(i);
    EXPECT_NEAR(line.line().v[i], 2.0 * t + 0.5 * slope * t * t, slope * kStep * kStep + 1e-12) << i;
    EXPECT_NEAR(line.line().q[i], t * t + slope * t * t * t / 6.0, slope * kStep * kStep * t + 1e-12) << i;
  }
}

}  // namespace
}  // namespace overbend
