#include "dynamics/machines/giving_ends.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

constexpr double kEver = std::numeric_limits<double>::infinity();
/// Weight of the speed at the end of a step in the way that a free end goes in it: a little more than half, so that
/// speeds which the tension decides do not swing from step to step.
constexpr double kLateShare = 0.6;
constexpr double kTensionTolerance = 1e-5;  ///< Of the tension kept.
constexpr double kStill = 1e-9;             ///< Speed that is none [m/s].
constexpr int kMostChanges = 6;             ///< Of the stair, in a step.
constexpr double kShortestElement = 0.1;    ///< Of the last element of a line: no more of it can be hauled in.
/// Speed at which a brake that renders, or the soil around an anchor that drags, bears twice what it bears at rest: so
/// what is overloaded at once starts with a speed and not with a jump [m/s]. Half a percent at 0.1 m/s.
constexpr double kDoubleSpeed = 20.0;
constexpr double kFarthest = 0.5;  ///< That a correction of what gave way may go [m].

std::size_t at(Giving how) {
  return static_cast<std::size_t>(how);
}

double late_rate(const GivenWay& now, double moved, double h) {
  return ((moved - now.moved) / h - (1.0 - kLateShare) * now.rate) / kLateShare;
}

bool keeps_tension(const WinchLaw& law) {
  return law.tension.mode == TensionerMode::controlled;
}

bool is_led(const AttachmentState& held) {
  return held.machine.commanded.has_value();
}

/// Lets a winch whose length is told see the end of a step. One whose command is over has come back when it is as fast
/// as its program.
void see_told(const WinchLaw& law, double tension, double time, double h, AttachmentState& after) {
  TensionerMachine& machine = after.machine;
  GivenWay& way = after.way;
  if (!machine.commanded) {
    machine.tension = tension;
  } else if (!machine.returning) {
    way.rate = observe(law.tension, tension, h, {way.moved, way.rate, 0.0}, machine).speed;
  } else {
    machine.tension = tension;
    if (std::abs(law.program.at(time).rate - way.rate) > kStill) return;
    machine.state = TensionerState::hold;
    machine.commanded.reset();
    machine.returning = false;
  }
}

TensionerDrive drive_of(Giving how) {
  switch (how) {
    case Giving::steady:
      return TensionerDrive::slowest;
    case Giving::held_up:
      return TensionerDrive::governor;
    default:
      return TensionerDrive::fastest;
  }
}

Vec3 course(const LineState& line) {
  const Vec3 t(line.q[3], line.q[4], 0.0);
  return t.norm() > 0.0 ? Vec3(t.normalized()) : Vec3::UnitX();
}

}  // namespace

double tension_to_take(const Attachment& held, const LineAssembly& line) {
  const std::array<double, 6>& force = line.held_force(held_node(held, line.line()));
  if (held.winch) {
    return Vec3(force[0], force[1], force[2]).norm();
  }
  return std::hypot(force[0], force[1]) + std::max(0.0, -force[2]);
}

GivingEnds::GivingEnds(const System& system) : system_(&system) {
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    if (system.attachments[i].winch || system.attachments[i].holding < kEver) {
      End end;
      end.attachment = i;
      ends_.push_back(end);
    }
  }
}

/// By its program, or as a command leads it; back to the program from a command that is over.
PaidOut GivingEnds::wanted(const End& end, const SystemState& now, double h) const {
  const WinchLaw& law = *system_->attachments[end.attachment].winch;
  const AttachmentState& held = now.attachments[end.attachment];
  const PaidOut before = law.program.at(now.time), after = law.program.at(now.time + h);
  if (!is_led(held)) return {after.length - before.length, after.rate};
  TensionerMachine machine = held.machine;
  if (machine.returning) machine.commanded = after.rate;
  const double most = law.tension.velocity;  // a brake that renders may be faster, which is not the winch's doing
  const Travel from{held.way.moved, std::clamp(held.way.rate, -most, most), 0.0};
  const double authority = tensioner_authority(*system_, now.time + 0.5 * h);
  const Travel to = led(law.tension, from, reachable_speeds(law.tension, machine, from, authority, h).fastest, h);
  return {to.length - from.length, to.speed};
}

/// Program or command, stall and brake.
void GivingEnds::set_winch(End& end, const SystemState& now, double h) {
  const WinchLaw& law = *system_->attachments[end.attachment].winch;
  const double moved = now.attachments[end.attachment].way.moved;
  const PaidOut after = wanted(end, now, h);
  const Line& line = system_->lines[static_cast<std::size_t>(system_->attachments[end.attachment].line)];
  const double element = now.attachments[end.attachment].way.last_element;
  const double left = (element > 0.0 ? element : line.mesh.length.back()) - kShortestElement * line.mesh.length.back();
  const bool at_its_end = after.length < -left;
  const double way = at_its_end ? 0.0 : after.length;
  end.stairs[at(Giving::steady)] = {true, false, moved + way, at_its_end ? 0.0 : after.rate, 0.0, 0.0, 0.0, 0.0};
  const bool hauls = way < 0.0;
  if (hauls && law.stall < kEver) {
    end.stairs[at(Giving::held_up)] = {true, true, 0.0, 0.0, law.stall, 0.0, std::min(after.rate, way / h), 0.0};
    end.stairs[at(Giving::stopped)] = {true, false, moved, 0.0, 0.0, 0.0, 0.0, 0.0};
  }
  if (law.brake < kEver) {
    const double slowest = hauls ? 0.0 : std::min(after.rate, way / h);
    end.stairs[at(Giving::yielding)] = {true, true, 0.0, 0.0, law.brake, law.brake / kDoubleSpeed, slowest, kEver};
  }
}

/// A winch that keeps a tension: the law of a tensioner.
void GivingEnds::set_keeper(End& end, const SystemState& now, double h) {
  const WinchLaw& law = *system_->attachments[end.attachment].winch;
  const AttachmentState& held = now.attachments[end.attachment];
  const Travel from{held.way.moved, held.way.rate, 0.0};
  const double authority = tensioner_authority(*system_, now.time + 0.5 * h);
  const SpeedBounds bounds = reachable_speeds(law.tension, held.machine, from, authority, h);
  const auto flat = [&](double speed) {
    const Travel to = driven(law.tension, from, speed, h);
    return Stair{true, false, to.length, to.speed, 0.0, 0.0, 0.0, 0.0};
  };
  end.stairs[at(Giving::steady)] = flat(bounds.slowest);
  if (bounds.fastest > bounds.slowest) {
    const double slope = governor_slope(law.tension, held.machine.side > 0 ? 1.0 : -1.0);
    end.stairs[at(Giving::held_up)] = {true, true, 0.0, 0.0, law.tension.wanted, slope, bounds.slowest, bounds.fastest};
    end.stairs[at(Giving::stopped)] = flat(bounds.fastest);
  }
  if (law.brake < kEver) {
    end.stairs[at(Giving::yielding)] = {
        true, true, 0.0, 0.0, law.brake, law.brake / kDoubleSpeed, std::max(bounds.fastest, 0.0), kEver};
  }
}

void GivingEnds::set_anchor(End& end, const SystemState& now) {
  const Attachment& held = system_->attachments[end.attachment];
  end.along = course(now.lines[static_cast<std::size_t>(held.line)]);
  end.stairs[at(Giving::steady)] = {true, false, now.attachments[end.attachment].way.moved, 0.0, 0.0, 0.0, 0.0, 0.0};
  end.stairs[at(Giving::yielding)] = {true, true, 0.0, 0.0, held.holding, held.holding / kDoubleSpeed, 0.0, kEver};
}

void GivingEnds::begin(const SystemState& now, double h, SystemState& next) {
  for (End& end : ends_) {
    const Attachment& held = system_->attachments[end.attachment];
    end.stairs = {};
    end.has_last = false;
    end.changes = 0;
    if (!held.winch) {
      set_anchor(end, now);
    } else if (keeps_tension(*held.winch) && !is_led(now.attachments[end.attachment])) {
      set_keeper(end, now, h);
    } else {
      set_winch(end, now, h);
    }
    Giving how = now.attachments[end.attachment].way.how;
    if (!end.stairs[at(how)].there) {
      how = Giving::steady;
    }
    put_on(end, how, now, h, next);
  }
}

/// Puts what gave way into the state.
void GivingEnds::put(const End& end, const SystemState& now, double h, double moved, double rate, Giving how,
                     SystemState& next) const {
  const Attachment& held = system_->attachments[end.attachment];
  const GivenWay& before = now.attachments[end.attachment].way;
  GivenWay& way = next.attachments[end.attachment].way;
  way.moved = moved;
  way.rate = rate;
  way.how = how;
  if (held.winch) {
    const Line& line = system_->lines[static_cast<std::size_t>(held.line)];
    const double length = before.last_element > 0.0 ? before.last_element : line.mesh.length.back();
    way.last_element = length + (moved - before.moved);
  } else {
    way.dragged = before.dragged + (moved - before.moved) * end.along;
    way.drag_rate = (how == Giving::steady ? 0.0 : (moved - before.moved) / h) * end.along;
  }
}

void GivingEnds::put_on(End& end, Giving how, const SystemState& now, double h, SystemState& next) const {
  const Stair& stair = end.stairs[at(how)];
  end.has_last = false;
  if (!stair.rises) {
    put(end, now, h, stair.moved, stair.rate, how, next);
    return;
  }
  const GivenWay& before = now.attachments[end.attachment].way;
  const double rate = std::clamp(before.rate, stair.slowest, stair.fastest);
  put(end, now, h, before.moved + h * (kLateShare * rate + (1.0 - kLateShare) * before.rate), rate, how, next);
}

bool GivingEnds::settle(const Assembly& assembly, const SystemState& now, double h, SystemState& next) {
  bool settled = true;
  for (End& end : ends_) {
    settled = settle_one(end, assembly, now, h, next) && settled;
  }
  if (settled) {
    for (End& end : ends_) {
      finish(end, assembly, now, h, next);
    }
  }
  return settled;
}

bool GivingEnds::settle_one(End& end, const Assembly& assembly, const SystemState& now, double h, SystemState& next) {
  const Attachment& held = system_->attachments[end.attachment];
  if (!held.hold_place) {
    return true;
  }
  GivenWay& way = next.attachments[end.attachment].way;
  const LineAssembly& line = assembly.line(static_cast<std::size_t>(held.line));
  const double tension = tension_to_take(held, line);
  const std::size_t here = at(way.how);
  const auto to = [&](int step) {
    int other = static_cast<int>(here) + step;
    while (other >= 0 && other < 4 && !end.stairs[static_cast<std::size_t>(other)].there) other += step;
    return other >= 0 && other < 4 ? other : -1;
  };
  const auto change = [&](int other) {
    if (other < 0 || ++end.changes > kMostChanges) return true;
    put_on(end, static_cast<Giving>(other), now, h, next);
    return false;
  };
  const auto level = [](const Stair& stair, double rate) { return stair.level + stair.slope * rate; };
  const Stair& stair = end.stairs[here];
  if (!stair.rises) {
    const int up = to(1), down = to(-1);
    const auto beyond = [&](int other, double sign) {
      if (other < 0) return false;
      const Stair& rise = end.stairs[static_cast<std::size_t>(other)];
      const double least = level(rise, sign > 0.0 ? rise.slowest : rise.fastest);
      return rise.rises && sign * (tension - least) > kTensionTolerance * least;
    };
    if (beyond(up, 1.0)) return change(up);
    if (beyond(down, -1.0)) return change(down);
    return true;
  }
  const double wanted = level(stair, way.rate), excess = tension - wanted;
  const double tolerance = kTensionTolerance * stair.level;
  const bool too_slow = way.rate<stair.slowest - kStill, too_fast = way.rate> stair.fastest + kStill;
  if (too_slow && excess < tolerance) return change(to(-1));
  if (too_fast && excess > -tolerance) return change(to(1));
  if (std::abs(excess) < tolerance) return true;
  double stiffness = way.stiffness;
  if (end.has_last && way.moved != end.last_moved) {
    const double found = -(excess - end.last_excess) / (way.moved - end.last_moved);
    if (found > 0.0) stiffness = found;
  }
  if (stiffness <= 0.0) {  // the softest that it can be: the line stretched along its whole length
    const LineElements& elements = line.elements();
    double softness = 0.0;
    for (int e = 0; e < elements.count; ++e) {
      softness += elements.length[static_cast<std::size_t>(e)] / elements.EA[static_cast<std::size_t>(e)];
    }
    stiffness = 1.0 / softness + stair.slope / (kLateShare * h);
  }
  way.stiffness = stiffness;
  end.has_last = true;
  end.last_moved = way.moved;
  end.last_excess = excess;
  const double moved = way.moved + std::clamp(excess / stiffness, -kFarthest, kFarthest);
  put(end, now, h, moved, late_rate(now.attachments[end.attachment].way, moved, h), way.how, next);
  return false;
}

/// Keeps account of a step, and lets a machine that keeps a tension see it.
void GivingEnds::finish(End& end, const Assembly& assembly, const SystemState& now, double h, SystemState& next) const {
  const Attachment& held = system_->attachments[end.attachment];
  AttachmentState& after = next.attachments[end.attachment];
  GivenWay& way = after.way;
  if (way.how == Giving::yielding) {
    way.gave_way += way.moved - now.attachments[end.attachment].way.moved;
  }
  if (!held.winch) {
    return;
  }
  const double tension = tension_to_take(held, assembly.line(static_cast<std::size_t>(held.line)));
  if (is_led(after) || !keeps_tension(*held.winch)) {
    const bool held_up = way.how == Giving::held_up || way.how == Giving::stopped;
    way.held_up_for += held_up ? h : 0.0;
    see_told(*held.winch, tension, next.time, h, after);
    return;
  }
  const TensionerLaw& law = held.winch->tension;
  if (after.machine.state == TensionerState::pay_out || after.machine.state == TensionerState::haul_in) {
    after.machine.drive = drive_of(way.how);
  }
  const Travel travel = observe(law, tension, h, {way.moved, way.rate, 0.0}, after.machine);
  if (travel.speed == 0.0) {
    way.rate = 0.0;
    way.how = way.how == Giving::yielding ? way.how : Giving::steady;
  }
  if (after.machine.state == TensionerState::pay_out && way.rate == 0.0) {
    way.how = Giving::stopped;
  }
}

}  // namespace overbend
