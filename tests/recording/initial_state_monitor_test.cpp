#include "recording/initial_state_monitor.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

struct Watched {
  Model model;
  NodeValues nodes;
  VesselPose vessel;

  explicit Watched(WaveType waves = WaveType::none) {
    model.description.environment.waves.front().type = waves;
    model.description.vessel.motion = waves == WaveType::none ? VesselMotion::fixed : VesselMotion::raos;
    nodes.x = {0.0, 10.0, 20.0};
    nodes.y = nodes.z = {0.0, 0.0, 0.0};
  }
  InitialStateMonitor started(bool moved = false) const {
    InitialStateMonitor watch(model, 60.0, moved);
    watch.start(nodes, vessel);
    return watch;
  }
  /// The middle node aside by this.
  void push(double y) { nodes.y[1] = y; }
};

TEST(start_watch, a_departure_in_calm_water_is_kept_at_its_largest) {
  Watched run;
  InitialStateMonitor watch = run.started();
  for (const auto& [y, time] : {std::pair{1.0, 5.0}, {8.0, 30.0}, {2.0, 40.0}}) {
    run.push(y);
    watch.add(run.nodes, run.vessel, time);
  }
  const InitialStateMonitor::Departure departure = watch.departure().value();
  EXPECT_EQ(departure.node, 1U);
  EXPECT_DOUBLE_EQ(departure.distance, 8.0);
  EXPECT_DOUBLE_EQ(departure.time, 30.0);
}

TEST(start_watch, small_displacements_are_no_departure) {
  Watched run;
  InitialStateMonitor watch = run.started();
  run.push(0.4);
  watch.add(run.nodes, run.vessel, 5.0);
  EXPECT_FALSE(watch.departure());
}

TEST(start_watch, a_sea_that_has_built_up_explains_what_the_pipe_does) {
  Watched run(WaveType::jonswap);
  InitialStateMonitor watch = run.started();
  run.push(5.0);
  watch.add(run.nodes, run.vessel, -20.0);
  EXPECT_FALSE(watch.departure());
}

TEST(start_watch, a_departure_before_the_sea_has_built_up_is_reported) {
  Watched run(WaveType::jonswap);
  InitialStateMonitor watch = run.started();
  run.push(5.0);
  watch.add(run.nodes, run.vessel, -55.0);
  EXPECT_TRUE(watch.departure());
}

TEST(start_watch, a_vessel_that_moves_explains_three_times_its_own_displacement) {
  Watched run;
  InitialStateMonitor watch = run.started();
  run.vessel.p_WV.y() = 1.0;
  run.push(3.4);
  watch.add(run.nodes, run.vessel, 5.0);
  EXPECT_FALSE(watch.departure());
  run.push(3.6);
  watch.add(run.nodes, run.vessel, 6.0);
  EXPECT_NEAR(watch.departure().value().distance, 0.6, 1e-12);
}

TEST(start_watch, a_checkpoint_keeps_what_was_seen) {
  Watched run;
  InitialStateMonitor watch = run.started();
  run.push(2.0);
  watch.add(run.nodes, run.vessel, 5.0);
  InitialStateMonitor restored = run.started();
  restored.restore(watch.save());
  EXPECT_DOUBLE_EQ(restored.departure().value().distance, 2.0);
}

}  // namespace
}  // namespace overbend
