/// Variable part of a system, as a value: copy to try a step, drop to reject it, write to checkpoint.
#pragma once

#include <vector>

#include "mechanics/bending_histories.h"
#include "mechanics/tensioner.h"
#include "numerics/generalized_alpha.h"
#include "system/free_body.h"
#include "system/roller_contacts.h"

namespace overbend {

/// Unknowns of a line, their rates, and all its memories. At rest there are no rates and no memories.
struct LineState {
  LineState();  // These six are compiled once: copying all members is long code, used in many sources.
  LineState(const LineState&);
  LineState(LineState&&) noexcept;
  LineState& operator=(const LineState&);
  LineState& operator=(LineState&&) noexcept;
  ~LineState();

  std::vector<double> q;    ///< Six per node: r [m], t [-]; W.
  std::vector<double> low;  ///< Rounding remainder of `q`, only at rest; empty means zero.
  /// H, horizontal force at an end that may slide along the seabed, away from the vessel, only at rest [N].
  double far_force = 0.0;
  std::vector<double> v, acc;                    ///< Rates of `q`.
  std::vector<double> algorithmic_acceleration;  ///< Algorithmic accelerations, see GeneralizedAlpha.
  double acceleration_extrapolation = 0.0;       ///< Ratio used to extrapolate the acceleration; see step_prediction.h.
  AlignedDoubles bed_slip;                       ///< See LineMotion.
  std::vector<ContactMemory> contacts;           ///< In the order of RollerContacts.
  BendingMemories bending;                       ///< Empty if no steel yields.
  double bending_heat = 0.0;                     ///< Dissipated by yielding so far [J].

  LineShape shape() const { return {q.data(), low.empty() ? nullptr : low.data()}; }
};

/// Payout mode of an end: a winch pays out, an anchor drags. In the order of the tension.
enum class PayoutMode {
  programmed,  ///< Follows its program, or holds; constant-tension winch: its minimum speed.
  stalling,    ///< Slower than its program, at its stall tension; constant-tension winch: by its governor.
  stalled,     ///< Does not haul in above the stall tension; constant-tension winch: its maximum speed.
  rendering    ///< Renders or drags: as fast as limits the tension to its capacity.
};

/// Payout of a winch, or drag of an anchor.
struct PayoutState {
  double moved = 0.0;  ///< Payout or drag distance since the start [m].
  double rate = 0.0;   ///< [m/s]
  /// Unstressed length of the last element as given by a winch; 0: that of the mesh [m].
  double last_element = 0.0;
  Vec3 dragged = Vec3::Zero();               ///< Displacement of an anchor, W [m].
  Vec3 drag_rate = Vec3::Zero();             ///< [m/s]
  PayoutMode mode = PayoutMode::programmed;  ///< Mode over the last step.
  double stiffness = 0.0;        ///< Decrease of the tension per payout in a step, from the last iterations [N/m].
  double rendered_length = 0.0;  ///< Total length rendered or dragged [m].
  double stalled_time = 0.0;     ///< Total time in which it could not haul in [s].
};

/// State of an attachment.
struct AttachmentState {
  MotionValues guide{};  ///< Length of the tangent in a guide, its only free unknown.
  TensionerMachine machine;
  MotionValues travel{};  ///< Payout of the tensioner [m].
  PayoutState payout;
  bool parted = false;  ///< True once the line has failed at this end.
};

/// State of a system.
struct SystemState {
  SystemState();  // These six are compiled once: copying all members is long code, used in many sources.
  SystemState(const SystemState&);
  SystemState(SystemState&&) noexcept;
  SystemState& operator=(const SystemState&);
  SystemState& operator=(SystemState&&) noexcept;
  ~SystemState();

  double time = 0.0;       ///< [s]
  double last_step = 0.0;  ///< Step that led here; 0 at the start [s].
  std::vector<LineState> lines;
  std::vector<AttachmentState> attachments;
  std::vector<HullState> bodies;  ///< Free bodies, in their order.
};

}  // namespace overbend
