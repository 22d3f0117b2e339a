#include "moorings/move_path.h"

#include <algorithm>
#include <cmath>

#include "base/require.h"

namespace overbend {
namespace {

/// Between rows of a table in time; a profile's kinks are rows too [s].
constexpr double kRowStep = 1.0;

/// Slope at a row of even spacing: central; at the ends of a parabola.
double slope_at(const LengthsByWay& by, std::size_t line, std::size_t row) {
  const std::size_t last = by.way.size() - 1;
  const auto length = [&](std::size_t i) { return by.lengths[i][line]; };
  if (last == 1) return (length(1) - length(0)) / (by.way[1] - by.way[0]);
  if (row == 0) return (4.0 * length(1) - 3.0 * length(0) - length(2)) / (by.way[2] - by.way[0]);
  if (row == last) {
    return (3.0 * length(last) - 4.0 * length(last - 1) + length(last - 2)) / (by.way[last] - by.way[last - 2]);
  }
  return (length(row + 1) - length(row - 1)) / (by.way[row + 1] - by.way[row - 1]);
}

/// Instants of one move after its beginning: even, and where the acceleration jumps.
std::vector<double> instants_of(const MoveProfile& profile) {
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

void LengthsByWay::add(double at, const MooringSpread& spread) {
  way.push_back(at);
  std::vector<double>& here = lengths.emplace_back();
  for (const MooredLine& line : spread.lines) here.push_back(line.line.first_segment());
}

LengthsByWay::Length LengthsByWay::at(std::size_t line, double at_way) const {
  require(way.size() >= 2, "a way has two places");
  const double step = way[1] - way[0], place = (at_way - way.front()) / step;
  const double last = static_cast<double>(way.size() - 2);
  const std::size_t i = static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, last));
  const double x = std::clamp(place - static_cast<double>(i), 0.0, 1.0);
  const double from = lengths[i][line], rise = lengths[i + 1][line] - from;
  const double first = step * slope_at(*this, line, i), end = step * slope_at(*this, line, i + 1);
  const double square = 3.0 * rise - 2.0 * first - end, cube = first + end - 2.0 * rise;
  return {from + x * (first + x * (square + x * cube)), (first + x * (2.0 * square + 3.0 * x * cube)) / step};
}

HullOffset offset_ahead(const HullOffset& from, double way) {
  HullOffset there = from;
  there[0] += way;
  return there;
}

std::vector<double> places_of(const MoveProfile& profile) {
  std::vector<double> places;
  const int count = profile.moves * kPlacesOfMove;
  for (int i = 0; i <= count; ++i) places.push_back(profile.distance * i / kPlacesOfMove);
  return places;
}

std::vector<LengthTable> winch_tables(const LengthsByWay& lengths, const MoveProfile& profile) {
  const std::vector<double> instants = instants_of(profile);
  std::vector<LengthTable> tables(lengths.lengths.front().size());
  for (std::size_t line = 0; line < tables.size(); ++line) {
    LengthTable& table = tables[line];
    const auto add = [&](double time) {
      const WayPoint at = profile.at(time);
      const LengthsByWay::Length here = lengths.at(line, at.way);
      table.times.push_back(time);
      table.lengths.push_back(here.length);
      table.rates.push_back(here.slope * at.speed);
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
