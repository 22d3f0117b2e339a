#include "recording/advance_row.h"

#include <gtest/gtest.h>

#include <thread>

namespace overbend {
namespace {

/// Rows every second of simulated time, with steps of prescribed length.
struct PacedRun {
  double step_length = 0.25;
  std::chrono::milliseconds pace{0};
  int steps = 0;
  double t = 0.0;

  double time() const { return t; }
  double next_row() const { return 1.0; }
  bool step() {
    std::this_thread::sleep_for(pace);
    t += step_length;
    ++steps;
    return true;
  }
};

TEST(reach_row, goes_to_the_row) {
  PacedRun run;
  EXPECT_TRUE(reach_row(run));
  EXPECT_EQ(run.steps, 4);
}

TEST(reach_row, a_row_that_is_near_is_still_met) {
  const InterruptionScope scope([] { return true; });
  PacedRun run;
  EXPECT_TRUE(reach_row(run));
  EXPECT_EQ(run.steps, 4);
}

TEST(reach_row, a_row_that_takes_long_is_given_up) {
  const InterruptionScope scope([] { return true; });
  PacedRun run{1e-6, std::chrono::milliseconds(1)};  // a quarter of an hour
  EXPECT_FALSE(reach_row(run));
  EXPECT_LT(run.time(), 1.0);
}

}  // namespace
}  // namespace overbend
