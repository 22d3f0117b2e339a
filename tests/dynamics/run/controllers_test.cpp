/// Controllers from outside that drive the tensioner of the BGL-1 example, and the winches of its mooring lines.
#include "dynamics/run/controllers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "dynamics/run/simulation.h"
#include "support/allocation_count.h"
#include "support/bgl1_in_time.h"
#include "support/moored_lay.h"

namespace overbend {
namespace {

using testing::SolvedLay;
using testing::TimedLay;

using Answer = std::function<MachineCommand(const MachineReading&)>;

MachineCommand speed(double wanted) {
  return {MachineCommand::Kind::speed, wanted};
}
MachineCommand set_to(double tension) {
  return {MachineCommand::Kind::tension, tension};
}

/// Answers by a function and keeps what it saw.
class Asked : public Controller {
 public:
  explicit Asked(Answer answer = {}) : answer_(std::move(answer)) { seen.reserve(1000); }
  MachineCommand command(const MachineReading& reading) override {
    seen.push_back(reading);
    return answer_ ? answer_(reading) : MachineCommand{};
  }
  std::vector<MachineReading> seen;

 private:
  Answer answer_;
};

/// The example in its sea for 4 s, with a tensioner that moves by commands alone.
Description brief() {
  Description d = testing::workable();
  d.dynamics->build_up = 2.0;
  d.dynamics->duration = 4.0;
  d.tensioner.mode = TensionerMode::locked;
  return d;
}

/// Likewise on calm water with a barge that lies still.
Description calm(double duration) {
  Description d = brief();
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::fixed;
  d.dynamics->build_up = 0.0;
  d.dynamics->duration = duration;
  return d;
}

const TimedLay& brief_case() {
  static const TimedLay c(brief());
  return c;
}
const TimedLay& calm_case() {
  static const TimedLay c(calm(40.0));
  return c;
}
/// With the tensioner's own law.
const TimedLay& controlled_case() {
  static const TimedLay c([] {
    Description d = brief();
    d.tensioner.mode = TensionerMode::controlled;
    return d;
  }());
  return c;
}

DynamicOptions with(const TimedLay& c, Controller* controller, double interval = 0.1) {
  DynamicOptions options = dynamic_options(c.model);
  options.controllers = {{kTensionerMachine, controller, interval}};
  return options;
}

class Simulated : public Simulation {
 public:
  explicit Simulated(const TimedLay& c) : Simulated(c, dynamic_options(c.model)) {}
  Simulated(const TimedLay& c, const DynamicOptions& options)
      : Simulation(c.model, c.start, c.statics.top_tension, options) {}
  double travel() const { return present().tensioner->travel.q; }
};

void expect_same(const Simulation& a, const Simulation& b) {
  EXPECT_EQ(a.present().pipe().q, b.present().pipe().q);
  EXPECT_EQ(a.present().pipe().acc, b.present().pipe().acc);
  EXPECT_EQ(a.present().tensioner->travel.q, b.present().tensioner->travel.q);
  EXPECT_EQ(a.energy().error, b.energy().error);
  EXPECT_EQ(a.report().steps, b.report().steps);
}

/// Keeps the tension at the end of every step.
class Tensions : public SimulationObserver {
 public:
  void begun(const Instant& instant) override { keep(instant); }
  void stepped(const Instant& instant) override { keep(instant); }
  /// Straight between the ends of steps.
  double at(double when) const {
    const auto after = std::lower_bound(time.begin(), time.end(), when - 1e-9);
    const auto i = static_cast<std::size_t>(after - time.begin());
    if (i == 0 || time[i] - when < 1e-9) return tension[i];
    return tension[i - 1] + (when - time[i - 1]) / (time[i] - time[i - 1]) * (tension[i] - tension[i - 1]);
  }
  std::vector<double> time, tension;
  double max_step = 0.0;  ///< Step [s].

 private:
  void keep(const Instant& instant) {
    time.push_back(instant.state->time);
    tension.push_back(instant.tensioner->machine.tension);
    max_step = std::max(max_step, instant.step);
  }
};

TEST(controllers, are_asked_for_the_multiples_of_their_interval_exactly_and_no_step_is_much_longer) {
  for (const double interval : {0.1, 0.07, 0.6}) {
    Asked asked;
    Simulated simulation(brief_case(), with(brief_case(), &asked, interval));
    Tensions tensions;
    simulation.observe(tensions);
    ASSERT_TRUE(simulation.advance(4.0));
    const double first = std::ceil(-2.0 / interval - 1e-9);
    for (std::size_t i = 0; i < asked.seen.size(); ++i) {
      EXPECT_EQ(asked.seen[i].time, (first + static_cast<double>(i)) * interval);
      EXPECT_NEAR(asked.seen[i].tension, tensions.at(asked.seen[i].time), 1e-6);
    }
    EXPECT_GT(asked.seen.back().time, 4.0 - interval - 0.125);
    EXPECT_LE(tensions.max_step, 1.25 * interval * (1.0 + 1e-9));
    EXPECT_EQ(simulation.time(), 4.0);
  }
}

TEST(controllers, see_what_the_instruments_of_the_machine_show) {
  Asked asked([](const MachineReading&) { return speed(0.1); });
  Simulated simulation(brief_case(), with(brief_case(), &asked));
  simulation.advance(2.0);
  const double tension = simulation.tension(), travel = simulation.travel();
  const Instant before = simulation.present();
  const double heave = before.vessel().freedoms[2], rising = before.vessel().velocity.z();
  simulation.step();
  const MachineReading& seen = asked.seen.back();
  EXPECT_EQ(seen.time, 2.0);
  EXPECT_EQ(seen.tension, tension);
  EXPECT_EQ(seen.paid_out, travel);
  EXPECT_EQ(seen.length, travel);
  EXPECT_EQ(seen.speed, 0.1);
  EXPECT_EQ(seen.set_tension, 0.0);  // a locked machine restores none
  EXPECT_EQ(seen.vessel[2], heave);
  EXPECT_EQ(seen.vessel_velocity[2], rising);
  EXPECT_GT(std::abs(seen.guide_speed), 1e-4);
}

// By so much as it goes away in a step the pipe would be stretched.
TEST(controllers, see_the_speed_of_the_guide_along_the_pipe) {
  Asked asked;
  Simulated simulation(brief_case(), with(brief_case(), &asked, 0.05));
  double fastest = 0.0;
  for (double t = 0.0; t <= 3.5; t += 0.5) {
    simulation.advance(t);
    const EndMotion from = simulation.present().assembly->surroundings().ends[1];
    simulation.step();  // asks at its beginning
    const double distance =
        (simulation.present().assembly->surroundings().ends[1].place - from.place).dot(from.direction);
    EXPECT_EQ(asked.seen.back().time, t);
    EXPECT_NEAR(asked.seen.back().guide_speed, distance / simulation.present().step,
                0.01);  // half a step's acceleration
    fastest = std::max(fastest, std::abs(asked.seen.back().guide_speed));
  }
  EXPECT_GT(fastest, 0.02);
}

TEST(controllers, that_answer_nothing_leave_every_bit_as_it_is) {
  for (const TimedLay* c : {&brief_case(), &controlled_case()}) {
    Asked asked;
    Simulated alone(*c), with_one(*c, with(*c, &asked));
    alone.advance(4.0);
    with_one.advance(4.0);
    expect_same(alone, with_one);
    EXPECT_EQ(asked.seen.size(), 60U);
  }
}

TEST(controllers, that_ask_for_no_speed_are_a_brake) {
  const TimedLay& c = brief_case();
  Asked asked([](const MachineReading&) { return speed(0.0); });
  Simulated locked(c), held(c, with(c, &asked, 0.5));
  locked.advance(4.0);
  held.advance(4.0);
  expect_same(locked, held);
}

TEST(controllers, that_set_tensions_do_what_set_tension_does) {
  Description d = calm(4.0);
  d.tensioner.mode = TensionerMode::constant;
  const TimedLay c(d);
  const auto tension = [](double time) { return 250e3 - 1e3 * time; };
  Asked asked([&](const MachineReading& reading) { return set_to(tension(reading.time)); });
  Simulated by_hand(c), by_controller(c, with(c, &asked, 0.5));
  while (!by_hand.finished()) {
    by_hand.set_tension(tension(by_hand.time()));
    by_hand.advance(by_hand.next_row());
  }
  by_controller.advance(4.0);
  expect_same(by_hand, by_controller);
  EXPECT_NEAR(by_controller.tension(), tension(3.5), 10.0);
}

// 0.25 m/s within half a second: 0.1 m/s takes 0.2 s and as far as half of that at full speed.
TEST(controllers, pay_out_what_speed_and_ramps_make) {
  Asked asked([](const MachineReading& reading) { return speed(reading.time < 10.0 - 1e-9 ? 0.1 : 0.0); });
  Simulated simulation(calm_case(), with(calm_case(), &asked));
  simulation.advance(5.0);
  EXPECT_NEAR(simulation.travel(), 0.1 * (5.0 - 0.1), 1e-12);
  simulation.advance(20.0);
  EXPECT_NEAR(simulation.travel(), 1.0, 1e-12);
  EXPECT_LT(std::abs(simulation.energy().drift()), 1e-3);
  EXPECT_LT(simulation.tension(), 245e3);
}

// The bed holds the pipe by friction: a fraction of a millimetre is what 5 kN take.
TEST(controllers, reach_the_tension_that_they_want_by_speed) {
  constexpr double kWanted = 245e3, kGain = 2e-7;  // 1 mm/s at 5 kN
  Asked asked([&](const MachineReading& reading) { return speed(kGain * (reading.tension - kWanted)); });
  Simulated simulation(calm_case(), with(calm_case(), &asked));
  ASSERT_TRUE(simulation.advance(40.0));
  EXPECT_NEAR(simulation.tension(), kWanted, 50.0);
  EXPECT_GT(simulation.travel(), 1e-4);
  EXPECT_LT(std::abs(simulation.energy().drift()), 1e-3);
}

// The governor of a machine with a range of 10 kN either way and 0.02 m/s, so slow that it can be asked every 0.02 s:
// an interval of delay is what the two differ by.
TEST(controllers, that_imitate_the_law_of_the_tensioner_give_nearly_its_run) {
  Description d = calm(20.0);
  d.tensioner.mode = TensionerMode::controlled;
  d.tensioner.velocity = 0.02;
  d.tensioner.delay = 0.0;
  d.tensioner.range_low = 240e3;
  d.tensioner.range_high = 255e3;
  const TimedLay timed_lay(d);
  d.tensioner.mode = TensionerMode::locked;
  const TimedLay led(d);
  Asked governor([](const MachineReading& reading) {
    const double error = reading.tension - 240e3;
    return speed(0.02 * std::clamp(error > 0.0 ? error / 5e3 : error / 10e3, -1.0, 1.0));
  });
  Simulated by_law(timed_lay), by_controller(led, with(led, &governor, 0.02));
  by_law.set_tension(240e3);  // 230 to 245 kN: it is out of range at once
  for (double t = 0.5; t <= 20.0; t += 0.5) {
    by_law.advance(t);
    by_controller.advance(t);
    EXPECT_NEAR(by_controller.travel(), by_law.travel(), 0.01 * std::abs(by_law.travel()) + 2e-3) << t;
  }
  EXPECT_GT(by_law.travel(), 0.05);
}

/// A law with a memory: speed by the tension and by the sum of its errors.
class Integrating : public Controller {
 public:
  MachineCommand command(const MachineReading& reading) override {
    sum_ += 1e-4 * (reading.tension - 245e3);
    return speed(1e-6 * (reading.tension - 245e3 + sum_));
  }
  std::vector<double> save() const override { return {sum_}; }
  void restore(const std::vector<double>& saved) override { sum_ = saved.at(0); }

 private:
  double sum_ = 0.0;
};

TEST(controllers, do_not_make_steps_depend_on_how_they_are_asked_for) {
  const TimedLay& c = brief_case();
  for (const double interval : {0.1, 0.07}) {
    Integrating first, second, third;
    Simulated whole(c, with(c, &first, interval)), single(c, with(c, &second, interval)),
        looked_at(c, with(c, &third, interval));
    EXPECT_TRUE(whole.advance(1e9));
    while (single.step()) {
    }
    for (double t = -2.0; !looked_at.finished(); t += 0.37) EXPECT_TRUE(looked_at.advance(t));
    expect_same(whole, single);
    expect_same(whole, looked_at);
    EXPECT_NE(whole.travel(), 0.0);
  }
}

TEST(controllers, go_on_from_a_checkpoint_with_what_they_remember) {
  const TimedLay& c = brief_case();
  Integrating first, second;
  Simulated whole(c, with(c, &first)), resumed(c, with(c, &second));
  whole.advance(1.0);
  const DynamicCheckpoint dynamic_checkpoint = whole.checkpoint();
  whole.advance(4.0);
  resumed.restore(dynamic_checkpoint);
  resumed.advance(4.0);
  EXPECT_EQ(whole.present().pipe().q, resumed.present().pipe().q);
  EXPECT_EQ(whole.travel(), resumed.travel());
  EXPECT_NE(whole.travel(), 0.0);
  EXPECT_EQ(first.save(), second.save());
  Simulated without(c);
  EXPECT_NO_THROW(without.restore(dynamic_checkpoint));  // the tensioner goes on at the last commanded speed
}

TEST(controllers, whose_interval_is_that_of_rows_find_a_command_in_force_after_a_checkpoint) {
  const TimedLay& c = calm_case();
  Asked once([](const MachineReading& reading) { return reading.time < 0.1 ? speed(0.1) : speed(0.05); });
  Simulated whole(c, with(c, &once, 4.0)), resumed(c, with(c, &once, 4.0));
  whole.advance(2.0);
  resumed.restore(whole.checkpoint());
  resumed.advance(3.0);
  EXPECT_NEAR(resumed.travel(), 0.1 * (3.0 - 0.1), 1e-12);
  resumed.advance(6.0);
  EXPECT_NEAR(resumed.present().tensioner->travel.v, 0.05, 1e-15);
}

TEST(controllers, allocate_nothing_in_a_step) {
  Asked asked([](const MachineReading& reading) { return speed(1e-6 * (reading.tension - 250e3)); });
  Simulated simulation(brief_case(), with(brief_case(), &asked));
  simulation.advance(0.5);
  const long before = testing::allocation_count();
  while (simulation.step()) {
  }
  EXPECT_EQ(testing::allocation_count(), before);
}

TEST(controllers, that_fail_end_the_run_and_are_named) {
  Asked throwing([](const MachineReading& reading) {
    if (reading.time > 1.0) throw std::runtime_error("no more");
    return MachineCommand{};
  });
  Asked lost([](const MachineReading& reading) { return speed(reading.time > 1.0 ? NAN : 0.0); });
  for (Asked* asked : {&throwing, &lost}) {
    Simulated simulation(brief_case(), with(brief_case(), asked));
    EXPECT_FALSE(simulation.advance(4.0));
    ASSERT_TRUE(simulation.failure());
    EXPECT_EQ(simulation.failure()->what, "the controller of the tensioner failed");
    EXPECT_EQ(simulation.failure()->where, "at t = 1.1 s");
    EXPECT_EQ(simulation.failure()->why, asked == &lost ? "a speed of nan m/s is not a number" : "no more");
    EXPECT_GE(simulation.time(), 1.1 - 1e-9);
    EXPECT_LE(simulation.time(), 1.2);
    EXPECT_FALSE(simulation.step());
  }
}

std::string rejection(const TimedLay& c, const MachineCommand& command) {
  Simulated simulation(c);
  try {
    simulation.command(kTensionerMachine, command);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(controllers, may_ask_for_what_the_machine_can_do_alone) {
  EXPECT_EQ(rejection(brief_case(), speed(0.1)), "");
  EXPECT_EQ(rejection(brief_case(), set_to(245e3)),
            "a tension was requested, but the tensioner is locked: give tensioner.mode and tensioner.velocity");
  EXPECT_EQ(rejection(controlled_case(), set_to(245e3)), "");
  EXPECT_EQ(rejection(controlled_case(), set_to(-1.0)), "a set tension of -1 N is not a positive number");
  Description d = calm(1.0);
  d.tensioner.velocity = 0.0;
  EXPECT_EQ(rejection(TimedLay(d), speed(0.1)),
            "a speed was requested, but the machine has none: give tensioner.velocity");
}

TEST(controllers, are_rejected_for_machines_that_are_not_there) {
  const TimedLay& c = brief_case();
  const auto error = [&](const std::vector<ControllerUse>& uses) -> std::string {
    DynamicOptions options = dynamic_options(c.model);
    options.controllers = uses;
    try {
      const Simulated simulation(c, options);
    } catch (const std::invalid_argument& found) {
      return found.what();
    }
    return "";
  };
  Asked asked;
  EXPECT_EQ(error({{"bow", &asked, 0.1}}), "there is no machine 'bow' to control; there are 'tensioner'");
  EXPECT_EQ(error({{"tensioner", &asked, 0.0}}),
            "the interval of the controller of 'tensioner' is 0 s; the minimum is 0.001 s");
  EXPECT_EQ(error({{"tensioner", &asked, 0.1}, {"tensioner", &asked, 0.1}}),
            "there are two controllers for 'tensioner'");
}

TEST(controllers, leave_messages_in_the_results) {
  const TimedLay& c = brief_case();
  Asked asked([](const MachineReading&) { return speed(9.0); });
  Simulated simulation(c, with(c, &asked));
  simulation.advance(4.0);
  const std::vector<std::string> assumed = texts(simulation.controllers().assumptions());
  ASSERT_EQ(assumed.size(), 1U);
  EXPECT_EQ(assumed[0].find("An external controller, called every 0.1 s, commanded the tensioner"), 0U);
  const std::vector<std::string> warned = messages(simulation.controllers().findings(simulation.system()));
  ASSERT_EQ(warned.size(), 1U);
  EXPECT_EQ(warned[0], "the tensioner received speed commands of up to 9 m/s; its maximum speed is 0.25 m/s");
  EXPECT_TRUE(Simulated(c).controllers().assumptions().empty());
}

/// The moored barge on calm water, held in its place: winches alone move. The first line is "port bow".
Description moored(WinchMode mode, double duration) {
  Description d = testing::coarse_example("bgl1-moored", duration, 0.0);
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::fixed;
  d.operation = {};
  WinchDescription winch;
  winch.name = "driven";
  winch.mode = mode;
  winch.speed = 0.2;
  winch.acceleration_time = 2.0;
  if (mode == WinchMode::speed) winch.program = {{0.0, 2.0}};  // 10 s at full speed, 2 s of them for a ramp
  d.moorings->winches.push_back(winch);
  d.moorings->lines.front().winch = "driven";
  return d;
}

/// By its name and how it answers.
struct MooredRun {
  MooredRun(const Description& d, std::vector<ControllerUse> uses) : lay(d) {
    DynamicOptions options = dynamic_options(lay.model);
    options.controllers = std::move(uses);
    simulation.emplace(lay.model, *lay.lay.solution, lay.tension(), options);
  }
  const AttachmentState& fairlead() const {
    const System& system = simulation->system();
    for (std::size_t i = 0; i < system.attachments.size(); ++i) {
      if (system.attachments[i].line == 1 && system.attachments[i].end == LineEnd::last) {
        return simulation->present().state->attachments[i];
      }
    }
    throw std::logic_error("no fairlead");
  }
  SolvedLay lay;
  std::optional<Simulation> simulation;
};

// Its program ramps its speed up smoothly, a command as fast as it can: ways are the same, and so are tensions at rest.
TEST(controllers, of_a_winch_do_what_its_program_does) {
  const std::string name = moored(WinchMode::hold, 30.0).moorings->lines.front().name;
  Asked asked([](const MachineReading& reading) { return speed(reading.time < 10.0 - 1e-9 ? 0.2 : 0.0); });
  MooredRun by_program(moored(WinchMode::speed, 30.0), {});
  MooredRun by_controller(moored(WinchMode::hold, 30.0), {{name, &asked, 0.1}});
  ASSERT_TRUE(by_program.simulation->advance(6.0));
  ASSERT_TRUE(by_controller.simulation->advance(6.0));
  EXPECT_NEAR(by_controller.fairlead().payout.rate, by_program.fairlead().payout.rate, 1e-12);
  EXPECT_NEAR(by_controller.fairlead().payout.moved, by_program.fairlead().payout.moved, 1e-9);
  ASSERT_TRUE(by_program.simulation->advance(30.0));
  ASSERT_TRUE(by_controller.simulation->advance(30.0));
  EXPECT_NEAR(by_controller.fairlead().payout.moved, 2.0, 1e-9);
  EXPECT_NEAR(by_program.fairlead().payout.moved, 2.0, 1e-9);
  EXPECT_NEAR(by_controller.fairlead().machine.tension, by_program.fairlead().machine.tension,
              2e-3 * by_program.fairlead().machine.tension);
  EXPECT_EQ(asked.seen.front().time, 0.0);
  EXPECT_GT(asked.seen.front().tension, 50e3);
  EXPECT_NEAR(asked.seen.back().length - asked.seen.front().length, 2.0, 1e-9);
}

TEST(controllers, of_winches_that_keep_a_tension_set_it_and_go_on_from_a_checkpoint) {
  Description d = moored(WinchMode::tension, 8.0);
  d.moorings->winches.back().tension = 320e3;
  const std::string name = d.moorings->lines.front().name;
  Asked asked([](const MachineReading& reading) {
    if (reading.time < 1.0 - 1e-9) return MachineCommand{};
    return reading.time < 3.0 - 1e-9 ? speed(-0.05) : set_to(280e3);
  });
  MooredRun whole(d, {{name, &asked, 0.1}}), resumed(d, {{name, &asked, 0.1}});
  ASSERT_TRUE(whole.simulation->advance(2.5));
  EXPECT_EQ(asked.seen.back().set_tension, 320e3);
  EXPECT_EQ(whole.fairlead().machine.commanded, -0.05);
  resumed.simulation->restore(whole.simulation->checkpoint());
  ASSERT_TRUE(whole.simulation->advance(8.0));
  EXPECT_EQ(asked.seen.back().set_tension, 280e3);
  EXPECT_GT(whole.fairlead().payout.rate, 0.0);  // it pays out for the lower tension
  ASSERT_TRUE(resumed.simulation->advance(8.0));
  EXPECT_EQ(resumed.simulation->present().state->lines.at(1).q, whole.simulation->present().state->lines.at(1).q);
  EXPECT_EQ(resumed.fairlead().payout.moved, whole.fairlead().payout.moved);
}

TEST(controllers, of_a_winch_need_one_and_lines_of_elements) {
  Description d = moored(WinchMode::hold, 1.0);
  const std::string name = d.moorings->lines.front().name;
  Asked asked;
  const auto error = [&](const Description& described, const char* machine) -> std::string {
    try {
      const MooredRun run(described, {{machine, &asked, 0.1}});
    } catch (const std::invalid_argument& found) {
      return found.what();
    }
    return "";
  };
  EXPECT_EQ(error(d, name.c_str()), "");
  d.moorings->lines.front().winch = "";
  EXPECT_EQ(error(d, name.c_str()),
            "mooring line '" + name + "' has no winch to control: give moorings.lines[" + name + "].winch");
  EXPECT_NE(error(d, "unknown").find("there is no machine 'unknown' to control; there are 'tensioner', '" + name),
            std::string::npos);
}

}  // namespace
}  // namespace overbend
