#include "mechanics/move_profile.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Largest speed of a minimum-jerk way of length and time 1 (Flash & Hogan 1985).
constexpr double kPeakSpeed = 1.875;

/// Speed that rises and falls linearly; where the way is too short for the whole speed, by the same acceleration.
struct Trapezoid {
  double speed = 0.0, ramp = 0.0, duration = 0.0;

  Trapezoid(double distance, double largest, double ramp_time) {
    speed = largest;
    ramp = ramp_time;
    if (distance < largest * ramp_time) {
      const double share = std::sqrt(distance / (largest * ramp_time));
      speed *= share;
      ramp *= share;
    }
    duration = distance / speed + ramp;
  }
  WayPoint at(double t) const {
    const auto from_rest = [&](double s) {
      return ramp > 0.0 && s < ramp ? WayPoint{0.5 * speed / ramp * s * s, speed / ramp * s, speed / ramp}
                                    : WayPoint{speed * (s - 0.5 * ramp), speed, 0.0};
    };
    if (t <= 0.0) return {};
    const double left = duration - t, whole = speed * (duration - ramp);
    if (left <= 0.0) return {whole, 0.0, 0.0};
    if (left >= t) return from_rest(t);
    const WayPoint back = from_rest(left);
    return {whole - back.way, back.speed, -back.acceleration};
  }
};

WayPoint minimum_jerk(double distance, double duration, double time) {
  const double u = std::clamp(time / duration, 0.0, 1.0), v = 1.0 - u;
  return {distance * u * u * u * (10.0 + u * (6.0 * u - 15.0)), 30.0 * distance / duration * u * u * v * v,
          60.0 * distance / (duration * duration) * u * v * (v - u)};
}

/// One move of a length above 0 from t = 0.
WayPoint one_move(const MoveProfile& p, double distance, double t) {
  if (p.shape == MoveShape::minimum_jerk) return minimum_jerk(distance, p.duration(), t);
  const Trapezoid trapezoid(distance, p.speed, p.ramp);
  const WayPoint first = trapezoid.at(t);
  if (p.shape == MoveShape::trapezoid) return first;
  const WayPoint second = trapezoid.at(t - 0.5 * p.period);
  return {0.5 * (first.way + second.way), 0.5 * (first.speed + second.speed),
          0.5 * (first.acceleration + second.acceleration)};
}

}  // namespace

double MoveProfile::duration() const {
  const double length = std::abs(distance);
  if (length == 0.0) return 0.0;
  if (shape == MoveShape::minimum_jerk) return kPeakSpeed * length / speed;
  const double whole = Trapezoid(length, speed, ramp).duration;
  return shape == MoveShape::zero_vibration ? whole + 0.5 * period : whole;
}

WayPoint MoveProfile::at(double time) const {
  const double length = std::abs(distance), sign = distance < 0.0 ? -1.0 : 1.0;
  if (length == 0.0 || time <= start) return {};
  const double cycle = duration() + wait;
  const int done = std::min(static_cast<int>((time - start) / cycle), moves - 1);
  WayPoint at = one_move(*this, length, time - start - done * cycle);
  at.way = sign * (at.way + done * length);
  at.speed *= sign;
  at.acceleration *= sign;
  return at;
}

MoveProfile move_profile(const OperationDescription& operation, double surge_period) {
  MoveProfile profile;
  profile.shape = operation.shape;
  profile.distance = operation.distance;
  profile.speed = operation.speed;
  profile.ramp = operation.acceleration_time;
  profile.start = operation.start;
  profile.wait = operation.wait;
  profile.moves = operation.moves;
  profile.period = surge_period;
  return profile;
}

}  // namespace overbend
