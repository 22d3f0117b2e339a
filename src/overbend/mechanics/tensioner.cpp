#include "mechanics/tensioner.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSameTime = 1e-12;  ///< Differences of time that are rounding [s].
constexpr double kRestored = 0.01;   ///< Share of the range's half within which the wanted tension is restored.
constexpr double kSamePlace = 1e-6;  ///< From the end of its travel: it is there [m].

bool moves(const TensionerMachine& m) {
  return m.state == TensionerState::pay_out || m.state == TensionerState::haul_in;
}

/// Greatest speed w after `h` from which it can still stop at its travel limit, `room` ahead now, braking within its
/// acceleration and for one more step at least [m/s]: h (v + w) / 2 + max(w^2 / (2 a), h w / 2) = room.
double stoppable_speed(double room, double v, double acceleration, double h) {
  const double left = std::max(room - 0.5 * h * v, 0.0);
  const double slowly = acceleration * (std::sqrt(0.25 * h * h + 2.0 * left / acceleration) - 0.5 * h);
  return std::min(slowly, left / h);
}

void come_to_rest(TensionerMachine& m, TensionerState state) {
  m.state = state;
  m.drive = TensionerDrive::brake;
  m.timer = 0.0;
}

void start_moving(const TensionerLaw& law, const Travel& travel, TensionerMachine& m) {
  if (m.side * travel.length >= law.limit - kSamePlace) {
    come_to_rest(m, TensionerState::at_limit);
    return;
  }
  m.state = m.side > 0 ? TensionerState::pay_out : TensionerState::haul_in;
  m.drive = m.side > 0 ? TensionerDrive::fastest : TensionerDrive::slowest;
  m.timer = 0.0;
}

/// One change of state of a machine at rest, if there is one to make.
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
        come_to_rest(m, TensionerState::hold);
      }
      return beyond;
    case TensionerState::pay_out:
    case TensionerState::haul_in:
      break;
  }
  return false;
}

/// Reverses with the speed, and stops at its travel limit. A speed that would count as restored is not yet a turn.
Travel follow_speed(const TensionerLaw& law, const Travel& travel, TensionerMachine& m) {
  if (-m.side * travel.speed > kRestored * law.velocity) {
    m.side = -m.side;
    m.state = m.side > 0 ? TensionerState::pay_out : TensionerState::haul_in;
  }
  const int outward = m.drive == TensionerDrive::fastest ? 1 : m.drive == TensionerDrive::slowest ? -1 : 0;
  if (outward != 0 && law.limit - outward * travel.length <= kSamePlace) {
    m.side = outward;
    come_to_rest(m, TensionerState::at_limit);
    return {outward * law.limit, 0.0, 0.0};
  }
  return travel;
}

/// State and travel of a machine that is led by a command: it stands at the end of its travel.
Travel follow_command(const TensionerLaw& law, const Travel& travel, TensionerMachine& m) {
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
    come_to_rest(m, TensionerState::hold);
  }
  return travel;
}

}  // namespace

SpeedBounds reachable_speeds(const TensionerLaw& law, const TensionerMachine& m, const Travel& now, double authority,
                             double h) {
  if (!m.commanded && law.mode == TensionerMode::constant) {
    return {-kNever, kNever};
  }
  if (!m.commanded && !moves(m)) {
    return {0.0, 0.0};
  }
  const auto greatest = [&](double v, double room) {
    const double change = law.acceleration * h;
    const double speed = std::min(std::max(law.velocity * authority, v - change), v + change);
    return room < kNever ? std::min(speed, stoppable_speed(room, v, law.acceleration, h)) : speed;
  };
  const double fastest = greatest(now.speed, law.limit - now.length);
  const double slowest = std::min(-greatest(-now.speed, law.limit + now.length), fastest);
  if (m.commanded) {
    const double speed = std::clamp(*m.commanded, slowest, fastest);
    return {speed, speed};
  }
  return {slowest, fastest};
}

Travel driven(const TensionerLaw& law, const Travel& now, double speed, double h) {
  const double length = now.length + 0.5 * h * (now.speed + speed);
  return {std::clamp(length, -law.limit, law.limit), speed, (speed - now.speed) / h};
}

Travel led(const TensionerLaw& law, const Travel& now, double speed, double h) {
  const double gain = speed - now.speed;
  const double ramp = gain == 0.0 ? 0.0 : std::min(std::abs(gain) / law.acceleration, h);
  const double length = now.length + h * speed - 0.5 * ramp * gain;
  return {std::clamp(length, -law.limit, law.limit), speed, gain / h};
}

void set_wanted_tension(TensionerLaw& law, double wanted) {
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

void leave_to_law(const TensionerLaw& law, double speed, TensionerMachine& m) {
  if (!m.commanded) return;
  if (law.mode == TensionerMode::locked) {
    m.commanded = 0.0;
    m.returning = true;
    return;
  }
  m.commanded.reset();
  come_to_rest(m, TensionerState::hold);
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
  // Where the range ends at the wanted tension, or next to it, tensions could not tell full speed from rest: the
  // machine would stop at once from any speed, an impact for the pipe.
  constexpr double kLeastBand = 100.0;  // times the resolution
  return std::max(band, kLeastBand * law.resolution) / law.velocity;
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

TensionerDrive fitting_drive(const TensionerLaw& law, const SpeedBounds& bounds, TensionerDrive drive, double speed,
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
    case TensionerState::delay:  // a little within the range, so that meeting its edge from inside is not coming back
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
    return follow_command(law, travel, m);
  }
  if (law.mode != TensionerMode::controlled) {
    return travel;
  }
  Travel now = travel;
  if (m.state == TensionerState::delay) {
    m.timer += h;
  } else if (moves(m)) {
    m.timer = out_of_range(law, tension) ? 0.0 : m.timer + h;
    if (excess(law, m, tension, travel.speed) >= -law.resolution) {
      come_to_rest(m, TensionerState::hold);
      now = {travel.length, 0.0, 0.0};
    } else {
      now = follow_speed(law, travel, m);
    }
  }
  constexpr int kMostChanges = 4;  // out of one side of the range and at once out of the other
  for (int i = 0; i < kMostChanges && !moves(m) && change_once(law, now, m); ++i) {
  }
  return now;
}

double step_to_event(const TensionerLaw& law, const EventTry& before, const EventTry& now, double shortest) {
  if (now.excess <= law.resolution || now.h <= shortest || !std::isfinite(before.excess)) {
    return now.h;
  }
  const double slope = (now.excess - before.excess) / (now.h - before.h);
  const double late = slope > 0.0 ? now.excess / slope : now.h;
  if (before.h > 0.0 && late <= shortest) {
    return now.h;
  }
  return std::clamp(now.h - late + 0.5 * shortest, std::min(shortest, 0.5 * now.h), 0.95 * now.h);
}

}  // namespace overbend
