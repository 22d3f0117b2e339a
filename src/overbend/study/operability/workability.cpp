#include "study/operability/workability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "base/ranges.h"

namespace overbend {
namespace {

constexpr const char* kHeight = "environment.waves.hs";
constexpr const char* kPeriod = "environment.waves.tp";
constexpr const char* kFrom = "environment.waves.from";
constexpr std::array<double, 12> kDays = {31, 28.25, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
constexpr double kSlack = 1e-9;  ///< Relative tolerance of periods on the edge of the chart [-].

/// Maximum workable height of a sea [m]; `open_above`: heights above it were not tried.
struct Limit {
  double height = 0.0;
  bool open_above = false;
};

/// Position of a period between two values of the axis.
struct PeriodPosition {
  std::size_t low = 0, high = 0;
  double part = 0.0;  ///< Fraction of the interval from low to high [-].
};

class Chart {
 public:
  Chart(const OperabilityResults& results, double factor) : results_(results), factor_(factor) {
    stride_.assign(results.axes.size(), 1);
    for (std::size_t i = results.axes.size(); i-- > 1;) {
      stride_[i - 1] = stride_[i] * results.axes[i].values.size();
    }
    for (std::size_t i = 0; i < results.axes.size(); ++i) {
      if (results.axes[i].key == kPeriod) period_ = i;
      if (results.axes[i].key == kFrom) from_ = i;
    }
  }

  std::string find_error() const {
    if (results_.over != kHeight) return "workability needs a limit of " + std::string(kHeight);
    for (const StudyInput& axis : results_.axes) {
      if (axis.key != kPeriod && axis.key != kFrom) return "workability cannot use the axis " + axis.key;
      if (axis.values.empty()) return "the axis " + axis.key + " has no numbers";
    }
    return "";
  }

  /// Returns the limit of a sea; empty outside the chart.
  std::optional<Limit> limit(const ScatterDiagram::Sea& sea) const {
    const std::optional<PeriodPosition> between =
        period_ ? place(results_.axes[*period_].values, sea.tp) : PeriodPosition{};
    if (!between) return std::nullopt;
    if (!from_) return at(0, *between);
    const std::vector<double>& headings = results_.axes[*from_].values;
    if (sea.from) return at(nearest(headings, *sea.from), *between);
    std::optional<Limit> lowest = at(0, *between);
    for (std::size_t i = 1; i < headings.size() && lowest; ++i) {
      const std::optional<Limit> candidate = at(i, *between);
      if (!candidate || candidate->height < lowest->height) lowest = candidate;
    }
    return lowest;
  }

 private:
  static std::optional<PeriodPosition> place(const std::vector<double>& values, double wanted) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
    const double slack = kSlack * std::abs(wanted);
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (std::abs(values[order[i]] - wanted) <= slack) return PeriodPosition{order[i], order[i], 0.0};
      if (i == 0 || wanted < values[order[i - 1]] || wanted > values[order[i]]) continue;
      const double low = values[order[i - 1]], high = values[order[i]];
      return PeriodPosition{order[i - 1], order[i], (wanted - low) / (high - low)};
    }
    return std::nullopt;
  }

  static std::size_t nearest(const std::vector<double>& headings, double from) {
    const auto apart = [&](double heading) { return std::abs(std::remainder(heading - from, 2.0 * std::numbers::pi)); };
    return static_cast<std::size_t>(ranges::min_element(headings, {}, apart) - headings.begin());
  }

  std::optional<Limit> at(std::size_t heading, const PeriodPosition& between) const {
    const std::size_t row = from_ ? heading * stride_[*from_] : 0;
    const std::size_t step = period_ ? stride_[*period_] : 0;
    const OperabilityCell &low = results_.cells.at(row + between.low * step),
                          &high = results_.cells.at(row + between.high * step);
    if (!low.decided || !high.decided) return std::nullopt;
    const double height = std::lerp(low.limit.value_or(0.0), high.limit.value_or(0.0), between.part);
    return Limit{factor_ * height, low.beyond && high.beyond};
  }

  const OperabilityResults& results_;
  double factor_;
  std::vector<std::size_t> stride_;
  std::optional<std::size_t> period_, from_;
};

/// Mean over the year, with months weighted by their days.
double over_year(const std::vector<double>& months) {
  if (months.size() != kDays.size()) return months.empty() ? 0.0 : months.front();
  double sum = 0.0, days = 0.0;
  for (std::size_t i = 0; i < kDays.size(); ++i) {
    sum += kDays[i] * months[i];
    days += kDays[i];
  }
  return sum / days;
}

}  // namespace

std::variant<Workability, std::string> workability(const ScatterDiagram& diagram, const OperabilityResults& chart,
                                                   double factor) {
  const Chart limits(chart, factor);
  if (const std::string error = limits.find_error(); !error.empty()) return error;
  const std::size_t months = diagram.seas.empty() ? 0 : diagram.seas.front().fraction.size();
  Workability result;
  result.months.assign(months, 0.0);
  std::vector<double> outside(months, 1.0);
  for (const ScatterDiagram::Sea& sea : diagram.seas) {
    const std::optional<Limit> limit = limits.limit(sea);
    if (!limit) continue;
    const double lowest = std::max(0.0, sea.hs - 0.5 * sea.hs_width), highest = sea.hs + 0.5 * sea.hs_width;
    const double below = std::clamp((limit->height - lowest) / (highest - lowest), 0.0, 1.0);
    for (std::size_t i = 0; i < months; ++i) {
      result.months[i] += below * sea.fraction[i];
      outside[i] -= (limit->open_above ? below : 1.0) * sea.fraction[i];
    }
  }
  for (double& part : outside) part = std::max(0.0, part);
  result.year = over_year(result.months);
  result.outside = over_year(outside);
  return result;
}

}  // namespace overbend
