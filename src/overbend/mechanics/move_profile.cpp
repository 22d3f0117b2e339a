#include "mechanics/move_profile.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

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

}  // namespace

double MoveProfile::duration() const {
  const double length = std::abs(distance);
  if (length == 0.0) return 0.0;
  return Trapezoid(length, speed, ramp).duration;
}

WayPoint MoveProfile::at(double time) const {
  const double length = std::abs(distance), sign = distance < 0.0 ? -1.0 : 1.0;
  if (length == 0.0 || time <= start) return {};
  const double cycle = duration() + wait;
  const int done = std::min(static_cast<int>((time - start) / cycle), moves - 1);
  WayPoint at = Trapezoid(length, speed, ramp).at(time - start - done * cycle);
  at.way = sign * (at.way + done * length);
  at.speed *= sign;
  at.acceleration *= sign;
  return at;
}

MoveProfile move_profile(const OperationDescription& operation, double /*surge_period*/) {
  constexpr double kWait = 300.0;  // [s]
  MoveProfile profile;
  profile.distance = operation.distance;
  profile.speed = operation.speed;
  profile.ramp = operation.acceleration_time;
  profile.start = operation.start;
  profile.wait = kWait;
  profile.moves = operation.moves;
  return profile;
}

}  // namespace overbend
