/// What changes of a system: a value. To try a step, copy; to reject it, drop; to checkpoint, write it.
#pragma once

#include <vector>

#include "mechanics/plastic_bending.h"
#include "mechanics/tensioner.h"
#include "numerics/generalized_alpha.h"
#include "system/free_body.h"
#include "system/roller_contacts.h"

namespace overbend {

/// Unknowns of a line, their rates, and every memory of the line. At rest there are no rates and no memories.
struct LineState {
  std::vector<double> q;       ///< Six per node: r [m], t [-]; W.
  std::vector<double> low;     ///< What rounding cut off `q`, at rest alone; empty means zero.
  double far_force = 0.0;      ///< H, at an end that may slide along the bed, away from the barge, at rest alone [N].
  std::vector<double> v, acc;  ///< Rates of `q`.
  std::vector<double> alg;     ///< Algorithmic accelerations, see GeneralizedAlpha.
  AlignedDoubles bed_slip;     ///< See LineMotion.
  std::vector<ContactMemory> contacts;  ///< In the order of RollerContacts.
  std::vector<BendingMemory> bending;   ///< Per Gauss point; empty where no steel yields.
  double bending_heat = 0.0;            ///< Made by yielding so far [J].

  LineShape shape() const { return {q.data(), low.empty() ? nullptr : low.data()}; }
};

/// Of what holds an end of a line.
struct AttachmentState {
  MotionValues guide{};  ///< Length of the tangent in a guide, the one unknown left there.
  TensionerMachine machine;
  MotionValues travel{};  ///< Of the tensioner, what was paid out [m].
};

struct SystemState {
  double time = 0.0;       ///< [s]
  double last_step = 0.0;  ///< That led here; 0 at the start [s].
  std::vector<LineState> lines;
  std::vector<AttachmentState> attachments;
  std::vector<HullState> bodies;  ///< Of the free bodies, in their order.
};

}  // namespace overbend
