#include "numerics/root_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace overbend {
namespace {

constexpr double kJump = 0.02;      // fraction of the difference over the first bracket that remains when it is closed
constexpr double kReversal = 1e-3;  // reversal allowed for a monotone function, as a fraction of the range of values
constexpr int kMaxSteps = 100;
constexpr int kTurnSteps = 12;
constexpr double kProbe = 0.02;  // fraction of the distance from an end of the interval to the next point

bool opposed(double a, double b) {
  return (a <= 0.0) != (b <= 0.0);
}

class Scan {
 public:
  Scan(const ScannedFunction& f, double from, double to, const ScanSettings& settings)
      : f_(f), width_(to - from), settings_(settings) {
    for (int i = 0; i < settings.points; ++i) at(from + width_ * i / (settings.points - 1));
    for (const ScannedPoint& point : points_) {
      if (point.value) max_magnitude_ = std::max(max_magnitude_, std::abs(*point.value));
    }
  }

  RootScan run() {
    look_at_turns();
    look_at_ends();
    const std::vector<ScannedPoint> grid = sorted();
    RootScan scan;
    const ScannedPoint* before = nullptr;
    for (const ScannedPoint& point : grid) {
      // A gap in the function separates the two sides.
      if (point.value && before != nullptr && before->value && opposed(*before->value, *point.value)) {
        if (auto crossing = close({before->x, point.x, *before->value, *point.value})) {
          scan.crossings.push_back(*crossing);
        }
      }
      before = &point;
    }
    scan.points = sorted();
    return scan;
  }

 private:
  std::optional<double> at(double x) {
    points_.push_back({x, f_(x)});
    return points_.back().value;
  }

  std::vector<ScannedPoint> sorted() const {
    std::vector<ScannedPoint> points = points_;
    std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    return points;
  }

  /// Three values of one sign, the middle one nearest to zero, may enclose two roots or one of even order.
  void look_at_turns() {
    const std::vector<ScannedPoint> grid = sorted();
    for (std::size_t i = 1; i + 1 < grid.size(); ++i) {
      const auto &a = grid[i - 1].value, &b = grid[i].value, &c = grid[i + 1].value;
      if (!a || !b || !c || opposed(*a, *b) || opposed(*b, *c)) continue;
      if (std::abs(*b) >= std::abs(*a) || std::abs(*b) >= std::abs(*c)) continue;
      const double bend = *a - 2.0 * *b + *c, slope = 0.5 * (*c - *a);
      // vertex of the parabola through the points
      const double vertex = bend == 0.0 ? *b : *b - 0.5 * slope * slope / bend;
      if (opposed(vertex, *b) || std::abs(vertex) < 0.1 * std::abs(*b)) follow_turn(grid[i - 1].x, grid[i + 1].x, *b);
    }
  }

  /// If values move away from zero between an end of the interval and the next point, but towards zero at first, there
  /// is a turning point between them.
  void look_at_ends() {
    const int last = settings_.points - 1;
    const std::vector<ScannedPoint> grid(points_.begin(), points_.begin() + settings_.points);
    for (const auto& [end, next] : {std::pair(0, 1), std::pair(last, last - 1)}) {
      const ScannedPoint &from = grid[static_cast<std::size_t>(end)], &to = grid[static_cast<std::size_t>(next)];
      if (!from.value || !to.value || opposed(*from.value, *to.value)) continue;
      if (std::abs(*to.value) < std::abs(*from.value) || *from.value == 0.0) continue;
      const std::optional<double> near = at(from.x + kProbe * (to.x - from.x));
      if (!near || opposed(*near, *from.value) || std::abs(*near) >= std::abs(*from.value)) continue;
      follow_turn(std::min(from.x, to.x), std::max(from.x, to.x), *from.value);
    }
  }

  /// Golden section towards the value nearest to zero, until the sign changes.
  void follow_turn(double low, double high, double value) {
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    double inner = high - golden * (high - low), outer = low + golden * (high - low);
    std::optional<double> at_inner = at(inner), at_outer = at(outer);
    for (int i = 0; i < kTurnSteps && at_inner && at_outer; ++i) {
      if (opposed(*at_inner, value) || opposed(*at_outer, value)) return;
      if (std::abs(*at_inner) < std::abs(*at_outer)) {
        high = std::exchange(outer, inner);
        at_outer = std::exchange(at_inner, std::nullopt);
        inner = high - golden * (high - low);
        at_inner = at(inner);
      } else {
        low = std::exchange(inner, outer);
        at_inner = std::exchange(at_outer, std::nullopt);
        outer = low + golden * (high - low);
        at_outer = at(outer);
      }
    }
  }

  /// Brent's method: b is the best argument, a the previous one, c such that b and c enclose the crossing. Returns
  /// nothing if the function cannot be evaluated at some point.
  std::optional<Crossing> close(const Crossing& bracket) {
    double a = bracket.low, fa = bracket.at_low, b = bracket.high, fb = bracket.at_high;
    double c = a, fc = fa, step = b - a, before = step;
    for (int i = 0; i < kMaxSteps; ++i) {
      if (!opposed(fb, fc)) {
        c = a;
        fc = fa;
        before = step = b - a;
      }
      if (std::abs(fc) < std::abs(fb)) {
        a = std::exchange(b, c);
        c = a;
        fa = std::exchange(fb, fc);
        fc = fa;
      }
      const double tolerance = 0.5 * settings_.resolution * width_, half = 0.5 * (c - b);
      if (std::abs(half) <= tolerance || std::abs(fb) <= settings_.negligible * max_magnitude_) break;
      const double next =
          std::abs(before) >= tolerance && std::abs(fa) > std::abs(fb) ? interpolated(a, b, c, fa, fb, fc) : half;
      // Brent's bounds on the step; otherwise bisection.
      const bool good = std::abs(next) < std::min(1.5 * std::abs(half) - 0.5 * tolerance, 0.5 * std::abs(before)) &&
                        next * half > 0.0;
      before = good ? step : half;
      step = good ? next : half;
      a = b;
      fa = fb;
      b += std::abs(step) > tolerance ? step : std::copysign(tolerance, half);
      const std::optional<double> value = at(b);
      if (!value) return std::nullopt;
      fb = *value;
    }
    if (settings_.both_ends) draw_in(b, fb, c, fc);
    return make_crossing(bracket, b, fb, c, fc);
  }

  /// Moves the far end of a bracket whose near end is already zero: to the closest point with the other sign.
  void draw_in(double b, double fb, double& c, double& fc) {
    constexpr double kLonger = 4.0;
    double step = std::copysign(settings_.resolution * width_, c - b);
    for (; std::abs(step) < std::abs(c - b); step *= kLonger) {
      const std::optional<double> value = at(b + step);
      if (!value) return;
      if (opposed(*value, fb)) {
        c = b + step;
        fc = *value;
        return;
      }
    }
  }

  static double interpolated(double a, double b, double c, double fa, double fb, double fc) {
    const double s = fb / fa;
    if (a == c) return (c - b) * s / (s - 1.0);  // secant
    const double q = fa / fc, r = fb / fc;
    const double p = s * ((c - b) * q * (q - r) - (b - a) * (r - 1.0));
    return -p / ((q - 1.0) * (r - 1.0) * (s - 1.0));
  }

  Crossing make_crossing(const Crossing& bracket, double b, double fb, double c, double fc) const {
    Crossing crossing = b < c ? Crossing{b, c, fb, fc} : Crossing{c, b, fc, fb};
    // A value that is already zero is a root, regardless of the width of its bracket.
    crossing.jump = std::abs(fb) > settings_.negligible * max_magnitude_ &&
                    std::abs(crossing.at_high - crossing.at_low) > kJump * std::abs(bracket.at_high - bracket.at_low);
    return crossing;
  }

  const ScannedFunction& f_;
  double width_;
  ScanSettings settings_;
  std::vector<ScannedPoint> points_;
  double max_magnitude_ = 0.0;
};

}  // namespace

RootScan scan_roots(const ScannedFunction& f, double from, double to, const ScanSettings& settings) {
  return Scan(f, from, to, settings).run();
}

bool is_monotone(const RootScan& scan) {
  double min_value = std::numeric_limits<double>::infinity(), max_value = -min_value;
  for (const ScannedPoint& point : scan.points) {
    min_value = std::min(min_value, point.value.value_or(min_value));
    max_value = std::max(max_value, point.value.value_or(max_value));
  }
  bool rises = true, falls = true;
  std::optional<double> before;
  for (const ScannedPoint& point : scan.points) {
    if (!point.value) continue;
    rises = rises && (!before || *point.value >= *before - kReversal * (max_value - min_value));
    falls = falls && (!before || *point.value <= *before + kReversal * (max_value - min_value));
    before = point.value;
  }
  return rises || falls;
}

}  // namespace overbend
