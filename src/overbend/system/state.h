/// What changes of a system: a value. To try a step, copy; to reject it, drop; to checkpoint, write it.
#pragma once

#include <vector>

#include "mechanics/bending_memories.h"
#include "mechanics/tensioner.h"
#include "numerics/generalized_alpha.h"
#include "system/free_body.h"
#include "system/roller_contacts.h"

namespace overbend {

/// Unknowns of a line, their rates, and every memory of the line. At rest there are no rates and no memories.
struct LineState {
  LineState();  // These six are compiled once: a copy of all members is long, and many sources make one.
  LineState(const LineState&);
  LineState(LineState&&) noexcept;
  LineState& operator=(const LineState&);
  LineState& operator=(LineState&&) noexcept;
  ~LineState();

  std::vector<double> q;       ///< Six per node: r [m], t [-]; W.
  std::vector<double> low;     ///< What rounding cut off `q`, at rest alone; empty means zero.
  double far_force = 0.0;      ///< H, at an end that may slide along the bed, away from the barge, at rest alone [N].
  std::vector<double> v, acc;  ///< Rates of `q`.
  std::vector<double> alg;     ///< Algorithmic accelerations, see GeneralizedAlpha.
  double foresight = 0.0;      ///< What the last step should have foreseen of `acc` less `alg`, see step_prediction.h.
  AlignedDoubles bed_slip;     ///< See LineMotion.
  std::vector<ContactMemory> contacts;  ///< In the order of RollerContacts.
  BendingMemories bending;              ///< Empty where no steel yields.
  double bending_heat = 0.0;            ///< Made by yielding so far [J].

  LineShape shape() const { return {q.data(), low.empty() ? nullptr : low.data()}; }
};

/// How an end gives way: a winch pays out, an anchor drags. In the order of the tension that it takes.
enum class Giving {
  steady,   ///< Follows its program, or stays; of a winch that keeps a tension: its least speed.
  held_up,  ///< Slower than its program, at the tension at which it stalls; of the other: by its governor.
  stopped,  ///< Does not haul in against more than that; of the other: its greatest speed.
  yielding  ///< Renders or drags: as fast as keeps the tension at what it bears.
};

struct GivenWay {
  double moved = 0.0;             ///< Paid out, or dragged, since the start [m].
  double rate = 0.0;              ///< [m/s]
  double last_element = 0.0;      ///< Unstressed length that a winch gives it; 0: that of the mesh [m].
  Vec3 dragged = Vec3::Zero();    ///< Place of an anchor from where it was, W [m].
  Vec3 drag_rate = Vec3::Zero();  ///< [m/s]
  Giving how = Giving::steady;    ///< Over the last step.
  double stiffness = 0.0;         ///< Fall of the tension with what gave way in a step, as found last [N/m].
  double gave_way = 0.0;          ///< So far by yielding [m].
  double held_up_for = 0.0;       ///< Time in which it could not haul in [s].
};

/// Of what holds an end of a line.
struct AttachmentState {
  MotionValues guide{};  ///< Length of the tangent in a guide, the one unknown left there.
  TensionerMachine machine;
  MotionValues travel{};  ///< Of the tensioner, what was paid out [m].
  GivenWay way;
  bool parted = false;  ///< It has let the line go.
};

struct SystemState {
  SystemState();  // These six are compiled once: a copy of all members is long, and many sources make one.
  SystemState(const SystemState&);
  SystemState(SystemState&&) noexcept;
  SystemState& operator=(const SystemState&);
  SystemState& operator=(SystemState&&) noexcept;
  ~SystemState();

  double time = 0.0;       ///< [s]
  double last_step = 0.0;  ///< That led here; 0 at the start [s].
  std::vector<LineState> lines;
  std::vector<AttachmentState> attachments;
  std::vector<HullState> bodies;  ///< Of the free bodies, in their order.
};

}  // namespace overbend
