#include "study/run/motion_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/constants.h"
#include "mechanics/record_components.h"
#include "mechanics/wave_spectrum.h"
#include "moorings/clearance.h"
#include "numerics/low_pass.h"
#include "numerics/record_part.h"
#include "study/run/non_stationary.h"

namespace overbend {
namespace {

constexpr double kMinCutOff = 20.0;             ///< [s]
constexpr double kVarianceBeyondCutOff = 1e-3;  ///< Fraction of the sea's variance beyond the cut-off period [-].
constexpr double kCutOffMargin = 1.1;           ///< Cut-off period over that period [-].
constexpr double kRegularWaveFactor = 1.6;      ///< Cut-off period over the period of a regular wave [-].
constexpr double kFewCycles = 20.0;        ///< Below this number of slow cycles the standard deviation is uncertain by
                                           ///< more than a tenth.
constexpr double kBuildUpPeriods = 3.0;    ///< Build-up in periods of the slowest mode, for it to settle.
constexpr double kMinSlowFraction = 0.02;  ///< Fraction of the whole standard deviation below which the slow part is
                                           ///< not reported [-].
constexpr double kResolution = 0.125;  ///< Sampling interval of slow parts, as a fraction of the cut-off period [-].

constexpr int kPointNumbers = 4;  ///< Numbers stored per point of a line in a snapshot.

using Values = std::vector<double>;

/// Output rows of a run.
class OutputRows {
 public:
  OutputRows(RunStore& store, double step, double cut_off, bool stationary)
      : store_(store), time_(store.column(0)), step_(step), cut_off_(cut_off), stationary_(stationary) {
    const auto counted = std::lower_bound(time_.begin(), time_.end(), -1e-6 * step);
    first_ = static_cast<std::size_t>(counted - time_.begin());
  }

  /// Fills the parts of the quantity in the column of this name; stores its slow part as a column if `slow_name` is not
  /// empty. Does nothing without the column, or with fewer than two rows.
  void add_parts(const std::string& name, const std::string& slow_name, MotionStatistics& out) {
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
  static SummaryStatistics compute_spread(std::span<const double> values) {
    const auto [min, max] = std::minmax_element(values.begin(), values.end());
    const auto count = static_cast<double>(values.size());
    SummaryStatistics s{*min, *max, std::accumulate(values.begin(), values.end(), 0.0) / count, 0.0};
    for (const double value : values) s.std += (value - s.mean) * (value - s.mean);
    s.std = std::sqrt(s.std / count);
    return s;
  }

  void fill(std::span<const double> slow, std::span<const double> wave, MotionStatistics& out) const {
    out.slow = compute_spread(slow);
    out.wave = compute_spread(wave);
    const auto heights = [&](std::span<const double> part) { return compute_heights(part, step_, kThreeHours); };
    const PartHeights up = heights(slow), waves_up = heights(wave);
    out.slow_cycles = up.cycles;
    out.wave_cycles = waves_up.cycles;
    out.slow_std_error = deviation_error(slow, step_, kResolution * cut_off_);
    if (!stationary_) return;
    out.most_probable_max = out.slow.mean + combined_height(up, waves_up);
    const PartHeights down = heights(negated(slow)), waves_down = heights(negated(wave));
    out.most_probable_min = out.slow.mean - combined_height(down, waves_down);
  }

  static Values negated(std::span<const double> values) {
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

/// A distance is never negative, and a line carries no compression: limits the extreme of the sum to zero. A value that
/// was itself slightly negative by rounding stays.
void limit_to_positive(MotionStatistics& out) {
  if (out.most_probable_min) out.most_probable_min = std::max(*out.most_probable_min, std::min(0.0, out.whole.min));
}

/// Returns the motion relative to another origin.
MotionStatistics shifted(MotionStatistics from, const SummaryStatistics& whole, double by) {
  for (double* value : {&from.slow.min, &from.slow.max, &from.slow.mean}) *value += by;
  for (std::optional<double>* value : {&from.most_probable_min, &from.most_probable_max}) {
    if (*value) **value += by;
  }
  from.whole = whole;
  return from;
}

/// Returns surge or sway, the one with the larger slow standard deviation.
std::pair<const char*, const MotionStatistics*> slowest(const VesselDynamics& vessel) {
  return vessel.surge.slow.std > vessel.sway.slow.std ? std::pair{"surge", &vessel.surge}
                                                      : std::pair{"sway", &vessel.sway};
}

bool is_significant(const MotionStatistics& motion) {
  return motion.slow.std > kMinSlowFraction * motion.whole.std && motion.slow.std > 0.0;
}

std::string confidence_message(const char* name, const MotionStatistics& motion) {
  if (motion.slow_cycles < 2.0 || motion.slow_std_error <= 0.0) {
    return fmt::format(
        "The run holds {:.0f} slow cycles of {}, too few to estimate how far its slow standard deviation and extremes "
        "may be from those of another seed.",
        motion.slow_cycles, name);
  }
  return fmt::format(
      "The run holds {:.0f} slow cycles of {}; another seed may give a slow standard deviation that differs by {:.0f} "
      "% (one standard error), and extremes accordingly.",
      motion.slow_cycles, name, 100.0 * motion.slow_std_error);
}

void add_confidence(DynamicResults& results) {
  VesselDynamics& vessel = *results.vessel;
  const auto [name, motion] = slowest(vessel);
  if (!is_significant(*motion)) {
    vessel.confidence = "No significant slow motion.";
    return;
  }
  vessel.confidence = confidence_message(name, *motion);
  if (motion->slow_cycles >= kFewCycles) return;
  results.findings.push_back(Finding{
      FindingCode::few_slow_cycles,
      fmt::format("the run of {:.3g} min holds {:.0f} slow cycles of {}, fewer than {:.0f}: statistics of offsets and "
                  "mooring tensions are not converged; run three hours, or several seeds",
                  results.duration / 60.0, motion->slow_cycles, name, kFewCycles)}
                                 .on(name)
                                 .with("cycles", motion->slow_cycles, "1"));
}

void warn_of_build_up(const StaticResults& statics, DynamicResults& results) {
  if (!statics.moorings || !is_significant(*slowest(*results.vessel).second)) return;
  const PeriodResult* slowest_mode = nullptr;
  for (const PeriodResult& period : statics.moorings->rest.vessel.natural_periods) {
    if (period.mode != "surge" && period.mode != "sway" && period.mode != "yaw") continue;
    if (slowest_mode == nullptr || period.period > slowest_mode->period) slowest_mode = &period;
  }
  if (slowest_mode == nullptr || results.build_up >= kBuildUpPeriods * slowest_mode->period) return;
  results.findings.push_back(Finding{
      FindingCode::build_up_too_short,
      fmt::format("the build-up of {:.0f} s is shorter than three natural periods of slow {} ({:.1f} s each): the slow "
                  "motion has not settled when the statistics begin",
                  results.build_up, slowest_mode->mode, slowest_mode->period)}
                                 .on(slowest_mode->mode)
                                 .with("build_up", results.build_up, "s"));
}

/// Updates the minimum distance of the line through `points` to the objects.
void keep_clearance(const std::vector<SeabedObjectDescription>& objects, const std::vector<Vec3>& points,
                    MooringLineDynamics& line) {
  for (const SeabedObjectDescription& object : objects) {
    const double distance = polyline_distance(points, object.points);
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
    const double* value = snapshot.data() + first;
    for (MooringLineDynamics& line : lines) {
      points.clear();
      for (std::size_t k = 0; k < line.points.size(); ++k, value += kPointNumbers) {
        points.emplace_back(value[0], value[1], value[2]);
      }
      keep_clearance(objects, points, line);
    }
  }
}

/// Returns the period of a record beyond which the fraction kVarianceBeyondCutOff of its variance lies [s].
double slowest_period(const ElevationRecord& record) {
  const std::vector<RecordComponent> components = record_components(record);
  double energy = 0.0, passed = 0.0;
  for (const RecordComponent& c : components) energy += c.amplitude * c.amplitude;
  for (const RecordComponent& c : components) {
    passed += c.amplitude * c.amplitude;
    if (passed >= kVarianceBeyondCutOff * energy) return 2.0 * std::numbers::pi / c.omega;
  }
  return 0.0;
}

}  // namespace

double cut_off_period(const WaveGroups& groups) {
  double period = kMinCutOff;
  for (const WavesDescription& waves : groups) {
    if (is_random(waves.type)) {
      const double slowest = WaveSpectrum(waves).quantile(kVarianceBeyondCutOff);
      period = std::max(period, kCutOffMargin * 2.0 * std::numbers::pi / slowest);
    } else if (is_regular(waves.type) && waves.period > 0.0) {
      period = std::max(period, kRegularWaveFactor * waves.period);
    } else if (waves.type == WaveType::elevation) {
      period = std::max(period, kCutOffMargin * slowest_period(waves.record));
    }
  }
  return period;
}

void finish_motions(const StaticResults& statics, const Description& description, DynamicResults& results,
                    RunStore& store) {
  if (!results.vessel) return;
  VesselDynamics& vessel = *results.vessel;
  vessel.cut_off = cut_off_period(description.environment.waves);
  results.non_stationary = non_stationary(description, results);
  OutputRows rows(store, results.output_step, vessel.cut_off, results.non_stationary.empty());
  const std::array<std::pair<const char*, MotionStatistics*>, 7> motions = {{{"surge", &vessel.surge},
                                                                             {"sway", &vessel.sway},
                                                                             {"heave", &vessel.heave},
                                                                             {"roll", &vessel.roll},
                                                                             {"pitch", &vessel.pitch},
                                                                             {"yaw", &vessel.yaw},
                                                                             {"offset", &vessel.offset}}};
  for (const auto& [name, motion] : motions) {
    const bool horizontal = motion == &vessel.surge || motion == &vessel.sway || motion == &vessel.yaw;
    rows.add_parts(std::string("vessel/") + name, horizontal ? std::string("vessel/slow_") + name : "", *motion);
  }
  limit_to_positive(vessel.offset);
  vessel.along = shifted(vessel.surge, vessel.along.whole, -vessel.start_surge);
  vessel.across = shifted(vessel.sway, vessel.across.whole, -vessel.start_sway);
  for (MooringLineDynamics& line : results.moorings) {
    const std::string prefix = "mooring/" + line.name + "/";
    rows.add_parts(prefix + "fairlead_tension", prefix + "slow_fairlead_tension", line.fairlead_tension);
    rows.add_parts(prefix + "anchor_tension", "", line.anchor_tension);
    limit_to_positive(line.fairlead_tension);
    limit_to_positive(line.anchor_tension);
    const double whole = line.fairlead_tension.whole.max;
    if (line.utilisation && whole > 0.0 && line.fairlead_tension.most_probable_max) {
      line.most_probable_utilisation = *line.utilisation * *line.fairlead_tension.most_probable_max / whole;
    }
  }
  if (description.moorings) find_clearances(description.moorings->objects, store, results.moorings);
  add_confidence(results);
  warn_of_build_up(statics, results);
}

}  // namespace overbend
