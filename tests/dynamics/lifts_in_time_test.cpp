// Stages of a lift held while the vessel moves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "dynamics/run/simulation.h"
#include "model/lay_stage.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/moored_lay.h"
#include "support/allocation_count.h"
#include "support/dynamic_benchmarks.h"

namespace overbend {
namespace {

Description read_case(const std::string& name, std::size_t stage) {
  const Description d =
      read_model(std::string(OVERBEND_SOURCE_DIR) + "/validation/lift_cases/" + name + ".yaml").description.value();
  return make_stage_description(d, lay_stages(d).at(stage));
}

Description heaving(Description d, double amplitude, double period) {
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.harmonic.clear();
  d.vessel.harmonic["heave"] = {.amplitude = amplitude, .period = period};
  return d;
}

DynamicOptions options_for(double duration, double build_up) {
  DynamicOptions options;
  options.duration = duration;
  options.build_up = build_up;
  options.output_step = 0.1;
  return options;
}

struct Range {
  double min_value = 1e300, max_value = -1e300, last = 0.0;
};

/// Tensions at the upper ends of the wires from t = 0 on, or from `from` on [s]; by name.
std::map<std::string, Range> record_tensions(Simulation& run, double from = 0.0) {
  std::map<std::string, Range> all;
  while (run.step()) {
    if (run.time() < from) continue;
    const Instant instant = run.present();
    for (const FollowedLine& line : run.lines()) {
      Range& range = all[line.name];
      range.last = end_tension(*instant.assembly, *instant.state, line, LineEnd::first);
      range.min_value = std::min(range.min_value, range.last);
      range.max_value = std::max(range.max_value, range.last);
    }
  }
  EXPECT_FALSE(run.failure()) << run.failure()->what;
  return all;
}

double at_rest(const std::vector<LineResult>& lines, const std::string& name) {
  return std::ranges::find(lines, name, &LineResult::name)->first.tension;
}

// Nothing moves: the massless points where wires meet the pipe, a weld and the friction of the way there stay.
TEST(lifts_in_time, stay_at_rest_where_nothing_moves) {
  for (const auto& [name, stage] : {std::pair{"DL12-three", 4}, {"DL10-heavy-wire", 3}, {"TI12-closed", 2}}) {
    Model model = build_model(heaving(read_case(name, static_cast<std::size_t>(stage)), 1e-9, 10.0));
    const ModelEquilibrium rest = solve_equilibrium(model, nullptr);
    Simulation run(model, rest.solution.value(), 0.0, options_for(10.0, 0.0));
    for (const auto& [line, range] : record_tensions(run)) {
      if (line.starts_with("pipe")) continue;
      const double wanted = at_rest(rest.lines, line);
      EXPECT_NEAR(range.min_value, wanted, 5e-4 * wanted + 1.0) << name << " " << line;
      EXPECT_NEAR(range.max_value, wanted, 5e-4 * wanted + 1.0) << name << " " << line;
    }
  }
}

// Slowly enough there is no inertia: at the crest the tensions are those of statics with the vessel that much higher.
TEST(lifts_in_time, have_the_tensions_of_statics_where_the_vessel_heaves_slowly) {
  constexpr double kHeave = 0.3, kPeriod = 200.0;
  const Description d = read_case("DL12-three", 3);
  Model model = build_model(heaving(d, kHeave, kPeriod));
  const ModelEquilibrium rest = solve_equilibrium(model, nullptr);
  Simulation run(model, rest.solution.value(), 0.0, options_for(100.0, 100.0));
  Description higher = d;
  for (FreeLineDescription& line : higher.lines) {
    if (line.first.kind == LineEndKind::body) line.first.at.z() += kHeave;
  }
  Model raised = build_model(higher);
  const ModelEquilibrium crest = solve_equilibrium(raised, nullptr);
  for (const auto& [line, range] : record_tensions(run)) {
    if (line == "pipe") continue;
    const double up = at_rest(crest.lines, line), level = at_rest(rest.lines, line);
    const double wanted = up > level ? range.max_value : range.min_value;
    EXPECT_NEAR(wanted, up, 0.02 * std::abs(up - level) + 0.002 * up) << line;
  }
}

/// A short bar upright in air on a wire from the vessel.
Description suspended_bar_in_time() {
  Description d = read_case("DL8-one", 0);
  d.stage.reset();
  d.operation = {};
  d.environment.water_depth = 100.0;
  FreeLineDescription& bar = d.lines[0];
  bar.first.kind = LineEndKind::free;
  bar.second.kind = LineEndKind::free;
  bar.second.clamped = false;
  bar.segments[0].length = 4.0;
  bar.start = Vec3(20.0, 16.0, 0.0);
  FreeLineDescription& wire = d.lines[1];
  wire.first.at = Vec3(20.0, 16.0, 60.0);
  wire.second.arc_length = 2.0;
  wire.segments[0].length = 20.0;
  wire.segments[0].type.axial_stiffness = 4e5;
  return d;
}

// A mass on a spring whose other end heaves: amplitude k a / (1 - (w / w_n)^2) times (w / w_n)^2 about the weight.
TEST(lifts_in_time, swing_as_a_mass_on_a_spring) {
  constexpr double kHeave = 0.2, kPeriod = 6.0;
  const Description d = suspended_bar_in_time();
  Model model = build_model(heaving(d, kHeave, kPeriod));
  const ModelEquilibrium rest = solve_equilibrium(model, nullptr);
  ASSERT_TRUE(rest.solution) << rest.failure->why;
  const double weight = d.lines[0].segments[0].type.weight_in_air * 4.0;
  EXPECT_NEAR(at_rest(rest.lines, "davit 1"), weight, 1e-3 * weight);
  DynamicOptions options = options_for(12.0, 60.0);
  options.max_step = 0.02;
  Simulation run(model, *rest.solution, 0.0, options);
  const Range wire = record_tensions(run)["davit 1"];
  const double w = 2.0 * std::numbers::pi / kPeriod, natural_frequency = std::sqrt(4e5 / 20.0 * 9.80665 / weight);
  const double swing = weight / 9.80665 * w * w * kHeave / (1.0 - w * w / (natural_frequency * natural_frequency));
  EXPECT_NEAR(wire.max_value - weight, swing, 0.02 * swing);
  EXPECT_NEAR(weight - wire.min_value, swing, 0.02 * swing);
}

// A wire that snaps: energy is kept, and the peak does not depend on the step.
TEST(lifts_in_time, snap_with_a_load_that_does_not_depend_on_the_step) {
  double peak[2];
  for (const bool fine : {false, true}) {
    Model model = build_model(heaving(read_case("DL8-one", 1), 2.5, 8.0));
    const ModelEquilibrium rest = solve_equilibrium(model, nullptr);
    DynamicOptions options = options_for(4.0, 8.0);
    if (fine) options.max_step = 0.004;
    Simulation run(model, rest.solution.value(), 0.0, options);
    const Range wire = record_tensions(run)["davit 1"];
    EXPECT_EQ(wire.min_value, 0.0);
    EXPECT_LT(std::abs(run.energy().drift()), 1e-3);
    peak[fine ? 1 : 0] = wire.max_value;
  }
  EXPECT_NEAR(peak[0], peak[1], 0.02 * peak[1]);
}

TEST(lifts_in_time, go_on_from_a_checkpoint_bit_for_bit) {
  Model model = build_model(heaving(read_case("TI12-closed", 2), 0.5, 8.0));
  const ModelEquilibrium rest = solve_equilibrium(model, nullptr);
  const DynamicOptions options = options_for(4.0, 0.0);
  Simulation whole(model, rest.solution.value(), 0.0, options), second(model, *rest.solution, 0.0, options);
  ASSERT_TRUE(whole.advance(2.0));
  second.restore(whole.checkpoint());
  const auto a = record_tensions(whole), b = record_tensions(second);
  for (const auto& [line, range] : a) EXPECT_EQ(range.last, b.at(line).last) << line;
}

TEST(lifts_in_time, allocate_nothing_in_their_steps) {
  Model model = build_model(heaving(read_case("DL12-three", 3), 0.3, 8.0));
  const ModelEquilibrium rest = solve_equilibrium(model, nullptr);
  Simulation run(model, rest.solution.value(), 0.0, options_for(10.0, 0.0));
  ASSERT_TRUE(run.advance(1.0));
  const long before = testing::allocation_count();
  ASSERT_TRUE(run.advance(2.0));
  EXPECT_EQ(testing::allocation_count(), before);
}

}  // namespace
}  // namespace overbend
