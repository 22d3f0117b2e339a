#include "mechanics/move_profile.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Maximum speed of a minimum-jerk path of unit length and duration (Flash & Hogan 1985).
constexpr double kPeakSpeed = 1.875;

/// Trapezoidal speed profile; a distance too short for the full speed uses the same acceleration up to a lower speed.
struct Trapezoid {
  double speed = 0.0, ramp = 0.0, duration = 0.0;

  Trapezoid(double distance, double max_speed, double ramp_time) {
    speed = max_speed;
    ramp = ramp_time;
    if (distance < max_speed * ramp_time) {
      const double share = std::sqrt(distance / (max_speed * ramp_time));
      speed *= share;
      ramp *= share;
    }
    duration = distance / speed + ramp;
  }
  MoveState at(double t) const {
    const auto from_rest = [&](double s) {
      return ramp > 0.0 && s < ramp ? MoveState{0.5 * speed / ramp * s * s, speed / ramp * s, speed / ramp}
                                    : MoveState{speed * (s - 0.5 * ramp), speed, 0.0};
    };
    if (t <= 0.0) return {};
    const double left = duration - t, full_length = speed * (duration - ramp);
    if (left <= 0.0) return {full_length, 0.0, 0.0};
    if (left >= t) return from_rest(t);
    const MoveState back = from_rest(left);
    return {full_length - back.distance, back.speed, -back.acceleration};
  }
};

MoveState minimum_jerk(double distance, double duration, double time) {
  const double u = std::clamp(time / duration, 0.0, 1.0), v = 1.0 - u;
  return {distance * u * u * u * (10.0 + u * (6.0 * u - 15.0)), 30.0 * distance / duration * u * u * v * v,
          60.0 * distance / (duration * duration) * u * v * (v - u)};
}

/// One move of positive length from t = 0.
MoveState single_move_state(const MoveProfile& p, double distance, double t) {
  if (p.shape == MoveShape::minimum_jerk) return minimum_jerk(distance, p.duration(), t);
  const Trapezoid trapezoid(distance, p.speed, p.ramp);
  const MoveState first = trapezoid.at(t);
  if (p.shape == MoveShape::trapezoid) return first;
  const MoveState second = trapezoid.at(t - 0.5 * p.period);
  return {0.5 * (first.distance + second.distance), 0.5 * (first.speed + second.speed),
          0.5 * (first.acceleration + second.acceleration)};
}

}  // namespace

double MoveProfile::duration() const {
  const double length = std::abs(distance);
  if (length == 0.0) return 0.0;
  if (shape == MoveShape::minimum_jerk) return kPeakSpeed * length / speed;
  const double full_duration = Trapezoid(length, speed, ramp).duration;
  return shape == MoveShape::zero_vibration ? full_duration + 0.5 * period : full_duration;
}

MoveState MoveProfile::at(double time) const {
  const double length = std::abs(distance), sign = distance < 0.0 ? -1.0 : 1.0;
  if (length == 0.0 || time <= start) return {};
  const double cycle = duration() + wait;
  const int done = std::min(static_cast<int>((time - start) / cycle), moves - 1);
  MoveState point = single_move_state(*this, length, time - start - done * cycle);
  point.distance = sign * (point.distance + done * length);
  point.speed *= sign;
  point.acceleration *= sign;
  return point;
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
