/// How far the inputs of a model may be off: the key `sensitivities.tolerances`.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "modelfile/binding/model_inputs.h"

namespace overbend {

struct InputTolerance {
  double value = 0.0;  ///< Either way, SI.
  bool given = false;  ///< In the file; else it is the usual one.
};

/// A place along one axis, or how far something is moved from its place.
bool is_place(const ModelInput& input);

/// What is taken where the file says nothing: 10 mm for a place, 0.1 deg for an angle, 1 % of anything else.
double usual_tolerance(const ModelInput& input);

/// Of every input, in their order. The last entry that an input's key or name matches counts.
std::vector<InputTolerance> input_tolerances(const FieldValue& root, const std::vector<ModelInput>& inputs);

/// The tolerances of a file: each has to match a number in it, and to be of its dimension or in per cent.
void check_tolerances(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

}  // namespace overbend
