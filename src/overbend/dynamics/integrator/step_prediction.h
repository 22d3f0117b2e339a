/// How a step begins, before its forces are known, what corrections change, and what its accelerations are at last.
#pragma once

#include <vector>

#include "mechanics/tensioner.h"
#include "numerics/generalized_alpha.h"
#include "system/assembly.h"
#include "system/state.h"

namespace overbend {

/// How a tensioner moves in a step, and the speeds that it can reach.
struct MachineStep {
  TensionerDrive drive = TensionerDrive::brake;
  SpeedBounds bounds;
};

/// The state `next` after `h` as the state before foresees it, see GeneralizedAlpha::foreseen(), a line by as much of
/// what stands between its accelerations as would have served the step before best; the travel of the tensioners of
/// the assembly as they are driven by `moves`. Allocates where `next` has other sizes than `now`.
void predict(const GeneralizedAlpha& scheme, const Assembly& assembly, const SystemState& now, double h,
             const std::vector<MachineStep>& moves, SystemState& next);

/// Adds a correction to the places of a line at the end of a step of `h`, and what follows to rates and accelerations.
void correct(const GeneralizedAlpha& scheme, double h, const std::vector<double>& dq, LineState& next);

/// Algorithmic accelerations at the end of a step, of what has moved as it was led too, and what should have been
/// foreseen.
void end_accelerations(const GeneralizedAlpha& scheme, const SystemState& now, SystemState& next);

}  // namespace overbend
