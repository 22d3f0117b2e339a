#include "mechanics/winch.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Number of pieces of a ramp: the cubic through them matches its rate within a thousandth.
constexpr int kRampRows = 4;

void add_row(LengthTable& table, double time, double length, double rate) {
  table.times.push_back(time);
  table.lengths.push_back(length);
  table.rates.push_back(rate);
}

/// Length and rate of a ramp up to rate 1 within `ramp`, at a fraction of it: the rate is smooth at both ends.
PaidOut on_ramp(double share, double ramp) {
  const double x2 = share * share;
  return {ramp * x2 * share * (1.0 - 0.5 * share), x2 * (3.0 - 2.0 * share)};
}

}  // namespace

PaidOut LengthTable::at(double time) const {
  if (times.empty()) return {};
  if (time <= times.front()) return {lengths.front(), 0.0};
  if (time >= times.back()) return {lengths.back(), 0.0};
  const auto above = std::upper_bound(times.begin(), times.end(), time);
  const std::size_t i = static_cast<std::size_t>(above - times.begin()) - 1;
  const double h = times[i + 1] - times[i], x = (time - times[i]) / h;
  const double rise = lengths[i + 1] - lengths[i], first = h * rates[i], last = h * rates[i + 1];
  const double square = 3.0 * rise - 2.0 * first - last, cube = first + last - 2.0 * rise;
  return {lengths[i] + x * (first + x * (square + x * cube)), (first + x * (2.0 * square + 3.0 * x * cube)) / h};
}

LengthTable smooth_table(std::vector<double> times, std::vector<double> lengths) {
  LengthTable table{std::move(times), std::move(lengths), {}};
  const std::size_t rows = table.times.size();
  table.rates.assign(rows, 0.0);
  const auto slope = [&](std::size_t i) {
    return (table.lengths[i + 1] - table.lengths[i]) / (table.times[i + 1] - table.times[i]);
  };
  for (std::size_t i = 1; i + 1 < rows; ++i) {
    const double before = slope(i - 1), after = slope(i);
    if (before * after <= 0.0) continue;
    const double h0 = table.times[i] - table.times[i - 1], h1 = table.times[i + 1] - table.times[i];
    const double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
    table.rates[i] = (w0 + w1) / (w0 / before + w1 / after);
  }
  return table;
}

double add_move(LengthTable& table, double start, double change, double speed, double ramp) {
  const double from = table.empty() ? 0.0 : table.lengths.back();
  const double began = table.empty() ? start : std::max(start, table.times.back());
  if (change == 0.0 || speed <= 0.0) return began;
  const double sign = change > 0.0 ? 1.0 : -1.0, way = std::abs(change);
  const double even = std::max(way / speed - ramp, 0.0);  // time at full speed: both ramps together cover speed * ramp
  const double full = sign * way / (even + ramp);
  if (table.empty() || began > table.times.back()) add_row(table, began, from, 0.0);
  for (int i = 1; i <= kRampRows; ++i) {
    const PaidOut ramp_point = on_ramp(static_cast<double>(i) / kRampRows, ramp);
    add_row(table, began + ramp * i / kRampRows, from + full * ramp_point.length, full * ramp_point.rate);
  }
  const double done = began + even + 2.0 * ramp;
  for (int i = even > 0.0 ? kRampRows : kRampRows - 1; i >= 0; --i) {
    const PaidOut ramp_point = on_ramp(static_cast<double>(i) / kRampRows, ramp);
    add_row(table, done - ramp * i / kRampRows, from + change - full * ramp_point.length, full * ramp_point.rate);
  }
  return done;
}

}  // namespace overbend
