#include "seafiles/motion_record_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/constants.h"
#include "base/ranges.h"
#include "seafiles/record_statistics.h"
#include "seafiles/sentinels.h"

namespace overbend {

const std::array<const char*, 6> kMotionColumns = {"surge_m", "sway_m", "heave_m", "roll_deg", "pitch_deg", "yaw_deg"};

namespace {

/// Bounds of one degree of freedom, in the unit of its column.
struct Bounds {
  double possible;      ///< Larger magnitudes are an error; checked before angles are made continuous.
  double usual;         ///< Larger magnitudes are a warning.
  double mean;          ///< Magnitude of the mean that gives a warning.
  double rate;          ///< Largest possible rate [1/s].
  double acceleration;  ///< Largest possible acceleration [1/s2].
};
constexpr std::array<Bounds, 6> kBounds = {{{1e4, 1e3, 10.0, 10.0, 9.81},
                                            {1e4, 1e3, 10.0, 10.0, 9.81},
                                            {50.0, 15.0, 1.0, 10.0, 9.81},
                                            {720.0, 45.0, 5.0, 40.0, 100.0},
                                            {720.0, 30.0, 5.0, 30.0, 100.0},
                                            {720.0, 1e9, 10.0, 15.0, 50.0}}};

bool is_angle(std::size_t freedom) {
  return freedom > 2;
}

const char* unit_name(std::size_t freedom) {
  return is_angle(freedom) ? "deg" : "m";
}

/// Returns the values of one degree of freedom in the unit of its column.
std::vector<double> column(const MotionHistory& history, std::size_t freedom) {
  std::vector<double> values(history.freedoms.size());
  std::transform(history.freedoms.begin(), history.freedoms.end(), values.begin(),
                 [&](const auto& row) { return is_angle(freedom) ? row[freedom] * kToDegrees : row[freedom]; });
  return values;
}

const char* sentinel_text(double value) {
  return is_sentinel(value) ? kMissingValueText : "";
}

std::string shown(double value, std::size_t freedom) {
  return fmt::format("{:.5g} {}", value, unit_name(freedom));
}

class RecordChecker {
 public:
  RecordChecker(const MotionRecord& record, double heading, Diagnostics& diagnostics)
      : record_(record), time_(record.history.time), heading_(heading), diagnostics_(diagnostics) {}

  void check() {
    check_time();
    for (std::size_t k = 0; k < kBounds.size(); ++k) {
      if (record_.given[k]) check_freedom(k);
    }
    check_angles();
    check_blank_rows();
  }

 private:
  void warn(std::size_t row, std::string remark, FindingCode code = FindingCode::unusual_input) {
    diagnostics_.add(
        {Severity::warning, record_.history.source, record_.lines[row], 0, "", std::move(remark), "", "", code});
  }

  void check_time() {
    const std::vector<double> steps = differences(time_);
    const double usual = median(steps);
    check_gap(steps, usual);
    const double long_step = quantile(steps, 0.95), short_step = quantile(steps, 0.05);
    if (long_step > 1.5 * short_step) {
      warn(0, fmt::format("the time step varies between {:.4g} s and {:.4g} s; the spline uses the rows as they are",
                          short_step, long_step));
    }
    if (usual > 5.0) {
      warn(0, fmt::format("rows {:.4g} s apart cannot resolve the motion in waves; is the time in s?", usual));
    }
  }

  /// Warns about gaps, over which the spline is not the vessel's motion.
  void check_gap(const std::vector<double>& steps, double usual) {
    constexpr double kGap = 3.0;  // usual steps
    const auto widest = static_cast<std::size_t>(std::max_element(steps.begin(), steps.end()) - steps.begin());
    if (steps[widest] < kGap * usual) return;
    const auto gaps = std::count_if(steps.begin(), steps.end(), [&](double step) { return step >= kGap * usual; });
    warn(widest,
         fmt::format("a gap of {:.4g} s after t = {:.6g} s, in rows {:.4g} s apart; the motion in it is a cubic "
                     "between its ends{}",
                     steps[widest], time_[widest], usual,
                     gaps > 1 ? fmt::format("; {} gaps in all", gaps) : std::string()));
  }

  void check_freedom(std::size_t freedom) {
    const std::vector<double> values = column(record_.history, freedom);
    check_size(freedom, values);
    check_mean(freedom, values);
    check_jumps(freedom, values);
    check_runs(freedom, values);
    check_resolution(freedom, values);
  }

  void check_size(std::size_t freedom, const std::vector<double>& values) {
    const std::size_t row = max_magnitude_row(values);
    if (std::abs(values[row]) <= kBounds[freedom].usual) return;
    warn(row, fmt::format("{} is {} at t = {:.6g} s{}; is the unit right?", kMotionColumns[freedom],
                          shown(values[row], freedom), time_[row], sentinel_text(values[row])));
  }

  void check_mean(std::size_t freedom, const std::vector<double>& values) {
    const double average = mean(values);
    const bool away = std::abs(average) > kBounds[freedom].mean;
    if (freedom == 5 && (away || record_.compass)) {
      warn(0, fmt::format("yaw_deg is {:.5g} deg on average{}", average, compass_text(average)),
           FindingCode::recorded_yaw_is_heading);
    } else if (away) {
      warn(0, fmt::format("the mean of {} is {}; a record describes the motion about the nominal position, so "
                          "the vessel has this offset throughout",
                          kMotionColumns[freedom], shown(average, freedom)));
    }
  }

  std::string compass_text(double average) const {
    constexpr double kNear = 15.0;
    const double heading = heading_ * kToDegrees;
    const bool near = std::abs(std::remainder(average - heading, 360.0)) < kNear;
    return fmt::format("{}: yaw is the deviation from vessel.heading ({:.4g} deg), positive with the bow to port{}",
                       record_.compass ? " and written from 0 to 360 deg as a compass heading is" : "", heading,
                       near ? "; it seems to be the compass heading itself" : "; is it a compass heading?");
  }

  /// Warns about jumps from one row to the next and accelerations that no vessel can have.
  void check_jumps(std::size_t freedom, const std::vector<double>& values) {
    const std::vector<RecordJump> leaps =
        find_jumps(time_, values, {kBounds[freedom].rate, kBounds[freedom].acceleration});
    if (leaps.empty()) return;
    const RecordJump& worst = worst_jump(leaps);
    const std::size_t row = worst.row;
    const double step = time_[row] - time_[row - 1], change = values[row] - values[row - 1];
    warn(row,
         fmt::format("{} jumps by {} in {:.4g} s, from {:.5g} to {:.5g} at t = {:.6g} s{}{}; the jump loads the "
                     "vessel and the pipe impulsively",
                     kMotionColumns[freedom], shown(change, freedom), step, values[row - 1], values[row], time_[row],
                     sentinel_text(is_sentinel(values[row - 1]) ? values[row - 1] : values[row]),
                     jump_text(worst, freedom, leaps.size())),
         FindingCode::recorded_motion_leaps);
  }

  /// Returns the largest jump; for a spike, the row that stands out, not the one after it.
  static const RecordJump& worst_jump(const std::vector<RecordJump>& leaps) {
    const auto worst = std::max_element(leaps.begin(), leaps.end(),
                                        [](const RecordJump& a, const RecordJump& b) { return a.rate < b.rate; });
    const bool spike =
        worst != leaps.begin() && (worst - 1)->row + 1 == worst->row && (worst - 1)->rate > 0.5 * worst->rate;
    return spike ? *(worst - 1) : *worst;
  }

  static std::string jump_text(const RecordJump& worst, std::size_t freedom, std::size_t count) {
    std::string text = fmt::format(", an acceleration of {:.3g} {}/s^2", worst.acceleration, unit_name(freedom));
    if (worst.of_usual > 2.0) text += fmt::format(" and {:.0f} times the usual step", worst.of_usual);
    return count > 1 ? text + fmt::format("; {} such rows", count) : text;
  }

  void check_runs(std::size_t freedom, const std::vector<double>& values) {
    if (check_stairs(freedom, values)) return;
    const std::optional<EqualRun> run = find_frozen_run(time_, values);
    if (!run) return;
    warn(run->first,
         fmt::format("{} stays at {} for {} rows, from t = {:.6g} s to {:.6g} s, while it varies before or "
                     "after{}; did the recorder stop?",
                     kMotionColumns[freedom], shown(values[run->first], freedom), run->last - run->first + 1,
                     time_[run->first], time_[run->last], sentinel_text(values[run->first])));
  }

  /// Warns about a channel sampled at a lower rate whose values are held: the spline would follow the steps.
  bool check_stairs(std::size_t freedom, const std::vector<double>& values) {
    constexpr double kShare = 0.45;  // of rows
    const double share = held_share(values);
    if (share < kShare || crossing_period(time_, values) <= 0.0) return false;
    warn(0, fmt::format("{} repeats the previous value in {:.0f} % of its rows: it was sampled more slowly than the "
                        "time column; remove the repeated rows",
                        kMotionColumns[freedom], 100.0 * share));
    return true;
  }

  void check_resolution(std::size_t freedom, const std::vector<double>& values) {
    constexpr double kFewest = 5.0;  // rows per period for a spline within a few per cent
    const double period = crossing_period(time_, values), rows = period / median(differences(time_));
    if (period <= 0.0 || rows >= kFewest || !finely_written(values)) return;
    warn(0, fmt::format("{} has only {:.2g} rows per mean period of {:.3g} s: peaks are cut off",
                        kMotionColumns[freedom], rows, period));
  }

  /// Warns about rows of zeros in every column, which recorders write for missing values.
  void check_blank_rows() {
    constexpr double kRare = 1e-6;
    const auto& rows = record_.history.freedoms;
    auto expected = static_cast<double>(rows.size());
    for (std::size_t k = 0; k < kBounds.size(); ++k) expected *= chance_of_zero(column(record_.history, k));
    if (expected > kRare) return;
    const auto blank = [](const auto& row) { return ranges::all_of(row, [](double x) { return x == 0.0; }); };
    const auto first = std::find_if(rows.begin() + 1, rows.end(), blank);
    if (first == rows.end() || blank(rows.front())) return;  // a record that begins at rest
    const auto row = static_cast<std::size_t>(first - rows.begin());
    const auto more = std::count_if(first + 1, rows.end(), blank);
    warn(row, fmt::format("all columns are 0 at t = {:.6g} s{}; did the recorder stop?", time_[row],
                          more > 0 ? fmt::format(" and in {} later rows", more) : std::string()));
  }

  /// Warns about angles that are probably in radians: a few hundredths while heave is significant.
  void check_angles() {
    constexpr double kSmall = 0.2, kWaveInfluenceDepths = 0.3;  // deg, m of heave's deviation
    double angle = 0.0;
    for (std::size_t k = 3; k < 5; ++k) angle = std::max(angle, deviation(column(record_.history, k)));
    const double heave = deviation(column(record_.history, 2));
    const double max_angle = std::max(max_abs_value(3), max_abs_value(4));
    if (angle == 0.0 || max_angle > kSmall || heave < kWaveInfluenceDepths) return;
    warn(0, fmt::format("roll and pitch stay below {:.2g} deg while heave has a standard deviation of {:.2g} m; are "
                        "they in radians?",
                        max_angle, heave));
  }

  double max_abs_value(std::size_t freedom) const {
    const std::vector<double> values = column(record_.history, freedom);
    return std::abs(values[max_magnitude_row(values)]);
  }

  const MotionRecord& record_;
  const std::vector<double>& time_;
  double heading_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_motion_values(const MotionRecord& record, Diagnostics& diagnostics) {
  for (std::size_t k = 0; k < kBounds.size(); ++k) {
    const std::vector<double> values = column(record.history, k);
    const std::size_t row = max_magnitude_row(values);
    const double value = values[row];
    if (std::abs(value) <= kBounds[k].possible) continue;
    diagnostics.add(
        {Severity::error, record.history.source, record.lines[row], 0, "",
         fmt::format("{} of {} at t = {:.6g} s{}", kMotionColumns[k], shown(value, k), record.history.time[row],
                     sentinel_text(value)),
         fmt::format("a motion about the vessel's nominal position, below {:g} {}", kBounds[k].possible, unit_name(k)),
         is_sentinel(value) ? "remove such rows, or interpolate between their neighbours" : ""});
  }
}

void unwrap_angles(MotionRecord& record) {
  MotionHistory& history = record.history;
  const std::vector<double> yaw = column(history, 5);
  const auto [lowest, highest] = std::minmax_element(yaw.begin(), yaw.end());
  record.compass = *lowest >= 0.0 && *highest > 180.0;
  for (std::size_t k = 3; k < 6; ++k) {
    double turns = 0.0, sum = 0.0, before = history.freedoms.front()[k];
    for (auto& row : history.freedoms) {
      const double passed = std::round((before - row[k]) / kTurn);
      history.passages += passed != 0.0 ? 1 : 0;
      turns += passed;
      before = row[k];
      row[k] += kTurn * turns;
      sum += row[k];
    }
    const double mean_turns = std::round(sum / static_cast<double>(history.freedoms.size()) / kTurn);
    for (auto& row : history.freedoms) row[k] -= kTurn * mean_turns;
  }
}

void check_motion_record(const MotionRecord& record, double heading, Diagnostics& diagnostics) {
  RecordChecker(record, heading, diagnostics).check();
}

}  // namespace overbend
