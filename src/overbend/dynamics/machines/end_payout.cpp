#include "dynamics/machines/end_payout.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
/// Weight of the speed at the end of a step in the payout of a free end over it: a little more than half, so that
/// speeds determined by the tension do not oscillate from step to step.
constexpr double kEndRateWeight = 0.6;
constexpr double kTensionTolerance = 1e-5;  ///< Relative to the tension.
constexpr double kZeroSpeed = 1e-9;         ///< Speed that counts as zero [m/s].
constexpr int kMaxSegmentChanges = 6;       ///< Maximum number of changes of the segment in a step.
/// Minimum length of the last element of a line, relative to its initial length: limit of hauling in.
constexpr double kMinLastElement = 0.1;
/// Speed at which a rendering brake, or the soil around a dragging anchor, resists twice its static capacity [m/s].
/// Regularisation: an overload produces a finite speed, not a jump. The increase is half a percent at 0.1 m/s.
constexpr double kDoubleSpeed = 20.0;
constexpr double kMaxCorrection = 0.5;  ///< Maximum correction of a payout [m].

std::size_t segment_index(PayoutMode mode) {
  return static_cast<std::size_t>(mode);
}

double end_rate(const PayoutState& start, double moved, double h) {
  return ((moved - start.moved) / h - (1.0 - kEndRateWeight) * start.rate) / kEndRateWeight;
}

bool keeps_tension(const WinchLaw& law) {
  return law.tension.mode == TensionerMode::controlled;
}

bool is_commanded(const AttachmentState& held) {
  return held.machine.commanded.has_value();
}

/// Updates a winch with prescribed length at the end of a step. After a command has ended it returns to the program,
/// which it has reached when it is as fast.
void update_commanded_winch(const WinchLaw& law, double tension, double time, double h, AttachmentState& after) {
  TensionerMachine& machine = after.machine;
  PayoutState& payout = after.payout;
  if (!machine.commanded) {
    machine.tension = tension;
  } else if (!machine.returning) {
    payout.rate = observe(law.tension, tension, h, {payout.moved, payout.rate, 0.0}, machine).speed;
  } else {
    machine.tension = tension;
    if (std::abs(law.program.at(time).rate - payout.rate) > kZeroSpeed) return;
    machine.state = TensionerState::hold;
    machine.commanded.reset();
    machine.returning = false;
  }
}

TensionerDrive find_drive(PayoutMode mode) {
  switch (mode) {
    case PayoutMode::programmed:
      return TensionerDrive::slowest;
    case PayoutMode::stalling:
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

double held_end_load(const Attachment& held, const LineAssembly& line) {
  const std::array<double, 6>& force = line.held_force(held_node(held, line.line()));
  if (held.winch) {
    return Vec3(force[0], force[1], force[2]).norm();
  }
  return std::hypot(force[0], force[1]) + std::max(0.0, -force[2]);
}

EndPayoutSolver::EndPayoutSolver(const System& system) : system_(&system) {
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    if (system.attachments[i].winch || system.attachments[i].holding < kNoLimit) {
      End end;
      end.attachment = i;
      ends_.push_back(end);
    }
  }
}

/// Returns the payout over a step by the program or as commanded; after a command has ended, back towards the program.
PaidOut EndPayoutSolver::wanted(const End& end, const SystemState& start, double h) const {
  const WinchLaw& law = *system_->attachments[end.attachment].winch;
  const AttachmentState& held = start.attachments[end.attachment];
  const PaidOut before = law.program.at(start.time), after = law.program.at(start.time + h);
  if (!is_commanded(held)) return {after.length - before.length, after.rate};
  TensionerMachine machine = held.machine;
  if (machine.returning) machine.commanded = after.rate;
  const double max_speed = law.tension.velocity;  // a rendering brake may be faster, but not by the winch
  const Travel from{held.payout.moved, std::clamp(held.payout.rate, -max_speed, max_speed), 0.0};
  const double authority = tensioner_ramp_factor(*system_, start.time + 0.5 * h);
  const Travel to =
      advance_commanded(law.tension, from, reachable_speeds(law.tension, machine, from, authority, h).fastest, h);
  return {to.length - from.length, to.speed};
}

/// Sets the segments of program or command, stall and brake.
void EndPayoutSolver::set_winch(End& end, const SystemState& start, double h) {
  const WinchLaw& law = *system_->attachments[end.attachment].winch;
  const double moved = start.attachments[end.attachment].payout.moved;
  const PaidOut after = wanted(end, start, h);
  const Line& line = system_->lines[static_cast<std::size_t>(system_->attachments[end.attachment].line)];
  const double element = start.attachments[end.attachment].payout.last_element;
  const double left = (element > 0.0 ? element : line.mesh.length.back()) - kMinLastElement * line.mesh.length.back();
  const bool at_its_end = after.length < -left;
  const double paid_length = at_its_end ? 0.0 : after.length;
  end.segments[segment_index(PayoutMode::programmed)] = {
      true, false, moved + paid_length, at_its_end ? 0.0 : after.rate, 0.0, 0.0, 0.0, 0.0};
  const bool hauls = paid_length < 0.0;
  if (hauls && law.stall < kNoLimit) {
    end.segments[segment_index(PayoutMode::stalling)] = {
        true, true, 0.0, 0.0, law.stall, 0.0, std::min(after.rate, paid_length / h), 0.0};
    end.segments[segment_index(PayoutMode::stalled)] = {true, false, moved, 0.0, 0.0, 0.0, 0.0, 0.0};
  }
  if (law.brake < kNoLimit) {
    const double slowest = hauls ? 0.0 : std::min(after.rate, paid_length / h);
    end.segments[segment_index(PayoutMode::rendering)] = {
        true, true, 0.0, 0.0, law.brake, law.brake / kDoubleSpeed, slowest, kNoLimit};
  }
}

/// Sets the segments of a constant-tension winch: the law of a tensioner.
void EndPayoutSolver::set_constant_tension_winch(End& end, const SystemState& start, double h) {
  const WinchLaw& law = *system_->attachments[end.attachment].winch;
  const AttachmentState& held = start.attachments[end.attachment];
  const Travel from{held.payout.moved, held.payout.rate, 0.0};
  const double authority = tensioner_ramp_factor(*system_, start.time + 0.5 * h);
  const SpeedBounds bounds = reachable_speeds(law.tension, held.machine, from, authority, h);
  const auto flat = [&](double speed) {
    const Travel to = advance_governed(law.tension, from, speed, h);
    return SpeedTensionSegment{true, false, to.length, to.speed, 0.0, 0.0, 0.0, 0.0};
  };
  end.segments[segment_index(PayoutMode::programmed)] = flat(bounds.slowest);
  if (bounds.fastest > bounds.slowest) {
    const double slope = governor_slope(law.tension, held.machine.side > 0 ? 1.0 : -1.0);
    end.segments[segment_index(PayoutMode::stalling)] = {true,  true,           0.0,           0.0, law.tension.wanted,
                                                         slope, bounds.slowest, bounds.fastest};
    end.segments[segment_index(PayoutMode::stalled)] = flat(bounds.fastest);
  }
  if (law.brake < kNoLimit) {
    end.segments[segment_index(PayoutMode::rendering)] = {
        true, true, 0.0, 0.0, law.brake, law.brake / kDoubleSpeed, std::max(bounds.fastest, 0.0), kNoLimit};
  }
}

void EndPayoutSolver::set_anchor(End& end, const SystemState& start) {
  const Attachment& held = system_->attachments[end.attachment];
  end.along = course(start.lines[static_cast<std::size_t>(held.line)]);
  end.segments[segment_index(PayoutMode::programmed)] = {
      true, false, start.attachments[end.attachment].payout.moved, 0.0, 0.0, 0.0, 0.0, 0.0};
  end.segments[segment_index(PayoutMode::rendering)] = {
      true, true, 0.0, 0.0, held.holding, held.holding / kDoubleSpeed, 0.0, kNoLimit};
}

void EndPayoutSolver::begin(const SystemState& start, double h, SystemState& next) {
  for (End& end : ends_) {
    const Attachment& held = system_->attachments[end.attachment];
    end.segments = {};
    end.has_last = false;
    end.changes = 0;
    if (!held.winch) {
      set_anchor(end, start);
    } else if (keeps_tension(*held.winch) && !is_commanded(start.attachments[end.attachment])) {
      set_constant_tension_winch(end, start, h);
    } else {
      set_winch(end, start, h);
    }
    PayoutMode mode = start.attachments[end.attachment].payout.mode;
    if (!end.segments[segment_index(mode)].exists) {
      mode = PayoutMode::programmed;
    }
    set_segment(end, mode, start, h, next);
  }
}

/// Writes a payout into the state.
void EndPayoutSolver::set_payout(const End& end, const SystemState& start, double h, double moved, double rate,
                                 PayoutMode mode, SystemState& next) const {
  const Attachment& held = system_->attachments[end.attachment];
  const PayoutState& before = start.attachments[end.attachment].payout;
  PayoutState& payout = next.attachments[end.attachment].payout;
  payout.moved = moved;
  payout.rate = rate;
  payout.mode = mode;
  if (held.winch) {
    const Line& line = system_->lines[static_cast<std::size_t>(held.line)];
    const double length = before.last_element > 0.0 ? before.last_element : line.mesh.length.back();
    payout.last_element = length + (moved - before.moved);
  } else {
    payout.dragged = before.dragged + (moved - before.moved) * end.along;
    payout.drag_rate = (mode == PayoutMode::programmed ? 0.0 : (moved - before.moved) / h) * end.along;
  }
}

void EndPayoutSolver::set_segment(End& end, PayoutMode mode, const SystemState& start, double h,
                                  SystemState& next) const {
  const SpeedTensionSegment& stair = end.segments[segment_index(mode)];
  end.has_last = false;
  if (!stair.rises) {
    set_payout(end, start, h, stair.moved, stair.rate, mode, next);
    return;
  }
  const PayoutState& before = start.attachments[end.attachment].payout;
  const double rate = std::clamp(before.rate, stair.slowest, stair.fastest);
  set_payout(end, start, h, before.moved + h * (kEndRateWeight * rate + (1.0 - kEndRateWeight) * before.rate), rate,
             mode, next);
}

bool EndPayoutSolver::settle(const Assembly& assembly, const SystemState& start, double h, SystemState& next) {
  bool settled = true;
  for (End& end : ends_) {
    settled = settle_end(end, assembly, start, h, next) && settled;
  }
  if (settled) {
    for (End& end : ends_) {
      finish(end, assembly, start, h, next);
    }
  }
  return settled;
}

bool EndPayoutSolver::settle_end(End& end, const Assembly& assembly, const SystemState& start, double h,
                                 SystemState& next) {
  const Attachment& held = system_->attachments[end.attachment];
  if (!held.hold_place) {
    return true;
  }
  PayoutState& payout = next.attachments[end.attachment].payout;
  const LineAssembly& line = assembly.line(static_cast<std::size_t>(held.line));
  const double tension = held_end_load(held, line);
  const std::size_t current = segment_index(payout.mode);
  const auto to = [&](int step) {
    int neighbour = static_cast<int>(current) + step;
    while (neighbour >= 0 && neighbour < 4 && !end.segments[static_cast<std::size_t>(neighbour)].exists) {
      neighbour += step;
    }
    return neighbour >= 0 && neighbour < 4 ? neighbour : -1;
  };
  const auto change = [&](int target) {
    if (target < 0 || ++end.changes > kMaxSegmentChanges) return true;
    set_segment(end, static_cast<PayoutMode>(target), start, h, next);
    return false;
  };
  const auto level = [](const SpeedTensionSegment& stair, double rate) { return stair.level + stair.slope * rate; };
  const SpeedTensionSegment& stair = end.segments[current];
  if (!stair.rises) {
    const int up = to(1), down = to(-1);
    const auto beyond = [&](int target, double sign) {
      if (target < 0) return false;
      const SpeedTensionSegment& rise = end.segments[static_cast<std::size_t>(target)];
      const double limit = level(rise, sign > 0.0 ? rise.slowest : rise.fastest);
      return rise.rises && sign * (tension - limit) > kTensionTolerance * limit;
    };
    if (beyond(up, 1.0)) return change(up);
    if (beyond(down, -1.0)) return change(down);
    return true;
  }
  const double wanted = level(stair, payout.rate), excess = tension - wanted;
  const double tolerance = kTensionTolerance * stair.level;
  const bool too_slow = payout.rate<stair.slowest - kZeroSpeed, too_fast = payout.rate> stair.fastest + kZeroSpeed;
  if (too_slow && excess < tolerance) return change(to(-1));
  if (too_fast && excess > -tolerance) return change(to(1));
  if (std::abs(excess) < tolerance) return true;
  double stiffness = payout.stiffness;
  if (end.has_last && payout.moved != end.last_moved) {
    const double found = -(excess - end.last_excess) / (payout.moved - end.last_moved);
    if (found > 0.0) stiffness = found;
  }
  if (stiffness <= 0.0) {  // lower bound: the line stretched along its whole length
    const LineElements& elements = line.elements();
    double softness = 0.0;
    for (int e = 0; e < elements.count; ++e) {
      softness += elements.length[static_cast<std::size_t>(e)] / elements.EA[static_cast<std::size_t>(e)];
    }
    stiffness = 1.0 / softness + stair.slope / (kEndRateWeight * h);
  }
  payout.stiffness = stiffness;
  end.has_last = true;
  end.last_moved = payout.moved;
  end.last_excess = excess;
  const double moved = payout.moved + std::clamp(excess / stiffness, -kMaxCorrection, kMaxCorrection);
  set_payout(end, start, h, moved, end_rate(start.attachments[end.attachment].payout, moved, h), payout.mode, next);
  return false;
}

/// Completes a step: updates the totals and the machines that keep a tension.
void EndPayoutSolver::finish(End& end, const Assembly& assembly, const SystemState& start, double h,
                             SystemState& next) const {
  const Attachment& held = system_->attachments[end.attachment];
  AttachmentState& after = next.attachments[end.attachment];
  PayoutState& payout = after.payout;
  if (payout.mode == PayoutMode::rendering) {
    payout.rendered_length += payout.moved - start.attachments[end.attachment].payout.moved;
  }
  if (!held.winch) {
    return;
  }
  const double tension = held_end_load(held, assembly.line(static_cast<std::size_t>(held.line)));
  if (is_commanded(after) || !keeps_tension(*held.winch)) {
    const bool stalling = payout.mode == PayoutMode::stalling || payout.mode == PayoutMode::stalled;
    payout.stalled_time += stalling ? h : 0.0;
    update_commanded_winch(*held.winch, tension, next.time, h, after);
    return;
  }
  const TensionerLaw& law = held.winch->tension;
  if (after.machine.state == TensionerState::pay_out || after.machine.state == TensionerState::haul_in) {
    after.machine.drive = find_drive(payout.mode);
  }
  const Travel travel = observe(law, tension, h, {payout.moved, payout.rate, 0.0}, after.machine);
  if (travel.speed == 0.0) {
    payout.rate = 0.0;
    payout.mode = payout.mode == PayoutMode::rendering ? payout.mode : PayoutMode::programmed;
  }
  if (after.machine.state == TensionerState::pay_out && payout.rate == 0.0) {
    payout.mode = PayoutMode::stalled;
  }
}

}  // namespace overbend
