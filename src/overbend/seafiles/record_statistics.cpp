#include "seafiles/record_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/constants.h"

namespace overbend {
namespace {

constexpr double kNormalPeak = 0.4;  // density of the normal distribution at its mean

/// Returns the smallest non-zero step, the resolution of the record; 0 if all values are equal.
double resolution(const std::vector<double>& steps) {
  double min_change = 0.0;
  for (const double step : steps) {
    const double size = std::abs(step);
    if (size > 0.0 && (min_change == 0.0 || size < min_change)) min_change = size;
  }
  return min_change;
}

/// Returns the magnitudes of the rates between rows.
std::vector<double> rates_between(const std::vector<double>& time, const std::vector<double>& values) {
  std::vector<double> rates(values.size() - 1);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    rates[i] = std::abs(values[i + 1] - values[i]) / (time[i + 1] - time[i]);
  }
  return rates;
}

/// Returns the upper quartile of the rates around step `i`, without step `i`.
double rate_around(const std::vector<double>& rates, std::size_t i) {
  constexpr std::size_t kReach = 10;
  const std::size_t from = i > kReach ? i - kReach : 0, to = std::min(rates.size(), i + kReach + 1);
  std::vector<double> around;
  for (std::size_t k = from; k < to; ++k) {
    if (k != i) around.push_back(rates[k]);
  }
  return quantile(std::move(around), 0.75);
}

/// Returns the magnitude of the acceleration at the start of step `i`.
double acceleration_before(const std::vector<double>& time, const std::vector<double>& values, std::size_t i) {
  if (i == 0) return 0.0;
  const double before = time[i] - time[i - 1], after = time[i + 1] - time[i];
  const double change = (values[i + 1] - values[i]) / after - (values[i] - values[i - 1]) / before;
  return std::abs(change) / (0.5 * (before + after));
}

/// Estimates whether a run of equal values with resolution q can be motion: during its duration T, the speed must be
/// below q / T and the acceleration below 8 q / T^2.
struct RunProbability {
  const std::vector<double>& time;
  std::vector<double> rates;
  double digit, period;

  double lasts(const EqualRun& run) const { return time[run.last] - time[run.first]; }

  /// Returns the upper quartile of the rates within half a period before and after the run.
  double neighbouring_rate(const EqualRun& run) const {
    const double reach = std::max(0.5 * period, 2.0 * lasts(run) / static_cast<double>(run.last - run.first));
    std::vector<double> neighbours;
    for (std::size_t k = run.first; k-- > 0 && time[run.first] - time[k] <= reach;) neighbours.push_back(rates[k]);
    for (std::size_t k = run.last; k < rates.size() && time[k] - time[run.last] <= reach; ++k) {
      neighbours.push_back(rates[k]);
    }
    return quantile(std::move(neighbours), 0.75);
  }

  /// Returns the expected number of such runs in a Gaussian motion with the rates of the neighbouring rows.
  double expected(const EqualRun& run) const {
    const double duration = lasts(run), speed = neighbouring_rate(run), acceleration = speed * kTurn / period;
    if (!(speed > 0.0)) return kInfinity;
    const double slow = std::min(1.0, kNormalPeak * digit / (duration * speed));
    const double straight = std::min(1.0, 8.0 * kNormalPeak * digit / (duration * duration * acceleration));
    return slow * straight * (time.back() - time.front()) / duration;
  }
};

}  // namespace

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
  const double average = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - average) * (value - average);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double median(const std::vector<double>& values) {
  return quantile(values, 0.5);
}

std::vector<double> differences(const std::vector<double>& values) {
  std::vector<double> steps(values.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = values[i + 1] - values[i];
  return steps;
}

std::size_t max_magnitude_row(const std::vector<double>& values) {
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end(), smaller) - values.begin());
}

bool finely_written(const std::vector<double>& values) {
  constexpr double kFine = 20.0;
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  return *highest > *lowest && *highest - *lowest >= kFine * resolution(differences(values));
}

double crossing_period(const std::vector<double>& time, const std::vector<double>& values) {
  const double level = median(values);
  std::size_t first = 0, last = 0;
  int crossings = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i - 1] >= level || values[i] < level) continue;
    if (crossings++ == 0) first = i;
    last = i;
  }
  return crossings < 2 ? 0.0 : (time[last] - time[first]) / (crossings - 1);
}

std::vector<RecordJump> find_jumps(const std::vector<double>& time, const std::vector<double>& values,
                                   RateBounds bounds) {
  // In a Gaussian motion over a day, the largest step is about 8 times the median. In a growing motion it is larger,
  // but then the steps around it are as large.
  constexpr double kOfUsual = 12.0, kOfAround = 6.0;
  constexpr std::size_t kFewest = 12;
  const std::vector<double> rates = rates_between(time, values);
  std::vector<double> moving;
  std::copy_if(rates.begin(), rates.end(), std::back_inserter(moving), [](double rate) { return rate > 0.0; });
  const double usual = median(moving);
  std::vector<RecordJump> leaps;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const double acceleration = acceleration_before(time, values, i);
    const bool beyond = rates[i] > bounds.rate || acceleration > bounds.acceleration;
    const bool apart = rates.size() >= kFewest && rates[i] > kOfUsual * usual &&
                       rates[i] > kOfAround * std::max(usual, rate_around(rates, i));
    if (beyond || apart) leaps.push_back({i + 1, rates[i], acceleration, usual > 0.0 ? rates[i] / usual : 0.0});
  }
  return leaps;
}

double held_share(const std::vector<double>& values) {
  constexpr double kLarge = 5.0;  // multiples of the resolution; smaller steps belong to a slow motion
  const std::vector<double> steps = differences(values);
  std::vector<double> moving;
  for (const double step : steps) {
    if (step != 0.0) moving.push_back(std::abs(step));
  }
  const auto held = static_cast<double>(steps.size() - moving.size()) / static_cast<double>(steps.size());
  return median(moving) > kLarge * resolution(steps) ? held : 0.0;
}

double chance_of_zero(const std::vector<double>& values) {
  const double size = deviation(values);
  return size > 0.0 ? std::min(1.0, kNormalPeak * resolution(differences(values)) / size) : 1.0;
}

std::optional<EqualRun> find_frozen_run(const std::vector<double>& time, const std::vector<double>& values) {
  constexpr double kRare = 1e-3, kPeriods = 2.0;
  const double period = crossing_period(time, values);
  if (period <= 0.0) return std::nullopt;
  const RunProbability judge{time, rates_between(time, values), resolution(differences(values)), period};
  const bool fine = finely_written(values);
  std::optional<EqualRun> frozen;
  for (std::size_t first = 0, i = 1; i <= values.size(); ++i) {
    if (i < values.size() && values[i] == values[first]) continue;
    const EqualRun run{first, i - 1};
    first = i;
    const double lasts = judge.lasts(run);
    if (run.last - run.first < 2 || (frozen && lasts <= judge.lasts(*frozen))) continue;
    if (judge.expected(run) < kRare || (fine && lasts >= kPeriods * period)) frozen = run;
  }
  return frozen;
}

}  // namespace overbend
