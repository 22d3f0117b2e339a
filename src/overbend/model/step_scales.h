/// What a run in time holds its steps against where the model file does not say: sizes of the problem itself, so that
/// a model of another scale is followed as closely.
#pragma once

#include "model/model.h"

namespace overbend {

struct StepScales {
  double time = 0.125;   ///< Longest step [s]; shorter ones are shares of it.
  double length = 1e-3;  ///< Of the error of a step [m].
  double force = 1e3;    ///< Below which an impact is none [N].
};

/// Never above these: large structures in long waves are followed as ships in usual ones.
StepScales step_scales(const Model& model);

}  // namespace overbend
