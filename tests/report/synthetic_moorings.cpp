#include "report/synthetic_moorings.h"

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "base/constants.h"
#include "report/report.h"

namespace overbend::testing {
namespace {

constexpr std::array<const char*, 8> kNames = {
    "port bow",        "port forward breast",  "port aft breast",          "port stern",
    "starboard stern", "starboard aft breast", "starboard forward breast", "starboard bow"};
/// Heading of the bow, anticlockwise; the bow points east.
constexpr std::array<double, 8> kAngles = {25.0, 65.0, 115.0, 155.0, 205.0, 245.0, 295.0, 335.0};
constexpr std::array<double, 8> kTensions = {346.6, 321.7, 278.3, 253.4, 253.4, 278.3, 321.7, 346.6};
constexpr std::array<double, 8> kLengths = {1006.40, 1006.88, 1007.83, 1008.45, 1008.45, 1007.83, 1006.88, 1006.40};
constexpr double kWeight = 139.6, kHeight = 92.0, kBreaking = 2594e3, kHolding = 1500e3;

/// An inextensible catenary from the fairlead to touchdown, then straight on the bed.
void suspend_mooring_line(MooringLineResult& line) {
  const double a = line.horizontal / kWeight;
  const double reach = a * std::acosh(1.0 + kHeight / a);
  const Vec3 direction = (line.anchor_W - line.fairlead_W).cwiseProduct(Vec3(1.0, 1.0, 0.0));
  line.horizontal_distance = direction.norm();
  for (int i = 0; i <= 40; ++i) {
    const double x = reach * i / 40.0;
    Vec3 point = line.fairlead_W + direction.normalized() * x;
    point.z() = -89.0 + a * (std::cosh((reach - x) / a) - 1.0);
    line.shape_W.push_back(point);
  }
  line.shape_W.push_back(line.anchor_W);
  line.touchdown_distance = reach;
  line.suspended_length = a * std::sinh(reach / a);
  line.on_bed = line.length - line.suspended_length;
}

MooringLineResult make_line_result(std::size_t i, const Vec3& shift, double more) {
  MooringLineResult line;
  line.name = kNames[i];
  line.length = line.first_segment_length = kLengths[i];
  line.fairlead_tension = 1e3 * kTensions[i] + more;
  line.horizontal = line.fairlead_tension - kWeight * kHeight;
  line.declination = std::acos(line.horizontal / line.fairlead_tension);
  line.anchor_tension = line.horizontal - 0.2 * line.horizontal;
  const Vec3 drawn(i < 2 || i > 5 ? 57.0 : -57.0, i < 4 ? 15.0 : -15.0, 3.0);
  line.fairlead_W = drawn + shift;
  line.anchor_W = drawn + 1000.0 * Vec3(std::cos(kAngles[i] * kDegree), std::sin(kAngles[i] * kDegree), 0.0);
  line.anchor_W.z() = -89.0;
  line.azimuth = std::remainder(90.0 - kAngles[i] - 180.0, 360.0) * kDegree + std::numbers::pi;
  line.utilisation = line.fairlead_tension / kBreaking;
  line.anchor_utilisation = line.anchor_tension / kHolding;
  suspend_mooring_line(line);
  return line;
}

MooredState make_moored_state(const std::string& name, double surge, double sway, double stiffness) {
  MooredState state;
  state.name = name;
  state.vessel.surge = surge;
  state.vessel.sway = sway;
  state.vessel.yaw = 0.01 * sway;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const double pull = -std::cos(kAngles[i] * kDegree) * surge - std::sin(kAngles[i] * kDegree) * sway;
    state.moorings.push_back(make_line_result(i, {surge, sway, 0.0}, stiffness * pull));
  }
  return state;
}

/// History of low and high rows that swing slowly and with the waves.
HistorySummary make_history(const std::string& name, const char* units, double mean, double slow, double wave) {
  HistorySummary history{name, units, name, {mean - 2.0 * (slow + wave), mean + 2.0 * (slow + wave), mean, slow},
                         {},   {}};
  for (int i = 0; i < 1000; ++i) {
    const double position = mean + slow * (std::sin(0.19 * i) + 0.6 * std::sin(0.217 * i + 1.0));
    const double swing = wave * (1.0 + 0.4 * std::sin(1.7 * i));
    history.low.push_back(position - swing);
    history.high.push_back(position + swing);
  }
  return history;
}

MotionStatistics make_motion_statistics(double mean, double slow, double wave) {
  MotionStatistics motion;
  motion.whole = {mean - 2.4 * (slow + wave), mean + 2.6 * (slow + wave), mean, std::hypot(slow, wave)};
  motion.slow = {mean - 2.1 * slow, mean + 2.3 * slow, mean, slow};
  motion.wave = {-3.2 * wave, 3.3 * wave, 0.0, wave};
  motion.most_probable_min = mean - 3.0 * (slow + wave);
  motion.most_probable_max = mean + 3.1 * (slow + wave);
  motion.wave_cycles = 320.0;
  motion.slow_cycles = 46.0;
  return motion;
}

}  // namespace

MooringResults synthetic_moorings() {
  MooringResults results;
  results.rest = make_moored_state("static", 0.0, 0.0, 0.0);
  results.rest.vessel.natural_periods = {{"sway", 77.1}, {"surge", 66.9}, {"yaw", 44.6}};
  results.rest.vessel.stiffness.assign(36, 0.0);
  for (std::size_t i = 0; i < 6; ++i) results.rest.vessel.stiffness[7 * i] = 1.848e5 * std::pow(10.0, i);
  return results;
}

StaticResults synthetic_hull_alone(MooringResults moorings) {
  StaticResults results;
  results.title = "BGL-1 on eight moorings";
  results.version = "test";
  results.assumptions = {{AssumptionRank::governing, "Mooring lines are elastic catenaries."}};
  results.moorings = std::move(moorings);
  return results;
}

MooringResults synthetic_stages() {
  MooringResults results = synthetic_moorings();
  results.operation = "moored";
  results.stages = {make_moored_state("still", 0.0, 0.0, 0.0),
                    make_moored_state("current to port", -0.012, 2.593, 40e3),
                    make_moored_state("the same, starboard forward breast parted", -0.79, 7.92, 25e3)};
  results.stages[2].moorings[6].parted = true;
  return results;
}

MooringResults synthetic_pull_ahead() {
  MooringResults results = synthetic_moorings();
  results.operation = "pull_ahead";
  results.distance = 12.0;
  for (int i = 0; i <= 24; ++i) {
    MooredState state = make_moored_state(i == 0 ? "before" : "after", 0.5 * i, 0.0, 200.0);
    MoveStep step;
    step.advance = 0.5 * i;
    step.vessel.surge = 0.5 * i;
    for (std::size_t k = 0; k < 8; ++k) {
      state.moorings[k].first_segment_length -= 0.5 * i * std::cos(kAngles[k] * kDegree);
      step.lengths.push_back(state.moorings[k].first_segment_length);
      step.tensions.push_back(state.moorings[k].fairlead_tension);
    }
    PipeAtStep pipe;
    pipe.top_tension = 250e3 + 400.0 * i;
    pipe.overbend_bending_stress = 290e6 - 1e5 * i;
    pipe.overbend_strain = 0.0014;
    pipe.sagbend_bending_stress = 150e6 - 2e5 * i;
    pipe.max_reaction = 60e3;
    pipe.max_reaction_support = "ramp 3";
    pipe.lay_back = 410.0;
    pipe.stinger_tip_clearance = 0.42;
    step.pipe = pipe;
    results.steps.push_back(std::move(step));
    if (i == 0 || i == 24) results.stages.push_back(std::move(state));
  }
  for (std::size_t k = 0; k < 8; ++k) {
    const MooringLineResult& first = results.stages.front().moorings[k];
    const MooringLineResult& last = results.stages.back().moorings[k];
    results.winches.push_back({first.name, first.first_segment_length, last.first_segment_length,
                               first.fairlead_tension, last.fairlead_tension});
  }
  return results;
}

HullResults synthetic_hull() {
  HullResults hull;
  hull.states = 88;
  hull.groups = {{"surge, pitch", "state space", 16, -1.2e-7, 0.03, 0.0},
                 {"heave", "convolution", 0, 2.0e-5, 0.01, 1e-6}};
  hull.entries = {{"surge", "surge", 3.1, 8.0e5, 8.07e5, 0.004, 0.006},
                  {"surge", "pitch", 3.0, 0.0, 2.0e6, 0.002, 0.001}};
  hull.damping = {{"surge", 66.9, 3.6e6, 0.0002, 0.008, 0.012, 0.0, 0.0, 0.0202, 0.0002},
                  {"sway", 77.1, 4.54e6, 0.0002, 0.032, 0.115, 0.0, 0.0, 0.1472, 0.0002},
                  {"yaw", 44.6, 1.1e9, 0.0002, 0.01, 0.08, 0.0, 0.0, 0.0902, 0.0002}};
  hull.drift = {-45.4e3, 12.0e3, 1.2e6};
  hull.current = {1.0e3, 265.3e3, -3.0e5};
  hull.min_current_force = 146.0e3;
  hull.max_current_force = 398.0e3;
  hull.above_table = 0.004;
  return hull;
}

void add_moored_dynamics(DynamicResults& results) {
  VesselDynamics vessel;
  vessel.surge = make_motion_statistics(0.1, 0.4, 0.2);
  vessel.sway = make_motion_statistics(1.2, 1.1, 0.3);
  vessel.heave = make_motion_statistics(0.0, 0.001, 0.25);
  vessel.roll = make_motion_statistics(0.0, 0.0005, 0.02);
  vessel.pitch = make_motion_statistics(0.0, 0.0002, 0.01);
  vessel.yaw = make_motion_statistics(0.002, 0.004, 0.002);
  vessel.along = make_motion_statistics(0.1, 0.4, 0.2);
  vessel.across = make_motion_statistics(1.2, 1.1, 0.3);
  vessel.offset = make_motion_statistics(1.3, 1.0, 0.3);
  vessel.covariance = 0.2;
  vessel.cut_off = 28.0;
  vessel.confidence = "The run holds 46 slow cycles of sway.";
  results.vessel = vessel;
  for (const auto& [name, units, mean, slow, wave] :
       {std::tuple{"surge", "m", 0.1, 0.4, 0.2}, {"sway", "m", 1.2, 1.1, 0.3}, {"yaw", "rad", 0.002, 0.004, 0.002}}) {
    results.histories.push_back(make_history(std::string("vessel/") + name, units, mean, slow, wave));
    results.histories.push_back(make_history(std::string("vessel/slow_") + name, units, mean, slow, 0.0));
  }
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    MooringLineDynamics line;
    line.name = kNames[i];
    line.start_fairlead_tension = 1e3 * kTensions[i];
    line.fairlead_tension = make_motion_statistics(1e3 * kTensions[i], 18e3, 9e3);
    line.anchor_tension = make_motion_statistics(0.75e3 * kTensions[i], 17e3, 7e3);
    line.utilisation = line.fairlead_tension.whole.max / kBreaking;
    line.most_probable_utilisation = *line.fairlead_tension.most_probable_max / kBreaking;
    line.anchor_utilisation = line.anchor_tension.whole.max / kHolding;
    line.min_on_seabed = 310.0;
    results.histories.push_back(
        make_history("mooring/" + line.name + "/fairlead_tension", "N", 1e3 * kTensions[i], 18e3, 9e3));
    results.moorings.push_back(std::move(line));
  }
  results.moorings[6].events = {{1234.5, "brake renders"}};
  results.moorings[6].brake_rendered = 0.42;
}

Document moored_document_in_time() {
  StaticResults rest = synthetic_hull_alone(synthetic_moorings());
  rest.hull = synthetic_hull();
  DynamicResults results;
  results.duration = 3600.0;
  results.build_up = 240.0;
  results.output_step = 0.5;
  results.seed = 7;
  results.energy.kinetic = 8.2e5;
  results.energy.fluid = 4.1e7;
  results.energy.error = -3.1e4;
  results.energy.throughput = 2.2e8;
  results.run = {52'000, 12, 121'000, 24'000, 0.0008, 0.125, 8.1, 474.0, "generalized-alpha, spectral radius 0.6"};
  for (const auto& [name, units, slow, wave] :
       {std::tuple{"elevation", "m", 0.0, 1.0}, {"heave", "m", 0.001, 0.25}, {"pitch", "rad", 0.0002, 0.01}}) {
    results.histories.push_back(make_history(name, units, 0.0, slow, wave));
  }
  results.spectra.push_back({"heave", "m", {0.0, 0.05, 0.1, 0.15, 0.2}, {0.0, 0.1, 0.9, 0.2, 0.0}});
  results.spectra.push_back({"mooring/starboard forward breast/fairlead_tension",
                             "N",
                             {0.0, 0.05, 0.1, 0.15, 0.2},
                             {1e9, 2e8, 8e8, 3e8, 1e7}});
  results.extremes.push_back({"vessel/offset",
                              "m",
                              false,
                              210,
                              3.4,
                              3.9,
                              3.6,
                              4.4,
                              "Weibull",
                              "good",
                              "",
                              3.9,
                              3.6,
                              4.4,
                              4.0,
                              3.6,
                              4.5,
                              4.0,
                              3.5,
                              4.6,
                              true});
  add_moored_dynamics(results);
  return report_document(rest, results, example_text("moored-barge"));
}

StaticResults synthetic_lines() {
  StaticResults results;
  results.title = "A jumper";
  results.version = "test";
  LineResult line;
  line.name = "jumper";
  line.length = 170.0;
  line.elements = 40;
  for (int i = 0; i <= 40; ++i) {
    const double share = i / 40.0;
    LineNodeResult node;
    node.s = 170.0 * share;
    node.place = {-100.0 + 100.0 * share, 0.0, -55.0 + 50.0 * share - 60.0 * std::sin(std::numbers::pi * share)};
    node.tension = 12e3 + 60e3 * std::abs(share - 0.35);
    line.nodes.push_back(node);
  }
  line.min_tension = 12e3;
  line.max_tension = 51e3;
  line.first.tension = 33e3;
  line.second.tension = 51e3;
  results.lines.push_back(line);
  return results;
}

DynamicResults synthetic_lines_in_time() {
  DynamicResults results;
  results.duration = 54.0;
  results.build_up = 27.0;
  results.output_step = 1.0;
  LineDynamics line;
  line.name = "jumper";
  line.min_tension = 9.6e3;
  line.max_tension = 66.3e3;
  line.first_tension = {26e3, 43e3, 33e3, 5e3};
  line.second_tension = {41e3, 66e3, 51e3, 8e3};
  for (const LineNodeResult& node : synthetic_lines().lines.front().nodes) {
    line.min_tension_at_nodes.push_back(0.8 * node.tension);
    line.max_tension_at_nodes.push_back(1.3 * node.tension);
  }
  results.lines.push_back(line);
  HistorySummary first{"line/jumper/first_tension", "N", "", line.first_tension, {}, {}};
  HistorySummary second{"line/jumper/second_tension", "N", "", line.second_tension, {}, {}};
  for (int i = -27; i <= 54; ++i) {
    const double swing = std::sin(2.0 * std::numbers::pi * i / 27.0);
    first.low.push_back(33e3 + 8e3 * swing);
    second.low.push_back(51e3 + 12e3 * swing);
  }
  first.high = first.low;
  second.high = second.low;
  results.histories = {first, second};
  return results;
}

std::string example_text(const char* name) {
  std::ifstream in(std::string(OVERBEND_SOURCE_DIR) + "/examples/" + name + ".yaml");
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace overbend::testing
