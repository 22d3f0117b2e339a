/// Solves random lays with a given tension, then the same lays with the length and the anchor distance of that solution
/// in place of the tension, and compares the two tensions.
///
///     overbend_round_trips [COUNT] [SEED] [FILE.csv]
///
/// The lays are those of random_lays.h; every third carries buoyant stretches: buoyancy modules as structures, or a
/// length of pipe that floats.
#include <fmt/core.h>
#include <fmt/os.h>

#include <chrono>
#include <map>

#include "random_lays.h"
#include "statics/recovery/recovery.h"

namespace overbend {
namespace {

/// Stretches that weigh less than nothing under water, somewhere in the free span or on the bed behind it.
void add_buoyancy(std::uint64_t seed, Description& d) {
  Dice dice(seed + 2000003);
  if (!dice.chance(0.35)) return;
  const Section pipe = derive_section("pipe", d.pipe.section, d.environment.water_weight_density);
  const double depth = d.environment.water_depth;
  const int count = dice.integer(1, 3);
  double from = dice.between(0.2, 1.0) * depth - d.tensioner.x + 20.0;
  for (int i = 0; i < count; ++i) {
    StructureDescription buoy;
    buoy.name = fmt::format("buoy {}", i + 1);
    buoy.length = dice.between(2.0, 12.0);
    buoy.at = from + 0.5 * buoy.length;
    buoy.weight_submerged = -dice.between(0.0, 2.0) * pipe.weight_submerged * buoy.length;
    buoy.weight_in_air = 1.3 * pipe.weight_in_air * buoy.length;
    d.pipe.structures.push_back(buoy);
    from += buoy.length + dice.between(5.0, 60.0);
  }
}

struct Trip {
  std::string outcome;
  double given = 0.0, found = 0.0;  ///< Tensions [N].
  double seconds = 0.0;             ///< Time of the way back [s].
};

Trip make_trip(std::uint64_t seed) {
  Description d = random_lay(seed);
  add_buoyancy(seed, d);
  Model pulled = build_model(d);
  const StaticOutcome static_outcome = solve_statics(pulled);
  Trip trip;
  if (!static_outcome.solution) {
    trip.outcome = "tension: " + static_outcome.failure->what;
    return trip;
  }
  const StaticResults given = recover_statics(pulled, *static_outcome.solution);
  trip.given = given.top_tension;
  d.tensioner.tension.reset();
  d.pipe.length = given.total_length;
  d.pipe.anchor = given.stations.front().astern;
  Model anchored = build_model(d);
  const auto begin = std::chrono::steady_clock::now();
  const StaticOutcome back = solve_statics(anchored);
  trip.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!back.solution) {
    trip.outcome = back.failure->what;
    fmt::print("lay {}: tension {:.1f} kN, {} ({})\n", seed, 1e-3 * trip.given, back.failure->what, back.failure->why);
    return trip;
  }
  const StaticResults found = recover_statics(anchored, *back.solution);
  trip.found = found.top_tension;
  trip.outcome = std::abs(trip.found / trip.given - 1.0) < 2e-3 ? "equal" : "another tension";
  if (trip.outcome != "equal") {
    fmt::print("lay {}: tension {:.2f} kN given, {:.2f} kN found, method {}, {} structures, current {}, friction {}\n",
               seed, 1e-3 * trip.given, 1e-3 * trip.found, found.solve.method, d.pipe.structures.size(),
               !d.environment.current.empty(), d.environment.seabed.friction_lateral);
  }
  return trip;
}

}  // namespace
}  // namespace overbend

int main(int count, char** arguments) {
  const int lays = count > 1 ? std::stoi(arguments[1]) : 500;
  const std::uint64_t seed = count > 2 ? std::stoull(arguments[2]) : 1;
  auto csv = fmt::output_file(count > 3 ? arguments[3] : "round_trips.csv");
  csv.print("seed,outcome,given [kN],found [kN],time [ms]\n");
  std::map<std::string, int> outcomes;
  double max_time = 0.0, total = 0.0;
  for (int i = 0; i < lays; ++i) {
    const std::uint64_t number = seed + static_cast<std::uint64_t>(i);
    const overbend::Trip trip = overbend::make_trip(number);
    ++outcomes[trip.outcome];
    max_time = std::max(max_time, trip.seconds);
    total += trip.seconds;
    csv.print("{},{},{:.3f},{:.3f},{:.1f}\n", number, trip.outcome, 1e-3 * trip.given, 1e-3 * trip.found,
              1e3 * trip.seconds);
  }
  for (const auto& [outcome, times] : outcomes) fmt::print("{} x {}\n", times, outcome);
  fmt::print("way back: mean {:.1f} ms, longest {:.1f} ms\n", 1e3 * total / lays, 1e3 * max_time);
  return 0;
}
