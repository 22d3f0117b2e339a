/// Tolerances of the inputs of a model: the key `sensitivities.tolerances`.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "modelfile/binding/model_inputs.h"

namespace overbend {

struct InputTolerance {
  double value = 0.0;  ///< Either way, SI.
  bool given = false;  ///< True if given in the file; false for the default.
};

/// Returns true for a position along an axis or an offset from a position.
bool is_place(const ModelInput& input);

/// Returns the default tolerance: 10 mm for positions, 0.1 deg for angles, 1 % of anything else.
double default_tolerance(const ModelInput& input);

/// Returns the tolerance of every input, in their order. The last entry that matches an input's key or name counts.
std::vector<InputTolerance> input_tolerances(const FieldValue& root, const std::vector<ModelInput>& inputs);

/// Checks the tolerances of a file: each must match a number in it, and have its dimension or be in per cent.
void check_tolerances(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

}  // namespace overbend
