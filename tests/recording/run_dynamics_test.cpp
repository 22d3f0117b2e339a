/// Whole dynamic analyses of the BGL-1 example on a coarse mesh.
#include "recording/run_dynamics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "modelfile/reading/yaml_reader.h"
#include "numerics/running_quantiles.h"
#include "support/allocation_count.h"
#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

using testing::EmptySink;
using testing::MemorySink;
using testing::TimedLay;
using testing::workable;

TEST(dynamics, without_waves_the_pipe_stays_where_statics_put_it) {
  Description d = workable();
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::fixed;
  const TimedLay c(d);
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  // The static solver stops at 1e-9 of the weight of 1.2 MN, a step at 1e-6 of it: of the order of 1 N.
  EXPECT_NEAR(r.top_tension.min, c.statics.top_tension, 15.0);
  EXPECT_NEAR(r.top_tension.max, c.statics.top_tension, 15.0);
  EXPECT_NEAR(r.departure_angle.max, c.statics.departure_angle, 1e-5);
  EXPECT_NEAR(r.departure_angle.min, c.statics.departure_angle, 1e-5);
  for (std::size_t i = 0; i < r.station_s.size(); ++i) {
    EXPECT_LT(r.z.max[i] - r.z.min[i], 5e-5);  // a twentieth of what a roller gives under the pipe
  }
  EXPECT_EQ(r.impact_count, 0);
}

/// A pipe hanging from a guide that lets it turn, under a barge that heaves.
Description suspended_lay(TensionerMode mode) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/validation/static_cases/J12-D400-T560.yaml").description.value();
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.harmonic["heave"] = {0.6, 10.0, 0.0};
  d.tensioner.mode = mode;
  d.tensioner.range_low = 550e3;
  d.tensioner.range_high = 570e3;
  d.tensioner.velocity = 0.5;
  d.tensioner.delay = 0.2;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 20.0;
  d.dynamics->build_up = 10.0;
  d.dynamics->output_step = 0.1;
  return d;
}

TEST(tensioner_in_time, on_a_guide_that_lets_the_pipe_turn_it_acts_along_the_pipe) {
  for (const TensionerMode mode : {TensionerMode::constant, TensionerMode::controlled, TensionerMode::locked}) {
    const TimedLay c(suspended_lay(mode));
    MemorySink sink;
    const DynamicResults r = c.results(sink);
    EXPECT_NEAR(r.tensioner.tension.max, r.top_tension.max, 1e-3 * r.top_tension.max);
    EXPECT_NEAR(r.tensioner.tension.min, r.top_tension.min, 1e-3 * r.top_tension.max);
    EXPECT_NEAR(r.tensioner.tension.mean, r.top_tension.mean, 1e-4 * r.top_tension.mean);
    EXPECT_LT(std::abs(r.energy.drift()), 1e-3);
    if (mode == TensionerMode::constant) {
      EXPECT_NEAR(r.top_tension.min, 560e3, 0.005 * 560e3);
      EXPECT_NEAR(r.top_tension.max, 560e3, 0.005 * 560e3);
    }
  }
}

TEST(dynamics, percentiles_of_reactions_agree_with_the_share_of_time_in_contact) {
  const TimedLay c(workable());
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  int lifting = 0;
  for (const SupportDynamics& box : r.supports) {
    const Percentiles& p = box.reaction_over_time;
    EXPECT_EQ(p.p50 > 0.0, box.contact_share > 0.5) << box.name;
    EXPECT_EQ(p.p90 > 0.0, box.contact_share > 0.1) << box.name;
    EXPECT_EQ(p.p99 > 0.0, box.contact_share > 0.01) << box.name;
    EXPECT_LE(p.p50, p.p90);
    EXPECT_LE(p.p90, p.p99);
    EXPECT_LE(p.p99, box.reaction.max * (1.0 + 2.0 / RunningQuantiles::kBins) + 1.0);  // a bin
    lifting += box.contact_share > 0.0 && box.contact_share < 1.0 ? 1 : 0;
  }
  EXPECT_GT(lifting, 0);
}

TEST(dynamics, energy_in_is_energy_stored_and_lost) {
  const TimedLay c(workable());
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  EXPECT_LT(std::abs(r.energy.drift()), 1e-3);
  EXPECT_GT(r.energy.throughput, 1e5);  // the barge has moved the pipe
  EXPECT_GE(r.energy.friction_loss, 0.0);
  EXPECT_GE(r.energy.contact_loss, -1e-6 * r.energy.throughput);  // quadrature of jumps may go below nothing by a hair
  EXPECT_GE(r.energy.seabed_loss,
            -1e-3 * r.energy.throughput);  // the stretch of the bed's friction gives back a little
}

TEST(dynamics, envelopes_hold_between_coarse_and_fine_steps) {
  Description d = workable();
  d.tensioner.mode = TensionerMode::locked;  // the moments at which a machine moves depend on single peaks
  const TimedLay c(d);
  MemorySink a, b;
  DynamicOptions options = dynamic_options(c.model);
  const DynamicResults coarse = c.run(a, options).results.value();
  options.max_step = 0.02;
  options.error_tolerance = 1e-4;
  const DynamicResults fine = c.run(b, options).results.value();
  // Second order: steps of 0.125 s in waves of 8 s are wrong by some 0.3 %; impacts make single peaks less sure.
  EXPECT_NEAR(coarse.top_tension.max, fine.top_tension.max, 0.01 * fine.top_tension.max);
  EXPECT_NEAR(coarse.top_tension.std, fine.top_tension.std, 0.02 * fine.top_tension.std);
  EXPECT_NEAR(coarse.sagbend.von_mises.over_time.max, fine.sagbend.von_mises.over_time.max,
              0.02 * fine.sagbend.von_mises.over_time.max);
}

// Without prediction, one in seven would be met by a step that is too long, which ends when the roller has stopped the
// pipe.
TEST(impacts_in_time, are_as_many_and_as_hard_as_with_steps_that_are_short_throughout) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-workable-sea.yaml").description.value();
  d.dynamics->duration = 120.0;
  const TimedLay chosen(d);
  d.dynamics->max_step = 0.01;
  const TimedLay short_steps(d);
  const auto sum = [](const MemorySink& sink) {
    return std::accumulate(sink.impacts.begin(), sink.impacts.end(), 0.0,
                           [](double so_far, const Impact& impact) { return so_far + impact.peak_force; });
  };
  MemorySink got, expected;
  chosen.results(got);
  short_steps.results(expected);
  EXPECT_GT(expected.impacts.size(), 15U);
  EXPECT_NEAR(static_cast<double>(got.impacts.size()), static_cast<double>(expected.impacts.size()), 1.0);
  EXPECT_NEAR(sum(got), sum(expected), 0.1 * sum(expected));
}

/// Head waves that move the barge back and forth, rollers that carry and do not strike.
Description hauling(TensionerMode mode) {
  Description d = workable();
  d.environment.waves.front() = {};
  d.environment.waves.front().type = WaveType::airy;
  d.environment.waves.front().height = 1.2;
  d.environment.waves.front().period = 12.0;
  d.environment.waves.front().from = 1.5707963;
  d.environment.current.clear();
  d.tensioner.mode = mode;
  d.dynamics->build_up = 24.0;
  d.dynamics->duration = 48.0;
  d.dynamics->output_step = 0.1;
  return d;
}

TEST(tensioner_in_time, constant_keeps_the_tension_and_pays_out_and_in) {
  const TimedLay c(hauling(TensionerMode::constant));
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  EXPECT_NEAR(r.tensioner.tension.min, 250e3, 5.0);  // what a step may leave out of balance
  EXPECT_NEAR(r.tensioner.tension.max, 250e3, 5.0);
  EXPECT_NEAR(r.top_tension.max, 250e3, 250.0);
  EXPECT_GT(r.tensioner.travel.max - r.tensioner.travel.min, 0.2);
  EXPECT_LT(std::abs(r.energy.drift()), 1e-4);
}

TEST(tensioner_in_time, controlled_lies_between_the_brake_and_the_ideal) {
  const TimedLay on(hauling(TensionerMode::controlled)), off(hauling(TensionerMode::locked));
  MemorySink a, b;
  const DynamicResults controlled = on.results(a), locked = off.results(b);
  EXPECT_LT(controlled.tensioner.time_out_of_range, 0.6 * locked.tensioner.time_out_of_range);
  EXPECT_LT(controlled.tensioner.tension.std, 0.9 * locked.tensioner.tension.std);
  EXPECT_EQ(locked.tensioner.travel.max, 0.0);
  const TensionerDynamics& t = controlled.tensioner;
  EXPECT_GT(t.pay_out_count, 2);
  EXPECT_GT(t.haul_in_count, 2);
  EXPECT_NEAR(t.time_holding + t.time_delayed + t.time_paying_out + t.time_hauling_in + t.time_at_limit, 48.0, 1e-6);
  EXPECT_LT(std::abs(controlled.energy.drift()), 1e-4);
}

TEST(tensioner_in_time, moves_no_faster_than_it_can_and_waits_its_delay) {
  const TimedLay c(hauling(TensionerMode::controlled));
  MemorySink sink;
  c.results(sink);
  const std::vector<double> time = sink.column("time"), tension = sink.column("tensioner/tension"),
                            travel = sink.column("tensioner/travel");
  ASSERT_EQ(travel.size(), sink.rows.size());
  double waited = 0.0;  // with the tension out of range, standing
  for (std::size_t i = 1; i < travel.size(); ++i) {
    const double moved = travel[i] - travel[i - 1], h = time[i] - time[i - 1];
    EXPECT_LE(std::abs(moved), 0.25 * h * (1.0 + 1e-6));
    const bool out = tension[i] > 260e3 || tension[i] < 240e3;
    waited = out && moved == 0.0 ? waited + h : 0.0;
    EXPECT_LE(waited, 2.0 + 2.0 * h);
  }
}

TEST(tensioner_in_time, pays_out_until_its_travel_ends_and_says_so) {
  Description d = hauling(TensionerMode::controlled);
  d.tensioner.travel = 0.05;
  d.tensioner.delay = 0.5;
  d.dynamics->max_step = 0.02;  // follows the vibrations along the pipe that make the machine act
  const TimedLay c(d);
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  EXPECT_NEAR(r.tensioner.travel.max, 0.05, 1e-4);  // while it is governed its speed is what is bounded, not its place
  EXPECT_NEAR(r.tensioner.travel.min, -0.05, 1e-4);
  EXPECT_GT(r.tensioner.limit_count, 0);
  EXPECT_GT(r.tensioner.time_at_limit, 0.0);
  EXPECT_TRUE(std::ranges::any_of(messages(r.findings), [](const std::string& w) {
    return w.find("the tensioner was at its travel limit") != std::string::npos;
  }));
}

TEST(tensioner_in_time, a_constant_one_that_goes_beyond_its_travel_is_reported) {
  Description d = hauling(TensionerMode::constant);
  const auto prescribed = [&](double travel) {
    d.tensioner.travel = travel;
    const TimedLay c(d);
    MemorySink sink;
    const DynamicResults r = c.results(sink);
    return std::ranges::any_of(messages(r.findings), [](const std::string& w) {
      return w.find("more than its tensioner.travel") != std::string::npos;
    });
  };
  EXPECT_TRUE(prescribed(0.001));
  EXPECT_FALSE(prescribed(50.0));
}

TEST(tensioner_in_time, without_waves_a_controlled_one_stands) {
  Description d = hauling(TensionerMode::controlled);
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::fixed;
  const TimedLay c(d);
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  EXPECT_EQ(r.tensioner.travel.max, 0.0);
  EXPECT_EQ(r.tensioner.pay_out_count + r.tensioner.haul_in_count, 0);
  EXPECT_NEAR(r.tensioner.time_holding, r.duration, 1e-9);
}

/// Runs whole, and once stopped at the first row from `stop` on and taken up again.
void expect_same_bits_when_taken_up(const Description& description, double stop) {
  const TimedLay c(description);
  const DynamicOptions options = dynamic_options(c.model);
  MemorySink whole, first, second;
  const DynamicResults expected = c.run(whole, options).results.value();
  const DynamicOutcome stopped = c.run(first, options, nullptr, [&](const DynamicProgress& dynamic_progress) {
    return dynamic_progress.time >= stop ? DynamicControl::stop : DynamicControl::go_on;
  });
  ASSERT_TRUE(stopped.stopped);
  ASSERT_EQ(first.checkpoints.size(), 1u);
  const DynamicResults got = c.run(second, options, &first.checkpoints.front()).results.value();
  EXPECT_EQ(got.von_mises.max, expected.von_mises.max);
  EXPECT_EQ(got.strain.max, expected.strain.max);
  EXPECT_EQ(got.effective_tension.std, expected.effective_tension.std);
  EXPECT_EQ(got.energy.error, expected.energy.error);
  EXPECT_EQ(got.energy.yielding_loss, expected.energy.yielding_loss);
  EXPECT_EQ(got.tensioner.pay_out_count, expected.tensioner.pay_out_count);
  EXPECT_EQ(got.run.steps, expected.run.steps);
  EXPECT_EQ(got.impact_count, expected.impact_count);
  std::vector<std::vector<double>> rows = first.rows;
  rows.insert(rows.end(), second.rows.begin(), second.rows.end());
  EXPECT_EQ(rows, whole.rows);
}

TEST(dynamics, a_run_taken_up_at_a_checkpoint_gives_the_same_bits) {
  expect_same_bits_when_taken_up(workable(), 5.0);
}

TEST(tensioner_in_time, a_run_taken_up_in_every_state_gives_the_same_bits) {
  const Description d = hauling(TensionerMode::controlled);
  MemorySink sink;
  TimedLay(d).results(sink);
  const std::vector<double> time = sink.column("time"), state = sink.column("tensioner/state");
  std::vector<double> seen;
  for (std::size_t i = 0; i + 1 < state.size(); ++i) {  // at the first row of each state
    if (time[i] <= 0.0 || std::find(seen.begin(), seen.end(), state[i]) != seen.end()) continue;
    seen.push_back(state[i]);
    expect_same_bits_when_taken_up(d, time[i]);
  }
  EXPECT_GE(seen.size(), 4u);  // holds, waits, pays out, hauls in
}

/// The stinger as the paper prints it, past yield, with steel that yields.
Description yielding() {
  Description d = workable();
  d.supports = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-as-printed.yaml").description.value().supports;
  d.pipe.section.steel.material.law = MaterialLaw::ramberg_osgood;
  d.pipe.section.steel.material.hardening_exponent = 25.0;
  d.environment.waves.front().hs = 3.0;
  return d;
}

TEST(yielding_in_time, a_run_taken_up_at_a_checkpoint_gives_the_same_bits) {
  expect_same_bits_when_taken_up(yielding(), 5.0);
}

TEST(yielding_in_time, energy_in_is_energy_stored_and_lost) {
  const TimedLay c(yielding());
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  EXPECT_GT(r.energy.yielding_loss, 10.0);
  EXPECT_LT(std::abs(r.energy.drift()), 1e-4);
}

TEST(yielding_in_time, at_rest_the_pipe_stays_where_statics_put_it) {
  Description d = yielding();
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::fixed;
  const TimedLay c(d);
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  EXPECT_LT(r.energy.yielding_loss, 0.1);  // [J]; what settling from the tolerance of statics makes
  for (std::size_t i = 0; i < r.z.max.size(); ++i) EXPECT_NEAR(r.z.max[i], r.z.min[i], 1e-5) << i;
}

// Without the short steps of impacts, of which a pipe that yields has its own.
TEST(yielding_in_time, steps_stay_as_long_as_with_linear_steel) {
  Description yields = yielding();
  yields.dynamics->impact_force = 1e9;
  Description linear = yields;
  linear.pipe.section.steel.material = {};
  MemorySink a, b;
  const DynamicResults with = TimedLay(yields).results(a), without = TimedLay(linear).results(b);
  EXPECT_GT(with.energy.yielding_loss, 10.0);
  EXPECT_LT(static_cast<double>(with.run.steps), 1.1 * static_cast<double>(without.run.steps));
}

TEST(dynamics, writing_checkpoints_does_not_change_the_run) {
  const TimedLay c(workable());
  const DynamicOptions options = dynamic_options(c.model);
  MemorySink plain, written;
  c.run(plain, options);
  c.run(written, options, nullptr, [](const DynamicProgress&) { return DynamicControl::checkpoint; });
  EXPECT_EQ(plain.rows, written.rows);
}

TEST(dynamics, the_time_loop_allocates_nothing) {
  for (const Description& d : {workable(), yielding()}) {
    const TimedLay c(d);
    EmptySink sink;
    long at_first = 0, at_last = 0;
    c.run(sink, dynamic_options(c.model), nullptr, [&](const DynamicProgress& dynamic_progress) {
      (dynamic_progress.time < 0.0 ? at_first : at_last) = testing::allocation_count();
      return DynamicControl::go_on;
    });
    EXPECT_EQ(at_last, at_first);  // from the last row of the build-up to the end
  }
}

}  // namespace
}  // namespace overbend
