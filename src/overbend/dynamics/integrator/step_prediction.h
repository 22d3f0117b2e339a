/// Predictor of a step, effect of corrections, and final accelerations.
#pragma once

#include <vector>

#include "mechanics/tensioner.h"
#include "numerics/generalized_alpha.h"
#include "system/assembly.h"
#include "system/state.h"

namespace overbend {

/// Drive mode of a tensioner in a step and its reachable speeds.
struct MachineStep {
  TensionerDrive drive = TensionerDrive::brake;
  SpeedBounds bounds;
};

/// Sets `next` to the prediction after `h`, see GeneralizedAlpha. Each line uses the extrapolation factor
/// that would have been best for its previous step; the tensioners of the assembly move as driven by `moves`. Allocates
/// if the sizes of `next` differ from those of `start`.
void predict(const GeneralizedAlpha& scheme, const Assembly& assembly, const SystemState& start, double h,
             const std::vector<MachineStep>& moves, SystemState& next);

/// Adds a correction to the unknowns of a line at the end of a step of `h`, with the corresponding changes of rates and
/// accelerations.
void correct(const GeneralizedAlpha& scheme, double h, const std::vector<double>& dq, LineState& next);

/// Sets the algorithmic accelerations at the end of a step, including prescribed motions, and the best extrapolation
/// factor of the step.
void end_accelerations(const GeneralizedAlpha& scheme, const SystemState& start, SystemState& next);

}  // namespace overbend
