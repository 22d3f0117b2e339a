/// What one value of a model file demands of another.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "modelfile/field_value.h"

namespace overbend {

/// Impossible combinations (errors) and doubtful ones (warnings). Checks whose values are absent or were refused are
/// passed over: their complaint is there already.
void check_model(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// Waves: what each type needs, breaking, validity of the theory. Part of check_model.
void check_waves(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// Supports, rollers and tensioner: part of check_model.
void check_supports(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// The steel's law beyond yield: part of check_model.
void check_materials(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// The vessel's motion: part of check_model.
void check_motion(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

}  // namespace overbend
