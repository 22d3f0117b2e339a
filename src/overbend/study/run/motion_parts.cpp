#include "study/run/motion_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/constants.h"
#include "mechanics/wave_spectrum.h"
#include "moorings/clearance.h"
#include "numerics/low_pass.h"
#include "numerics/record_part.h"
#include "study/run/non_stationary.h"

namespace overbend {
namespace {

constexpr double kShortestCutOff = 20.0;  ///< [s]
constexpr double kLeftToSlow = 1e-3;      ///< Share of the sea's variance beyond the cut-off period.
constexpr double kMargin = 1.1;           ///< Of the cut-off period over that.
constexpr double kRegular = 1.6;          ///< Likewise over the period of a regular wave.
constexpr double kFewCycles = 20.0;       ///< Fewer slow cycles do not tell their deviation to a tenth.
constexpr double kBuildUpPeriods = 3.0;   ///< Of the slowest mode, for it to settle.
constexpr double kSlowShare = 0.02;       ///< Of the whole deviation; below it the slow part is not worth a word.
constexpr double kResolution = 0.125;     ///< Of the cut-off period: slow parts change no faster.

constexpr int kPointNumbers = 4;  ///< Of a point of a line in a snapshot.

using Values = std::vector<double>;

/// The rows of a run.
class Rows {
 public:
  Rows(RunStore& store, double step, double cut_off, bool stationary)
      : store_(store), time_(store.column(0)), step_(step), cut_off_(cut_off), stationary_(stationary) {
    const auto counted = std::lower_bound(time_.begin(), time_.end(), -1e-6 * step);
    first_ = static_cast<std::size_t>(counted - time_.begin());
  }

  /// Fills the parts of the quantity that the column of this name holds; its slow part becomes a column where one is
  /// named. Nothing without the column, or with a few rows only.
  void tell(const std::string& name, const std::string& slow_name, MotionSpread& out) {
    const auto& columns = store_.columns();
    const auto found = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.name == name; });
    if (found == columns.end() || time_.size() < first_ + 2) return;
    Values values = store_.column(static_cast<std::size_t>(found - columns.begin()));
    Values slow = low_pass(values, step_, cut_off_);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] -= slow[i];
    fill(std::span(slow).subspan(first_), std::span(values).subspan(first_), out);
    if (!slow_name.empty()) {
      const HistoryColumn part{slow_name, found->units, found->description + ", slow part"};
      store_.derive(part, std::move(slow));
    }
  }

 private:
  static Spread spread_of(std::span<const double> values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const auto count = static_cast<double>(values.size());
    Spread s{*least, *most, std::accumulate(values.begin(), values.end(), 0.0) / count, 0.0};
    for (const double value : values) s.std += (value - s.mean) * (value - s.mean);
    s.std = std::sqrt(s.std / count);
    return s;
  }

  void fill(std::span<const double> slow, std::span<const double> wave, MotionSpread& out) const {
    out.slow = spread_of(slow);
    out.wave = spread_of(wave);
    const auto heights = [&](std::span<const double> part) { return heights_of(part, step_, kThreeHours); };
    const PartHeights up = heights(slow), waves_up = heights(wave);
    out.slow_cycles = up.cycles;
    out.wave_cycles = waves_up.cycles;
    out.slow_std_error = deviation_error(slow, step_, kResolution * cut_off_);
    if (!stationary_) return;
    out.most_probable_max = out.slow.mean + combined_height(up, waves_up);
    const PartHeights down = heights(turned(slow)), waves_down = heights(turned(wave));
    out.most_probable_min = out.slow.mean - combined_height(down, waves_down);
  }

  static Values turned(std::span<const double> values) {
    Values out(values.begin(), values.end());
    for (double& value : out) value = -value;
    return out;
  }

  RunStore& store_;
  Values time_;
  double step_, cut_off_;
  bool stationary_;
  std::size_t first_ = 0;  ///< Row of t = 0.
};

/// A distance is never below zero, and a line bears no push: what the least of the sum says below that is no value of
/// the quantity. One that was below zero itself, by a hair of the numbers, stays.
void keep_from_negative(MotionSpread& out) {
  if (out.most_probable_min) out.most_probable_min = std::max(*out.most_probable_min, std::min(0.0, out.whole.min));
}

/// The same from another origin.
MotionSpread shifted(MotionSpread from, const Spread& whole, double by) {
  for (double* value : {&from.slow.min, &from.slow.max, &from.slow.mean}) *value += by;
  for (std::optional<double>* value : {&from.most_probable_min, &from.most_probable_max}) {
    if (*value) **value += by;
  }
  from.whole = whole;
  return from;
}

/// Of surge and sway the one that moves more slowly.
std::pair<const char*, const MotionSpread*> slowest(const VesselDynamics& vessel) {
  return vessel.surge.slow.std > vessel.sway.slow.std ? std::pair{"surge", &vessel.surge}
                                                      : std::pair{"sway", &vessel.sway};
}

bool matters(const MotionSpread& motion) {
  return motion.slow.std > kSlowShare * motion.whole.std && motion.slow.std > 0.0;
}

std::string confidence_of(const char* name, const MotionSpread& motion) {
  if (motion.slow_cycles < 2.0 || motion.slow_std_error <= 0.0) {
    return fmt::format(
        "The run holds {:.0f} slow cycles of {}, too few to tell how far its slow standard deviation and extremes may "
        "be "
        "from those of another seed.",
        motion.slow_cycles, name);
  }
  return fmt::format(
      "The run holds {:.0f} slow cycles of {}; another seed may give a slow standard deviation that differs by {:.0f} "
      "% (one standard error), and extremes accordingly.",
      motion.slow_cycles, name, 100.0 * motion.slow_std_error);
}

void tell_confidence(DynamicResults& results) {
  VesselDynamics& vessel = *results.vessel;
  const auto [name, motion] = slowest(vessel);
  if (!matters(*motion)) {
    vessel.confidence = "No slow motion to speak of.";
    return;
  }
  vessel.confidence = confidence_of(name, *motion);
  if (motion->slow_cycles >= kFewCycles) return;
  results.findings.push_back(Finding{
      FindingCode::few_slow_cycles,
      fmt::format("the run of {:.3g} min holds {:.0f} slow cycles of {}, fewer than {:.0f}: statistics of offsets and "
                  "mooring tensions are those of chance; run three hours, or several seeds",
                  results.duration / 60.0, motion->slow_cycles, name, kFewCycles)}
                                 .on(name)
                                 .with("cycles", motion->slow_cycles, "1"));
}

void warn_of_build_up(const StaticResults& statics, DynamicResults& results) {
  if (!statics.moorings || !matters(*slowest(*results.vessel).second)) return;
  const PeriodResult* longest = nullptr;
  for (const PeriodResult& period : statics.moorings->rest.vessel.natural_periods) {
    if (period.mode != "surge" && period.mode != "sway" && period.mode != "yaw") continue;
    if (longest == nullptr || period.period > longest->period) longest = &period;
  }
  if (longest == nullptr || results.build_up >= kBuildUpPeriods * longest->period) return;
  results.findings.push_back(Finding{
      FindingCode::build_up_too_short,
      fmt::format("the build-up of {:.0f} s is shorter than three natural periods of slow {} ({:.1f} s each): the slow "
                  "motion has not settled when the statistics begin",
                  results.build_up, longest->mode, longest->period)}
                                 .on(longest->mode)
                                 .with("build_up", results.build_up, "s"));
}

/// Keeps the least distance of the line through `points` to the objects.
void keep_clearance(const std::vector<SeabedObjectDescription>& objects, const std::vector<Vec3>& points,
                    MooringLineDynamics& line) {
  for (const SeabedObjectDescription& object : objects) {
    const double distance = distance_between(points, object.points);
    if (line.clearance && *line.clearance <= distance) continue;
    line.clearance = distance;
    line.nearest_object = object.name;
  }
}

void find_clearances(const std::vector<SeabedObjectDescription>& objects, const RunStore& store,
                     std::vector<MooringLineDynamics>& lines) {
  if (objects.empty() || store.line_points() == 0) return;
  const std::size_t first = static_cast<std::size_t>(store.snapshot_size() - kPointNumbers * store.line_points());
  std::vector<Vec3> points;
  for (std::int64_t i = 0; i < store.snapshots(); ++i) {
    const Values snapshot = store.snapshot_block(i, 1);
    const double* at = snapshot.data() + first;
    for (MooringLineDynamics& line : lines) {
      points.clear();
      for (std::size_t k = 0; k < line.points.size(); ++k, at += kPointNumbers) {
        points.emplace_back(at[0], at[1], at[2]);
      }
      keep_clearance(objects, points, line);
    }
  }
}

}  // namespace

double cut_off_period(const WavesDescription& waves) {
  if (waves.type == WaveType::none) return kShortestCutOff;
  if (waves.period > 0.0 && (waves.type == WaveType::airy || waves.type == WaveType::stokes5)) {
    return std::max(kShortestCutOff, kRegular * waves.period);
  }
  const double slowest = WaveSpectrum(waves).quantile(kLeftToSlow);
  return std::max(kShortestCutOff, kMargin * 2.0 * std::numbers::pi / slowest);
}

void finish_motions(const StaticResults& statics, const Description& description, DynamicResults& results,
                    RunStore& store) {
  if (!results.vessel) return;
  VesselDynamics& vessel = *results.vessel;
  vessel.cut_off = cut_off_period(description.environment.waves);
  results.non_stationary = non_stationary(description, results);
  Rows rows(store, results.output_step, vessel.cut_off, results.non_stationary.empty());
  const std::array<std::pair<const char*, MotionSpread*>, 7> motions = {{{"surge", &vessel.surge},
                                                                         {"sway", &vessel.sway},
                                                                         {"heave", &vessel.heave},
                                                                         {"roll", &vessel.roll},
                                                                         {"pitch", &vessel.pitch},
                                                                         {"yaw", &vessel.yaw},
                                                                         {"offset", &vessel.offset}}};
  for (const auto& [name, motion] : motions) {
    const bool horizontal = motion == &vessel.surge || motion == &vessel.sway || motion == &vessel.yaw;
    rows.tell(std::string("vessel/") + name, horizontal ? std::string("vessel/slow_") + name : "", *motion);
  }
  keep_from_negative(vessel.offset);
  vessel.along = shifted(vessel.surge, vessel.along.whole, -vessel.start_surge);
  vessel.across = shifted(vessel.sway, vessel.across.whole, -vessel.start_sway);
  for (MooringLineDynamics& line : results.moorings) {
    const std::string of = "mooring/" + line.name + "/";
    rows.tell(of + "fairlead_tension", of + "slow_fairlead_tension", line.fairlead_tension);
    rows.tell(of + "anchor_tension", "", line.anchor_tension);
    keep_from_negative(line.fairlead_tension);
    keep_from_negative(line.anchor_tension);
    const double whole = line.fairlead_tension.whole.max;
    if (line.utilisation && whole > 0.0 && line.fairlead_tension.most_probable_max) {
      line.most_probable_utilisation = *line.utilisation * *line.fairlead_tension.most_probable_max / whole;
    }
  }
  if (description.moorings) find_clearances(description.moorings->objects, store, results.moorings);
  tell_confidence(results);
  warn_of_build_up(statics, results);
}

}  // namespace overbend
