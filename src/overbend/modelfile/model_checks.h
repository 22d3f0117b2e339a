/// What one value of a model file demands of another.
#pragma once

#include <set>
#include <string>

#include "base/diagnostics.h"
#include "modelfile/check_helper.h"
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

/// Mooring lines and what is done with them: part of check_model. Adds the types of line in use.
void check_moorings(Checker& check, std::set<std::string>& used_types);

/// Lines by themselves: part of check_model.
void check_free_lines(Checker& check, std::set<std::string>& used_types);

/// The floating hull: part of check_model.
void check_hull(Checker& check, const std::string& file);

/// Whether the hull is found by statics instead of held as drawn.
bool hull_floats(const FieldValue& root);

}  // namespace overbend
