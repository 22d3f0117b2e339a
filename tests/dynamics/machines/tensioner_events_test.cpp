#include "dynamics/machines/tensioner_events.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "dynamics/run/simulation.h"
#include "support/bgl1_in_time.h"

namespace overbend {
namespace {

using testing::TimedLay;
using testing::workable;

/// A barge that lies still, with a machine that is quick to answer.
Description lay_at_rest(TensionerMode mode) {
  Description d = workable();
  d.tensioner.mode = mode;
  d.tensioner.delay = 0.2;
  d.dynamics->build_up = 0.0;
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::fixed;
  return d;
}

/// The start of a run in which the tensioner restores `share` of the tension that it holds at first.
RunStart start_with_wanted(const TimedLay& lay, double share, const DynamicOptions& options) {
  RunStart run = make_run_start(lay.model, lay.start, lay.statics.top_tension, options);
  const std::size_t tensioner = find_laid_pipe(run.setup.system)->tensioner;
  set_target_tension(*run.setup.system.attachments[tensioner].tensioner, share * lay.statics.top_tension);
  return run;
}

/// The first with the pipe of the second, and its tensioner, next to its own.
RunStart join(RunStart first, RunStart second) {
  System& system = first.setup.system;
  for (Attachment end : second.setup.system.attachments) {
    end.line += static_cast<int>(system.lines.size());
    system.attachments.push_back(end);
  }
  system.lines.push_back(second.setup.system.lines.front());
  first.state.lines.push_back(second.state.lines.front());
  first.state.attachments.insert(first.state.attachments.end(), second.state.attachments.begin(),
                                 second.state.attachments.end());
  return first;
}

double max_series_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double max_difference = a.size() == b.size() ? 0.0 : INFINITY;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    max_difference = std::max(max_difference, std::abs(a[i] - b[i]));
  return max_difference;
}

/// Two pipes on one vessel, one wanted looser and one tighter, and each of them alone.
struct Pair {
  Pair(const TimedLay& lay, const DynamicOptions& options, double low, double high)
      : both(lay.model, join(start_with_wanted(lay, low, options), start_with_wanted(lay, high, options)), options),
        loose(lay.model, start_with_wanted(lay, low, options), options),
        tight(lay.model, start_with_wanted(lay, high, options), options) {}

  bool advance(double until) { return both.advance(until) && loose.advance(until) && tight.advance(until); }
  double travel(std::size_t number) const {
    return both.present().state->attachments[find_tensioners(both.system())[number]].travel.q;
  }

  Simulation both, loose, tight;
};

DynamicOptions steps_of_one_length(const Model& model) {
  DynamicOptions options = dynamic_options(model);
  options.fixed_step = 0.02;
  options.step.tolerance = 1e-8;
  return options;
}

// Second opinion: each pipe with its tensioner alone on the vessel.
TEST(tensioner_events, of_two_pipes_on_one_vessel_follow_each_its_own_tension) {
  for (const auto& [mode, change] : {std::pair{TensionerMode::controlled, 0.06}, {TensionerMode::constant, 0.01}}) {
    const TimedLay lay(lay_at_rest(mode));
    Pair pair(lay, steps_of_one_length(lay.model), 1.0 - change, 1.0 + change);
    ASSERT_EQ(find_tensioners(pair.both.system()).size(), 2U);
    ASSERT_TRUE(pair.advance(1.0));
    EXPECT_GT(pair.travel(0) - pair.travel(1), 0.01 * change);  // [m]
    EXPECT_NEAR(pair.travel(0), pair.loose.present().tensioner->travel.q, 1e-7);
    EXPECT_NEAR(pair.travel(1), pair.tight.present().tensioner->travel.q, 1e-7);
    const SystemState& state = *pair.both.present().state;
    EXPECT_LT(max_series_difference(state.lines[0].q, pair.loose.present().state->lines[0].q), 1e-6);
    EXPECT_LT(max_series_difference(state.lines[1].q, pair.tight.present().state->lines[0].q), 1e-6);
    EXPECT_NEAR(pair.both.present().assembly->tension(1), pair.tight.tension(), 1e-5 * pair.tight.tension());
  }
}

// A tension that jumps under a fixed step shakes the end; a balance with the last element inside out is none.
TEST(tensioner_events, never_turn_the_end_of_a_pipe_round) {
  const TimedLay lay(lay_at_rest(TensionerMode::constant));
  DynamicOptions options = steps_of_one_length(lay.model);
  options.fixed_step = 0.05;
  Simulation run(lay.model, start_with_wanted(lay, 1.04, options), options);
  while (run.time() < 1.0 && run.step()) {
    EXPECT_LT(std::abs(run.present().tensioner->travel.q), 0.1);
  }
  EXPECT_GE(run.time(), 1.0);
}

// The steps are those that either machine asks for, so that they differ from those of one alone.
TEST(tensioner_events, of_two_pipes_are_met_by_steps_of_any_length) {
  const TimedLay lay(lay_at_rest(TensionerMode::controlled));
  Pair pair(lay, dynamic_options(lay.model), 0.94, 1.06);
  ASSERT_TRUE(pair.advance(1.0));
  EXPECT_NEAR(pair.travel(0), pair.loose.present().tensioner->travel.q, 1e-3);
  EXPECT_NEAR(pair.travel(1), pair.tight.present().tensioner->travel.q, 1e-3);
}

}  // namespace
}  // namespace overbend
