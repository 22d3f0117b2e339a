/// How a step begins, before its forces are known, and what its accelerations are when they are.
#pragma once

#include "mechanics/tensioner.h"
#include "numerics/generalized_alpha.h"
#include "system/state.h"
#include "system/system.h"

namespace overbend {

/// How the tensioner moves in a step, and the speeds that it can reach.
struct MachineStep {
  TensionerDrive drive = TensionerDrive::brake;
  SpeedBounds bounds;
};

/// The state `next` after `h` as the state before foresees it, see GeneralizedAlpha::foreseen(); the travel of the
/// machine as it is driven. Allocates where `next` has other sizes than `now`.
void predict(const GeneralizedAlpha& scheme, const System& system, const SystemState& now, double h,
             const MachineStep& machine, SystemState& next);

/// Algorithmic accelerations at the end of a step, of what has moved as it was led too.
void end_accelerations(const GeneralizedAlpha& scheme, const SystemState& now, SystemState& next);

}  // namespace overbend
