#include "dynamics/run/simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "recording/recorder.h"
#include "support/allocation_count.h"
#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

using testing::EmptySink;
using testing::MemorySink;
using testing::TimedLay;

/// The example in its sea for 4 s.
Description brief() {
  Description d = testing::workable();
  d.dynamics->build_up = 2.0;
  d.dynamics->duration = 4.0;
  return d;
}

const TimedLay& brief_case() {
  static const TimedLay c(brief());
  return c;
}

class Simulated : public Simulation {
 public:
  explicit Simulated(const TimedLay& c) : Simulated(c, dynamic_options(c.model)) {}
  Simulated(const TimedLay& c, const DynamicOptions& options)
      : Simulation(c.model, c.start, c.statics.top_tension, options) {}
};

/// Counts the calls of the observer.
class Counter : public SimulationObserver {
 public:
  int begun_ = 0, steps_ = 0, rows_ = 0;
  double time_ = 0.0, passed_ = 0.0;
  std::int64_t last_row_ = -1000;

  void begun(const Instant& instant) override {
    ++begun_;
    time_ = instant.state->time;
  }
  void stepped(const Instant& instant) override {
    ++steps_;
    passed_ += instant.step;
    EXPECT_GT(instant.state->time, time_);
    time_ = instant.state->time;
  }
  void row(const Instant& instant, std::int64_t number) override {
    ++rows_;
    last_row_ = number;
    EXPECT_NEAR(instant.state->time, 0.5 * static_cast<double>(number), 1e-12);
  }
};

// New factors in every step of one length would cost more than what they spare in iterations, and none at all would
// leave twice as many.
TEST(simulation, factors_serve_several_steps_of_a_heaving_pipe_with_few_iterations_each) {
  Description heaving = read_model(OVERBEND_SOURCE_DIR "/bench/sagbend.yaml").description.value();
  heaving.dynamics->duration = 24.0;  // three periods
  const TimedLay sagbend(heaving);
  Simulated run(sagbend);
  EXPECT_TRUE(run.advance(1e9));
  const DynamicRunReport& report = run.report();
  EXPECT_EQ(report.steps, 400);
  EXPECT_LT(100 * report.factorisations, 45 * report.steps) << report.factorisations;
  EXPECT_LT(report.newton_iterations, 3 * report.steps) << report.newton_iterations;
}

TEST(simulation, steps_taken_one_by_one_are_those_of_the_whole_run) {
  Simulated whole(brief_case()), single(brief_case()), looked_at(brief_case());
  EXPECT_TRUE(whole.advance(1e9));
  while (single.step()) {
  }
  for (double t = -2.0; !looked_at.finished(); t += 0.37) EXPECT_TRUE(looked_at.advance(t));
  for (const Simulation* second_simulation : {&single, &looked_at}) {
    EXPECT_EQ(second_simulation->present().pipe().q, whole.present().pipe().q);
    EXPECT_EQ(second_simulation->present().pipe().acc, whole.present().pipe().acc);
    EXPECT_EQ(second_simulation->energy().error, whole.energy().error);
    EXPECT_EQ(second_simulation->report().steps, whole.report().steps);
  }
  EXPECT_EQ(whole.time(), 4.0);
  EXPECT_TRUE(whole.finished());
  EXPECT_FALSE(whole.step());
  EXPECT_FALSE(whole.failure());
}

TEST(simulation, advances_to_rows_exactly_and_to_other_times_by_the_step_that_passes_them) {
  Simulated simulation(brief_case());
  EXPECT_EQ(simulation.time(), -2.0);
  EXPECT_EQ(simulation.next_row(), -1.5);
  simulation.advance(simulation.next_row());
  EXPECT_EQ(simulation.time(), -1.5);
  EXPECT_EQ(simulation.row_number(), -3);
  simulation.advance(-1.23);
  EXPECT_GE(simulation.time(), -1.23);
  EXPECT_LE(simulation.time(), -1.23 + simulation.present().step);
  EXPECT_EQ(simulation.next_row(), -1.0);
}

TEST(simulation, notifies_every_observer_of_every_step_and_row) {
  Simulated simulation(brief_case());
  Counter early, late;
  simulation.observe(early);
  simulation.advance(1.0);
  simulation.observe(late);
  simulation.advance(4.0);
  EXPECT_EQ(early.begun_, 1);
  EXPECT_EQ(early.steps_, simulation.report().steps);
  EXPECT_NEAR(early.passed_, 6.0, 1e-9);
  EXPECT_EQ(early.rows_, 12);
  EXPECT_EQ(early.last_row_, 8);
  EXPECT_NEAR(late.passed_, 3.0, 1e-9);
  EXPECT_EQ(late.rows_, 6);
}

TEST(simulation, a_step_allocates_nothing) {
  const TimedLay& c = brief_case();
  Simulated simulation(c);
  EmptySink sink;
  Recorder recorder(c.model, c.statics, simulation, sink);
  Counter counter;
  simulation.observe(recorder);
  simulation.observe(counter);
  simulation.advance(0.5);
  const long before = testing::allocation_count();
  while (simulation.step()) {
  }
  EXPECT_EQ(testing::allocation_count(), before);
}

TEST(simulation, a_restored_one_shows_the_same_present_and_goes_on_with_the_same_bits) {
  const TimedLay& c = brief_case();
  Simulated whole(c), second(c);
  MemorySink a, b;
  Recorder first_recorder(c.model, c.statics, whole, a), second_recorder(c.model, c.statics, second, b);
  whole.observe(first_recorder);
  second.observe(second_recorder);
  whole.advance(1.0);
  second.restore(std::as_const(whole).checkpoint());
  EXPECT_EQ(second.time(), whole.time());
  EXPECT_NEAR(second.tension(), whole.tension(), 1e-6 * whole.tension());  // evaluated anew at the same state
  EXPECT_EQ(second.present().elevation, whole.present().elevation);
  a.rows.clear();
  whole.advance(4.0);
  second.advance(4.0);
  EXPECT_EQ(second.present().pipe().q, whole.present().pipe().q);
  EXPECT_EQ(b.rows, a.rows);
  DynamicResults expected, got;
  first_recorder.fill(expected);
  second_recorder.fill(got);
  EXPECT_EQ(got.von_mises.max, expected.von_mises.max);
  EXPECT_EQ(got.design.load, expected.design.load);
}

TEST(simulation, a_tensioner_takes_a_new_set_point_between_two_steps) {
  Description d = brief();
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::fixed;
  d.tensioner.mode = TensionerMode::constant;
  const TimedLay c(d);
  Simulated simulation(c);
  simulation.advance(0.0);
  EXPECT_NEAR(simulation.tension(), 250e3, 10.0);  // what a step may leave out of balance
  simulation.set_tension(245e3);
  const DynamicCheckpoint changed = simulation.checkpoint();
  simulation.step();
  EXPECT_NEAR(simulation.tension(), 245e3, 10.0);
  simulation.advance(2.0);
  EXPECT_NEAR(simulation.tension(), 245e3, 10.0);
  EXPECT_GT(simulation.present().tensioner->travel.q, 0.0);  // paid out
  Simulated restored(c);
  restored.restore(changed);
  restored.advance(2.0);
  EXPECT_EQ(restored.present().pipe().q, simulation.present().pipe().q);
}

TEST(simulation, one_that_cannot_go_on_says_why_and_stays_where_it_was) {
  const TimedLay& c = brief_case();
  DynamicOptions options = dynamic_options(c.model);
  options.step.tolerance = 0.0;  // which no step reaches
  options.step.max_iterations = 2;
  Simulated simulation(c, options);
  EXPECT_FALSE(simulation.advance(1.0));
  ASSERT_TRUE(simulation.failure());
  EXPECT_EQ(simulation.failure()->what, "the time step cannot be solved");
  EXPECT_EQ(simulation.time(), -2.0);
  EXPECT_FALSE(simulation.step());
}

}  // namespace
}  // namespace overbend
