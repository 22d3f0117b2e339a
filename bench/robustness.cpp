/// Solves many random but sensible lays from nothing and reports the share solved, the reasons of the rest, and the
/// times.
///
///     overbend_robustness [COUNT] [SEED] [FILE.csv] [yields | routes]
///
/// What is told of each lay in the file, places and reactions too, lets two programs be compared lay by lay.
///
/// With `routes` every lay has lateral friction, three of four a current and every other a route that bends, with 0.6
/// to 3 times the radius that friction holds; it says, too, how often no line of steady laying was found.
///
/// With `yields` the steel is X65, Ramberg-Osgood of an exponent between 8 and 40, which these stingers bend past
/// yield.
///
/// Pipes of 6 to 48 inch, depths of 10 to 2,500 m, S-lay and J-lay, 3 to 30 boxes of 1 to 4 rows, tension 1.05 to 4
/// times the least that the hanging pipe needs. A lay is sensible when its stinger bends the pipe within 0.15 to 0.3 %
/// strain and ends near the angle at which a pipe of that tension would leave it.
#include <fmt/core.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "base/constants.h"
#include "statics/lay_shape.h"
#include "statics/recovery.h"
#include "statics/statics.h"

namespace overbend {
namespace {

/// Own conversion to doubles: the standard's distributions differ between libraries.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : generator_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1.0p-53;
  }
  double log_between(double low, double high) { return low * std::pow(high / low, between(0.0, 1.0)); }
  int integer(int low, int high) {
    return low + static_cast<int>(generator_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double p) { return between(0.0, 1.0) < p; }

 private:
  std::mt19937_64 generator_;
};

constexpr double kInch = 0.0254;

/// Steel, a corrosion coating, and concrete until the empty pipe has the wanted specific gravity.
SectionDescription random_pipe(Dice& dice, double depth) {
  const std::vector<double> sizes{6.625, 8.625, 10.75, 12.75, 14, 16, 18, 20, 24, 28, 30, 32, 36, 40, 42, 48};
  const int last = depth > 1000.0 ? 8 : static_cast<int>(sizes.size()) - 1;  // no one lays 48 inch in 2,500 m
  SectionDescription pipe;
  pipe.steel.outside_diameter = sizes[static_cast<std::size_t>(dice.integer(0, last))] * kInch;
  const double ratio = depth > 1000.0 ? dice.between(13.0, 20.0) : dice.between(18.0, 40.0);
  pipe.steel.wall_thickness = pipe.steel.outside_diameter / ratio;
  pipe.steel.yield_stress = 448e6;
  pipe.coatings = {{"corrosion coating", 0.003, 9.3e3}};
  pipe.hydrodynamics.drag_axial = 0.03;
  const double wanted = dice.between(1.1, 1.6);
  for (int i = 0; i < 200; ++i) {
    const Section section = derive_section("pipe", pipe, 10.05e3);
    if (section.weight_in_air > wanted * 10.05e3 * section.external_area) {
      break;
    }
    pipe.coatings.resize(1);
    pipe.coatings.push_back({"concrete", 0.002 * (i + 1), 30e3});
  }
  return pipe;
}

/// Ramp boxes on a level line, then ramp and stinger on one arc, to the angle at which the pipe wants to leave.
void random_supports(Dice& dice, Description& d, double departure) {
  const double strain = dice.between(0.0015, 0.003);
  const double radius = std::max(60.0, 0.5 * d.pipe.section.steel.outside_diameter / strain);
  const double end_angle = std::clamp(departure * dice.between(0.8, 1.1), 4.0 * kDegree, 75.0 * kDegree);
  const double arc = radius * end_angle;
  const double level = dice.between(10.0, 40.0);
  const int boxes = std::clamp(static_cast<int>((arc + level) / dice.between(4.0, 12.0)), 3, 30);
  const double spacing = (arc + level) / boxes;
  RollerKindDescription kind;
  kind.name = "roller";
  kind.bottom = {dice.between(0.1, 0.25), dice.between(0.5, 1.5)};
  // No one lays across a current or a slope without upright side rollers.
  const bool current = !d.environment.current.empty() || d.environment.seabed.slope > 0.0;
  if (current || dice.chance(0.5)) {
    const double angle = dice.between(current ? 75.0 : 45.0, 90.0) * kDegree;
    kind.sides = SideRollerDescription{kind.bottom.radius, dice.between(0.6, 1.2), angle, dice.between(0.02, 0.1)};
  }
  if (dice.chance(0.3)) {
    kind.stiffness = dice.log_between(1e7, 1e9);
  }
  d.rollers = {kind};
  const int rows = dice.integer(1, 4);
  const double length = std::min(0.8 * spacing, dice.between(1.5, 5.0));
  const double noise = dice.between(0.0, 0.01);
  for (int i = 0; i < boxes; ++i) {
    const double u = spacing * (i + 0.6) - level;  // along the support line, the arc starts at 0
    const double angle = std::max(u, 0.0) / radius;
    BoxDescription box;
    box.name = fmt::format("box {}", i + 1);
    box.structure = angle < 0.5 * end_angle ? Structure::ramp : Structure::stinger;
    box.x = std::min(u, 0.0) + radius * std::sin(angle);
    box.z = -radius * (1.0 - std::cos(angle)) + dice.between(-noise, noise);
    box.length = length;
    box.rows = rows;
    box.roller = kind.name;
    d.supports.boxes.push_back(box);
  }
  d.tensioner.x = -level - dice.between(5.0, 20.0);
}

Description random_lay(std::uint64_t seed) {
  Dice dice(seed);
  Description d;
  d.title = fmt::format("random lay {}", seed);
  d.environment.water_depth = dice.log_between(10.0, 2500.0);
  d.environment.seabed.stiffness = dice.log_between(2e4, 1e6);
  d.pipe.section = random_pipe(dice, d.environment.water_depth);
  d.vessel.heading = dice.between(0.0, 2.0 * std::numbers::pi);
  d.vessel.stern_shoe_x = -60.0;
  d.vessel.stern_shoe_z = dice.between(2.0, 10.0);
  if (dice.chance(0.25)) {
    d.environment.seabed.slope = dice.between(0.0, 3.0) * kDegree;
    d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = 0.5;
    d.environment.seabed.slope_towards = dice.between(0.0, 2.0 * std::numbers::pi);
  }
  if (dice.chance(0.4)) {
    d.environment.seabed.friction_lateral = 0.5;
    const double towards = dice.between(0.0, 2.0 * std::numbers::pi);
    const double speed = dice.between(0.1, 0.8);
    d.environment.current = {{0.0, speed, towards},
                             {d.environment.water_depth, 0.2 * speed, towards + dice.between(-0.5, 0.5)}};
  }
  const bool j_lay = d.environment.water_depth > 150.0 && dice.chance(0.4);
  const Section pipe = derive_section("pipe", d.pipe.section, d.environment.water_weight_density);
  const double above = j_lay ? dice.between(10.0, 40.0) : d.vessel.stern_shoe_z;
  const double least = pipe.weight_submerged * d.environment.water_depth + pipe.weight_in_air * above;
  const double factor = dice.log_between(1.05, 4.0);
  d.tensioner.tension = factor * least;
  if (j_lay) {
    d.tensioner.guide = Guide::pinned;
    d.tensioner.z = above - d.vessel.stern_shoe_z;
    return d;
  }
  d.tensioner.z = 0.5 * pipe.outer_diameter;
  // The pipe of a heavy stinger leaves where the hanging line has the support's slope; bending lets a stiff pipe leave
  // flatter.
  const double bottom = std::max((factor - 1.0) * least, std::cbrt(pipe.EI * std::pow(pipe.weight_submerged, 2)));
  const double rise = 1.0 + pipe.weight_submerged * d.environment.water_depth / bottom;
  random_supports(dice, d, std::acos(1.0 / rise));
  return d;
}

/// From the same seed, so that lays without `routes` stay what they are.
void put_on_route(std::uint64_t seed, Description& d) {
  Dice dice(seed + 1000003);
  d.environment.seabed.friction_lateral = dice.between(0.3, 0.8);
  if (d.environment.current.empty() && dice.chance(0.6)) {
    const double towards = dice.between(0.0, 2.0 * std::numbers::pi), speed = dice.between(0.1, 0.8);
    d.environment.current = {{0.0, speed, towards}, {d.environment.water_depth, 0.2 * speed, towards}};
  }
  if (dice.chance(0.5)) return;
  const Section pipe = derive_section("pipe", d.pipe.section, d.environment.water_weight_density);
  const double least = pipe.weight_submerged * d.environment.water_depth;
  const double held = std::max(*d.tensioner.tension - least, 0.05 * least) /
                      (d.environment.seabed.friction_lateral * pipe.weight_submerged);
  const double sharpest = 1000.0 * d.pipe.section.steel.outside_diameter;  // no one bends a pipe more on purpose
  const double length = dice.between(1.0, 4.0) * std::sqrt(held * d.environment.water_depth);
  d.route.legs = {{length, 0.0, 0.0},
                  {0.0, std::max(dice.between(0.6, 3.0) * held, sharpest),
                   (dice.chance(0.5) ? 1.0 : -1.0) * dice.between(2.0, 40.0) * kDegree}};
}

struct Tally {
  int beside = 0;  ///< For which no line of steady laying was found.
  int solved = 0, wrong = 0;
  int missed = 0;             ///< Whose recovered tension misses the wanted one by more than 0.1 %.
  double largest_miss = 0.0;  ///< Over the wanted tension [-].
  std::map<std::string, int> reasons;
  std::vector<double> times;
};

MaterialDescription random_material(std::uint64_t seed) {
  Dice dice(seed);
  MaterialDescription material;
  material.law = MaterialLaw::ramberg_osgood;
  material.hardening_exponent = dice.between(8.0, 40.0);
  return material;
}

void run_one(std::uint64_t seed, const std::string& kind, Tally& tally, fmt::ostream& csv) {
  Description d = random_lay(seed);
  if (kind == "routes") put_on_route(seed, d);
  if (kind == "yields") d.pipe.section.steel.material = random_material(seed);
  const Model model = build_model(d);
  const StaticOutcome outcome = solve_statics(model);
  const double diameter = d.pipe.section.steel.outside_diameter / kInch;
  csv.print("{},{:.4g},{:.1f},{:.1f},{},{},", seed, diameter, d.environment.water_depth, 1e-3 * *d.tensioner.tension,
            d.supports.boxes.size(), model.supports.rows.size());
  if (!outcome.solution) {
    ++tally.reasons[outcome.failure->what];
    csv.print("{},,,,,,,,\n", outcome.failure->what);
    fmt::print("lay {}: {:.4g} inch, {:.0f} m, {} boxes: {} ({})\n", seed, diameter, d.environment.water_depth,
               d.supports.boxes.size(), outcome.failure->what, outcome.failure->why);
    return;
  }
  const StaticResults results = recover_statics(model, *outcome.solution);
  const bool sound =
      results.force_residual < 1e-9 && results.global_residual < 1e-8 && std::isfinite(results.sagbend.von_mises.value);
  tally.solved += sound ? 1 : 0;
  tally.wrong += sound ? 0 : 1;
  const bool beside = std::ranges::any_of(
      results.warnings, [](const std::string& warning) { return warning.starts_with("steady laying"); });
  if (beside) {
    ++tally.beside;
    fmt::print("lay {}: no line of steady laying\n", seed);
  }
  const double miss = std::abs(results.top_tension / *d.tensioner.tension - 1.0);
  tally.missed += miss > 1e-3 ? 1 : 0;
  tally.largest_miss = std::max(tally.largest_miss, miss);
  tally.times.push_back(results.solve.wall_time);
  double lateral = 0.0;
  for (const SupportResult& support : results.supports) lateral = std::max(lateral, std::abs(support.lateral));
  csv.print("solved,{},{:.2f},{:.1e},{:.1e},{:.7g},{:.7g},{:.5f},{:.6g}\n", results.solve.method,
            1e3 * results.solve.wall_time, results.force_residual, results.global_residual, results.bottom_tension,
            results.lay_back, (results.touchdown.p_W - results.stations.back().p_W).y(), lateral);
  if (!sound) {
    fmt::print("lay {}: unsound, residual {:.1e}, global {:.1e}\n", seed, results.force_residual,
               results.global_residual);
  }
}

}  // namespace
}  // namespace overbend

int main(int count, char** words) {
  const int lays = count > 1 ? std::stoi(words[1]) : 1000;
  const std::uint64_t seed = count > 2 ? std::stoull(words[2]) : 1;
  auto csv = fmt::output_file(count > 3 ? words[3] : "robustness.csv");
  csv.print(
      "seed,diameter [in],depth [m],tension [kN],boxes,rows,outcome,method,time [ms],residual,global residual,"
      "bottom tension [N],lay-back [m],across [m],largest lateral reaction [N]\n");
  const std::string kind = count > 4 ? words[4] : "";
  overbend::Tally tally;
  for (int i = 0; i < lays; ++i) {
    overbend::run_one(seed + static_cast<std::uint64_t>(i), kind, tally, csv);
  }
  std::sort(tally.times.begin(), tally.times.end());
  fmt::print("{} of {} lays solved ({:.2f} %), {} unsound\n", tally.solved, lays, 100.0 * tally.solved / lays,
             tally.wrong);
  fmt::print("{} without a line of steady laying\n", tally.beside);
  fmt::print("{} miss the wanted tension by more than 0.1 %, the largest miss is {:.2g} %\n", tally.missed,
             100.0 * tally.largest_miss);
  for (const auto& [reason, times] : tally.reasons) {
    fmt::print("  {} x {}\n", times, reason);
  }
  if (!tally.times.empty()) {
    const auto quantile = [&](double q) {
      return 1e3 * tally.times[static_cast<std::size_t>(q * static_cast<double>(tally.times.size() - 1))];
    };
    fmt::print("solver time: median {:.1f} ms, 90 % {:.1f} ms, longest {:.1f} ms\n", quantile(0.5), quantile(0.9),
               quantile(1.0));
  }
  return 0;
}
