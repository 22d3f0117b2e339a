#include "mechanics/tensioner.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSameTime = 1e-12;  ///< Time differences below this are rounding [s].
constexpr double kRestored = 0.01;   ///< Fraction of half the range within which the target tension counts as restored.
/// Distance from the end of the travel within which the machine is at its limit [m].
constexpr double kSamePlace = 1e-6;

bool moves(const TensionerMachine& m) {
  return m.state == TensionerState::pay_out || m.state == TensionerState::haul_in;
}

/// Returns the maximum speed w after `h` from which it can still stop at its travel limit, `room` ahead of its current
/// position, braking within its acceleration and for at least one more step [m/s]: h (v + w) / 2 + max(w^2 / (2 a), h w
/// / 2) = room.
double stoppable_speed(double room, double v, double acceleration, double h) {
  const double left = std::max(room - 0.5 * h * v, 0.0);
  const double slowly = acceleration * (std::sqrt(0.25 * h * h + 2.0 * left / acceleration) - 0.5 * h);
  return std::min(slowly, left / h);
}

void stop_machine(TensionerMachine& m, TensionerState state) {
  m.state = state;
  m.drive = TensionerDrive::brake;
  m.timer = 0.0;
}

void start_moving(const TensionerLaw& law, const Travel& travel, TensionerMachine& m) {
  if (m.side * travel.length >= law.limit - kSamePlace) {
    stop_machine(m, TensionerState::at_limit);
    return;
  }
  m.state = m.side > 0 ? TensionerState::pay_out : TensionerState::haul_in;
  m.drive = m.side > 0 ? TensionerDrive::fastest : TensionerDrive::slowest;
  m.timer = 0.0;
}

/// Makes one change of state of a machine at rest. Returns true if there was one.
bool change_once(const TensionerLaw& law, const Travel& travel, TensionerMachine& m) {
  const bool beyond = excess(law, m, m.tension, travel.speed) >= -law.resolution;
  switch (m.state) {
    case TensionerState::hold:
      if (beyond) {
        m.state = TensionerState::delay;
        m.side = m.tension > 0.5 * (law.low + law.high) ? 1 : -1;
        m.timer = 0.0;
      }
      return beyond;
    case TensionerState::delay:
      if (m.timer >= law.delay - kSameTime) {
        start_moving(law, travel, m);
        return true;
      }
      [[fallthrough]];
    case TensionerState::at_limit:
      if (beyond) {
        stop_machine(m, TensionerState::hold);
      }
      return beyond;
    case TensionerState::pay_out:
    case TensionerState::haul_in:
      break;
  }
  return false;
}

/// Reverses with the speed, and stops at the travel limit. A speed that would count as restored is not a reversal.
Travel update_from_speed(const TensionerLaw& law, const Travel& travel, TensionerMachine& m) {
  if (-m.side * travel.speed > kRestored * law.velocity) {
    m.side = -m.side;
    m.state = m.side > 0 ? TensionerState::pay_out : TensionerState::haul_in;
  }
  const int outward = m.drive == TensionerDrive::fastest ? 1 : m.drive == TensionerDrive::slowest ? -1 : 0;
  if (outward != 0 && law.limit - outward * travel.length <= kSamePlace) {
    m.side = outward;
    stop_machine(m, TensionerState::at_limit);
    return {outward * law.limit, 0.0, 0.0};
  }
  return travel;
}

/// Updates state and travel of a commanded machine: it is at rest at the end of its travel.
Travel update_from_command(const TensionerLaw& law, const Travel& travel, TensionerMachine& m) {
  const int outward = travel.length > 0.0 ? 1 : -1;
  if (law.limit - outward * travel.length <= kSamePlace && outward * *m.commanded > 0.0) {
    m.side = outward;
    m.state = TensionerState::at_limit;
    return {outward * law.limit, 0.0, 0.0};
  }
  m.side = travel.speed > 0.0 ? 1 : travel.speed < 0.0 ? -1 : 0;
  m.state = m.side > 0 ? TensionerState::pay_out : m.side < 0 ? TensionerState::haul_in : TensionerState::hold;
  if (m.returning && m.side == 0) {
    m.commanded.reset();
    m.returning = false;
    stop_machine(m, TensionerState::hold);
  }
  return travel;
}

}  // namespace

SpeedBounds reachable_speeds(const TensionerLaw& law, const TensionerMachine& m, const Travel& travel, double authority,
                             double h) {
  if (!m.commanded && law.mode == TensionerMode::constant) {
    return {-kNever, kNever};
  }
  if (!m.commanded && !moves(m)) {
    return {0.0, 0.0};
  }
  const auto max_speed = [&](double v, double room) {
    const double change = law.acceleration * h;
    const double speed = std::min(std::max(law.velocity * authority, v - change), v + change);
    return room < kNever ? std::min(speed, stoppable_speed(room, v, law.acceleration, h)) : speed;
  };
  const double fastest = max_speed(travel.speed, law.limit - travel.length);
  const double slowest = std::min(-max_speed(-travel.speed, law.limit + travel.length), fastest);
  if (m.commanded) {
    const double speed = std::clamp(*m.commanded, slowest, fastest);
    return {speed, speed};
  }
  return {slowest, fastest};
}

Travel advance_governed(const TensionerLaw& law, const Travel& travel, double speed, double h) {
  const double length = travel.length + 0.5 * h * (travel.speed + speed);
  return {std::clamp(length, -law.limit, law.limit), speed, (speed - travel.speed) / h};
}

Travel advance_commanded(const TensionerLaw& law, const Travel& travel, double speed, double h) {
  const double gain = speed - travel.speed;
  const double ramp = gain == 0.0 ? 0.0 : std::min(std::abs(gain) / law.acceleration, h);
  const double length = travel.length + h * speed - 0.5 * ramp * gain;
  return {std::clamp(length, -law.limit, law.limit), speed, gain / h};
}

void set_target_tension(TensionerLaw& law, double wanted) {
  const double shift = wanted - law.wanted;
  law.wanted = wanted;
  law.low += shift;
  law.high += shift;
}

void command_speed(TensionerMachine& m, double speed) {
  m.commanded = speed;
  m.returning = false;
  if (m.state == TensionerState::delay) m.state = TensionerState::hold;
  m.drive = TensionerDrive::fastest;
  m.timer = 0.0;
}

void return_to_law(const TensionerLaw& law, double speed, TensionerMachine& m) {
  if (!m.commanded) return;
  if (law.mode == TensionerMode::locked) {
    m.commanded = 0.0;
    m.returning = true;
    return;
  }
  m.commanded.reset();
  stop_machine(m, TensionerState::hold);
  if (law.mode == TensionerMode::controlled && speed != 0.0) {
    m.side = speed > 0.0 ? 1 : -1;
    m.state = speed > 0.0 ? TensionerState::pay_out : TensionerState::haul_in;
    m.drive = TensionerDrive::governor;
  }
}

double governor_slope(const TensionerLaw& law, double speed) {
  if (law.mode == TensionerMode::constant) {
    return 0.0;
  }
  const double band = speed > 0.0 ? law.high - law.wanted : law.wanted - law.low;
  // If the range ends at or near the target tension, tension cannot distinguish full speed from rest: the machine would
  // stop at once from any speed, an impact for the pipe.
  constexpr double kMinBand = 100.0;  // multiples of the resolution
  return std::max(band, kMinBand * law.resolution) / law.velocity;
}

double governed_tension(const TensionerLaw& law, double speed) {
  return law.wanted + governor_slope(law, speed) * speed;
}

TensionerDrive first_drive(const TensionerLaw& law, const TensionerMachine& m) {
  if (m.commanded) {
    return TensionerDrive::fastest;
  }
  if (law.mode == TensionerMode::constant) {
    return TensionerDrive::governor;
  }
  return moves(m) ? m.drive : TensionerDrive::brake;
}

TensionerDrive matching_drive(const TensionerLaw& law, const SpeedBounds& bounds, TensionerDrive drive, double speed,
                              double tension) {
  switch (drive) {
    case TensionerDrive::brake:
      return drive;
    case TensionerDrive::governor:
      return speed > bounds.fastest   ? TensionerDrive::fastest
             : speed < bounds.slowest ? TensionerDrive::slowest
                                      : drive;
    case TensionerDrive::slowest:
      return bounds.fastest > bounds.slowest && tension > governed_tension(law, bounds.slowest)
                 ? TensionerDrive::governor
                 : drive;
    case TensionerDrive::fastest:
      return bounds.fastest > bounds.slowest && tension < governed_tension(law, bounds.fastest)
                 ? TensionerDrive::governor
                 : drive;
  }
  return drive;
}

double excess(const TensionerLaw& law, const TensionerMachine& m, double tension, double speed) {
  if (m.commanded || law.mode != TensionerMode::controlled) {
    return -kNever;
  }
  const double above = tension - law.high, below = law.low - tension;
  switch (m.state) {
    case TensionerState::hold:
      return std::max(above, below);
    case TensionerState::delay:  // slightly within the range, so that reaching its edge from inside is not a return
      return -(m.side > 0 ? above : below) - 2.0 * law.resolution;
    case TensionerState::at_limit:
      return m.side * (law.wanted - tension);
    case TensionerState::pay_out:
    case TensionerState::haul_in: {
      const double restored = kRestored * law.velocity;
      const bool may_stop = m.drive == TensionerDrive::governor && m.timer >= law.delay - kSameTime;
      return may_stop ? governor_slope(law, m.side) * (restored - m.side * speed) : -kNever;
    }
  }
  return -kNever;
}

double time_to_move(const TensionerLaw& law, const TensionerMachine& m) {
  return m.state == TensionerState::delay ? std::max(law.delay - m.timer, 0.0) : kNever;
}

Travel observe(const TensionerLaw& law, double tension, double h, const Travel& travel, TensionerMachine& m) {
  m.tension = tension;
  if (m.commanded) {
    return update_from_command(law, travel, m);
  }
  if (law.mode != TensionerMode::controlled) {
    return travel;
  }
  Travel next_travel = travel;
  if (m.state == TensionerState::delay) {
    m.timer += h;
  } else if (moves(m)) {
    m.timer = out_of_range(law, tension) ? 0.0 : m.timer + h;
    if (excess(law, m, tension, travel.speed) >= -law.resolution) {
      stop_machine(m, TensionerState::hold);
      next_travel = {travel.length, 0.0, 0.0};
    } else {
      next_travel = update_from_speed(law, travel, m);
    }
  }
  constexpr int kMaxStateChanges = 4;  // leaving the range on one side and at once on the other
  for (int i = 0; i < kMaxStateChanges && !moves(m) && change_once(law, next_travel, m); ++i) {
  }
  return next_travel;
}

double step_to_event(const TensionerLaw& law, const EventTry& before, const EventTry& current, double min_step) {
  if (current.excess <= law.resolution || current.h <= min_step || !std::isfinite(before.excess)) {
    return current.h;
  }
  const double slope = (current.excess - before.excess) / (current.h - before.h);
  const double late = slope > 0.0 ? current.excess / slope : current.h;
  if (before.h > 0.0 && late <= min_step) {
    return current.h;
  }
  return std::clamp(current.h - late + 0.5 * min_step, std::min(min_step, 0.5 * current.h), 0.95 * current.h);
}

}  // namespace overbend
