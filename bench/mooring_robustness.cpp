/// Finds the rest of many random but sensible moorings from nothing and reports the share solved, the reasons of the
/// rest, and the times.
///
///     overbend_mooring_robustness [COUNT] [SEED]
///
/// Hulls of 60 to 300 m on 4 to 12 lines, 20 to 500 m of water, spans of 3 to 20 depths, wire, chain, chain behind wire
/// and wire with a clump or a buoy, tensions of 3 to 40 % of the breaking load, loads of up to half of what all lines
/// pull. A tension that a line cannot have at its span (less than the weight that hangs from the fairlead) is a true
/// rejection; so is a line that would break before it reaches.
#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <ctime>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "model/description/description.h"
#include "model/pipe/line_types.h"
#include "moorings/equilibrium.h"

namespace overbend {
namespace {

constexpr double kWaterDensityWeight = 10.05e3;

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

 private:
  std::mt19937_64 generator_;
};

struct Trial {
  Description description;
  StaticHull hull;
  double depth = 0.0;
};

LineSegmentDescription segment(std::optional<double> length, LineTypeDescription type) {
  LineSegmentDescription made;
  made.length = length;
  type.weight_submerged = submerged_weight(type, kWaterDensityWeight);
  made.type = std::move(type);
  return made;
}

MooringLineDescription random_line(Dice& dice, const Trial& trial, double azimuth, double share) {
  const VesselDescription& vessel = trial.description.vessel;
  const double span = trial.depth * dice.log_between(3.0, 20.0);
  const double wire = dice.log_between(0.03, 0.12), bar = dice.log_between(0.04, 0.12);
  MooringLineDescription line;
  line.azimuth = azimuth;
  line.fairlead = {0.48 * vessel.length * (std::cos(azimuth) > 0.0 ? 1.0 : -1.0) * dice.between(0.6, 1.0),
                   -0.5 * vessel.beam * (std::sin(azimuth) > 0.0 ? 1.0 : -1.0), dice.between(-5.0, 8.0)};
  line.anchor_distance = span;
  const int kind = dice.integer(0, 3);
  if (kind == 0) {
    line.segments = {segment(std::nullopt, chain(bar, ChainLink::studless))};
  } else if (kind == 1) {
    line.segments = {segment(std::nullopt, wire_rope(wire, RopeCore::wire)),
                     segment(dice.between(0.1, 0.4) * span, chain(bar, ChainLink::studless))};
  } else {
    line.segments = {segment(std::nullopt, wire_rope(wire, RopeCore::wire))};
  }
  line.tension = share * *line.segments.front().type.breaking_load;
  return line;
}

Trial random_trial(Dice& dice) {
  Trial trial;
  VesselDescription& vessel = trial.description.vessel;
  vessel.length = dice.log_between(60.0, 300.0);
  vessel.beam = vessel.length * dice.between(0.15, 0.35);
  trial.depth = dice.log_between(20.0, 500.0);
  MooringsDescription& moorings = trial.description.moorings.emplace();
  const int count = dice.integer(4, 12);
  const double share = dice.log_between(0.03, 0.4);
  double pulls = 0.0;
  for (int i = 0; i < count; ++i) {
    const double azimuth = 2.0 * std::numbers::pi * (i + dice.between(0.25, 0.75)) / count;
    MooringLineDescription& line =
        moorings.lines.emplace_back(random_line(dice, trial, azimuth, share * dice.between(0.7, 1.4)));
    line.name = fmt::format("line {}", i + 1);
    pulls += *line.tension;
  }
  moorings.bed_friction = dice.integer(0, 1) == 0 ? 0.0 : 0.6;
  trial.hull.length = vessel.length;
  const double plane = kWaterDensityWeight * vessel.length * vessel.beam * 0.85;
  trial.hull.restoring =
      Vec3(plane, plane * vessel.beam * vessel.beam / 14.0, plane * vessel.length * vessel.length / 14.0).asDiagonal();
  const double towards = dice.between(0.0, 2.0 * std::numbers::pi), load = dice.between(0.0, 0.15) * pulls;
  trial.hull.steady << load * std::cos(towards), load * std::sin(towards), 0.0, 0.0, 0.0,
      dice.between(-0.05, 0.05) * load * vessel.length;
  return trial;
}

/// True if the rejected line cannot have its tension: less than what hangs from the fairlead to the bed.
bool asks_too_little(const Trial& trial, const MooringSpread& spread) {
  const MooringLineDescription& asked = trial.description.moorings->lines[spread.lines.size() - 1];
  const MooredLine& line = spread.lines.back();
  const double bed = std::min(line.anchor_W.z(), spread.bed.height(asked.fairlead.x(), asked.fairlead.y()));
  const double wet = -bed + std::min(asked.fairlead.z(), 0.0);
  const LineTypeDescription& first = asked.segments.front().type;
  const double weight = std::max(asked.fairlead.z(), 0.0) * first.weight_in_air + wet * first.weight_submerged;
  return *asked.tension < 1.05 * weight;
}

/// Clumps and buoys on every third mooring, at a third of the line as found.
void add_point(Dice& dice, MooringSpread& spread) {
  for (MooredLine& line : spread.lines) {
    CatenaryPiece& first = line.line.pieces.front();
    CatenaryPiece rest = first;
    const double position = dice.between(0.2, 0.6) * first.length;
    rest.length = first.length - position;
    first.length = position;
    line.line.first_segment_rest += rest.length;
    line.line.pieces.insert(line.line.pieces.begin() + 1, rest);
    const double weight = dice.between(5.0, 60.0) * rest.weight_submerged;
    CatenaryPoint point;
    point.pull_up = dice.integer(0, 1) == 0 ? -weight : weight;
    point.buoyancy = std::max(1.2 * point.pull_up, 0.0);
    point.height = 2.0;
    line.line.points = {point};
  }
}

}  // namespace
}  // namespace overbend

int main(int argc, char** argv) {
  using namespace overbend;
  const int count = argc > 1 ? std::stoi(argv[1]) : 1000;
  Dice dice(argc > 2 ? std::stoull(argv[2]) : 1);
  int solved = 0, rejected = 0;
  double max_time = 0.0, total = 0.0;
  std::map<std::string, int> failures;
  for (int i = 0; i < count; ++i) {
    Trial trial = random_trial(dice);
    const SeabedSurface bed(Vec3(0.0, 0.0, -trial.depth),
                            (Vec3::UnitZ() + dice.between(0.0, 0.03) * Vec3::UnitX() * (i % 2)).normalized());
    SpreadOutcome outcome = build_spread(*trial.description.moorings, bed, Mat3::Identity());
    if (outcome.error) {
      if (asks_too_little(trial, outcome.spread)) {
        ++rejected;
      } else {
        fmt::print("trial {}: {}\n", i, *outcome.error);
      }
      continue;
    }
    if (i % 3 == 0) add_point(dice, outcome.spread);
    const std::clock_t start = std::clock();  // of this process: the machine may be busy
    const HullEquilibrium rest = find_hull_equilibrium(outcome.spread, trial.hull, HullOffset::Zero());
    const double time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    max_time = std::max(max_time, time);
    total += time;
    if (!rest.error) {
      ++solved;
    } else {
      ++failures[*rest.error];
      fmt::print("trial {}: {}\n", i, *rest.error);
    }
  }
  fmt::print("{} solved, {} rejected for an infeasible tension, {} failed of {}: {:.2f} % solved or rightly rejected\n",
             solved, rejected, count - solved - rejected, count, 100.0 * (solved + rejected) / count);
  fmt::print("time of a rest: mean {:.3f} ms, longest {:.2f} ms\n", 1e3 * total / std::max(count - rejected, 1),
             1e3 * max_time);
  return 0;
}
