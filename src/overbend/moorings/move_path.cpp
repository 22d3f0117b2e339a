#include "moorings/move_path.h"

#include <algorithm>
#include <cmath>

#include "base/require.h"

namespace overbend {
namespace {

/// Interval of table rows; the kinks of a profile are rows as well [s].
constexpr double kRowStep = 1.0;

/// Derivative at an equally spaced row: central difference; at the ends that of a parabola.
double slope_at(const LengthsByDistance& by, std::size_t line, std::size_t row) {
  const std::size_t last = by.distances.size() - 1;
  const auto length = [&](std::size_t i) { return by.lengths[i][line]; };
  if (last == 1) return (length(1) - length(0)) / (by.distances[1] - by.distances[0]);
  if (row == 0) return (4.0 * length(1) - 3.0 * length(0) - length(2)) / (by.distances[2] - by.distances[0]);
  if (row == last) {
    return (3.0 * length(last) - 4.0 * length(last - 1) + length(last - 2)) /
           (by.distances[last] - by.distances[last - 2]);
  }
  return (length(row + 1) - length(row - 1)) / (by.distances[row + 1] - by.distances[row - 1]);
}

/// Times of one move after its start: equally spaced, and at jumps of the acceleration.
std::vector<double> move_times(const MoveProfile& profile) {
  const double duration = profile.duration();
  std::vector<double> times;
  const int rows = std::max(2, static_cast<int>(std::ceil(duration / kRowStep)));
  for (int i = 1; i < rows; ++i) times.push_back(duration * i / rows);
  const double half = profile.shape == MoveShape::zero_vibration ? 0.5 * profile.period : 0.0;
  for (const double kink : {half, profile.ramp, profile.ramp + half}) {
    for (const double instant : {kink, duration - kink}) {
      if (instant > 0.0 && instant < duration) times.push_back(instant);
    }
  }
  times.push_back(duration);
  std::sort(times.begin(), times.end());
  const auto same = [](double a, double b) { return b - a < 1e-3; };
  times.erase(std::unique(times.begin(), times.end(), same), times.end());
  times.back() = duration;
  return times;
}

}  // namespace

void LengthsByDistance::add(double distance, const MooringSpread& spread) {
  distances.push_back(distance);
  std::vector<double>& row = lengths.emplace_back();
  for (const MooredLine& line : spread.lines) row.push_back(line.line.first_segment());
}

LengthsByDistance::Length LengthsByDistance::at(std::size_t line, double at_way) const {
  require(distances.size() >= 2, "a path has at least two positions");
  const double step = distances[1] - distances[0], place = (at_way - distances.front()) / step;
  const double last = static_cast<double>(distances.size() - 2);
  const std::size_t i = static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, last));
  const double x = std::clamp(place - static_cast<double>(i), 0.0, 1.0);
  const double from = lengths[i][line], rise = lengths[i + 1][line] - from;
  const double first = step * slope_at(*this, line, i), end = step * slope_at(*this, line, i + 1);
  const double square = 3.0 * rise - 2.0 * first - end, cube = first + end - 2.0 * rise;
  return {from + x * (first + x * (square + x * cube)), (first + x * (2.0 * square + 3.0 * x * cube)) / step};
}

HullOffset offset_ahead(const HullOffset& from, double distance) {
  HullOffset offset = from;
  offset[0] += distance;
  return offset;
}

std::vector<double> move_positions(const MoveProfile& profile) {
  std::vector<double> places;
  const int count = profile.moves * kPositionsPerMove;
  for (int i = 0; i <= count; ++i) places.push_back(profile.distance * i / kPositionsPerMove);
  return places;
}

std::vector<LengthTable> winch_tables(const LengthsByDistance& lengths, const MoveProfile& profile) {
  const std::vector<double> instants = move_times(profile);
  std::vector<LengthTable> tables(lengths.lengths.front().size());
  for (std::size_t line = 0; line < tables.size(); ++line) {
    LengthTable& table = tables[line];
    const auto add = [&](double time) {
      const MoveState point = profile.at(time);
      const LengthsByDistance::Length length = lengths.at(line, point.distance);
      table.times.push_back(time);
      table.lengths.push_back(length.length);
      table.rates.push_back(length.slope * point.speed);
    };
    for (int move = 0; move < profile.moves; ++move) {
      const double begin = profile.start + move * (profile.duration() + profile.wait);
      if (move == 0 || profile.wait > 0.0) add(begin);
      for (const double instant : instants) add(begin + instant);
      table.rates.back() = 0.0;
    }
  }
  return tables;
}

}  // namespace overbend
