#include "dynamics/setup/laid_tail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

using testing::EmptySink;
using testing::TimedLay;
using testing::workable;

TEST(laid_tail, carries_the_line_on_straight_along_the_bed) {
  const TimedLay c(workable());
  const StaticSolution longer = with_laid_tail(c.model, c.start, c.statics.top_tension, 1.0);
  EXPECT_LT(longer.mesh.s.front(), -0.99 * friction_anchorage_length(c.model, c.statics.top_tension));
  EXPECT_EQ(longer.mesh.s.back(), c.start.mesh.s.back());
  EXPECT_EQ(longer.state.q.size(), 6 * longer.mesh.s.size());
  const std::size_t added = longer.mesh.s.size() - c.start.mesh.s.size();
  for (std::size_t i = 0; i < added; ++i) {
    EXPECT_NEAR(longer.state.q[6 * i + 2], c.start.state.q[2], 1e-9);  // as deep in the level bed
    EXPECT_GT(longer.mesh.s[i + 1], longer.mesh.s[i]);
  }
}

/// Bed that falls or rises astern of a barge in calm water.
Description sloping(double slope, double towards) {
  Description d = workable();
  d.environment.waves.front().type = WaveType::none;
  d.environment.current.clear();
  d.vessel.motion = VesselMotion::fixed;
  d.environment.seabed.slope = slope;
  d.environment.seabed.slope_towards = towards;
  return d;
}
constexpr double kAstern = 1.5 * std::numbers::pi, kAhead = 0.5 * std::numbers::pi;  // the barge heads east

TEST(laid_tail, keeps_a_line_at_rest_on_a_slope_at_rest) {
  const TimedLay c(sloping(0.07, kAstern));
  EmptySink sink;
  const DynamicResults run = c.results(sink);
  EXPECT_LT(run.top_tension.max - run.top_tension.min, 2.0);  // of 250 kN
}

TEST(laid_tail, ends_before_a_bed_that_rises_takes_it_out_of_the_water) {
  const TimedLay c(sloping(0.1, kAhead));
  const StaticSolution longer = with_laid_tail(c.model, c.start, c.statics.top_tension, 1.0);
  EXPECT_LT(longer.mesh.s.front(), -100.0);
  EXPECT_GT(longer.mesh.s.front(), -0.9 * friction_anchorage_length(c.model, c.statics.top_tension));
  EXPECT_LT(longer.state.q[2], 0.0);
}

TEST(laid_tail, is_not_added_where_the_anchor_is_real_or_nothing_holds_the_pipe) {
  Description given = workable();
  given.pipe.length = 700.0;
  Description slippery = workable();
  slippery.environment.seabed.friction_axial = 0.0;
  for (const Description& d : {given, slippery}) {
    const TimedLay c(d);
    EXPECT_EQ(with_laid_tail(c.model, c.start, c.statics.top_tension, 1.0).mesh.s, c.start.mesh.s);
  }
}

TEST(laid_tail, twice_as_long_changes_nothing) {
  Description d = workable();
  d.dynamics->duration = 40.0;
  d.tensioner.mode = TensionerMode::locked;
  const TimedLay c(d);
  DynamicOptions options = dynamic_options(c.model);
  EmptySink a, b;
  const DynamicResults once = c.run(a, options).results.value();
  options.tail_reach = 2.0;
  const DynamicResults twice = c.run(b, options).results.value();
  EXPECT_NEAR(twice.top_tension.std, once.top_tension.std, 0.002 * once.top_tension.std);
  EXPECT_EQ(once.station_s, twice.station_s);  // neither is recorded
}

}  // namespace
}  // namespace overbend
