/// What one value of a model file demands of another.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/description/description.h"
#include "model/description/mooring_description.h"
#include "modelfile/schema/check_helper.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// Impossible combinations (errors) and doubtful ones (warnings). Checks whose values are absent or were refused are
/// passed over: their complaint is there already.
void check_model(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// Waves: what each type needs, breaking, validity of the theory. Part of check_model.
void check_waves(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// Whether the waves of an irregular sea break on the bed; after the file with a user's spectrum was read.
void check_sea_over_bed(const FieldValue& root, const Description& description, Diagnostics& diagnostics);

/// Supports, rollers and tensioner: part of check_model.
void check_supports(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// The shape of the seabed: part of check_model.
void check_seabed(Checker& check);
/// A stinger on hinges: part of check_supports.
void check_stinger(Checker& check);

/// The sections of the stinger that the file tells; the stinger itself where it is one. None without a stinger.
std::vector<const FieldValue*> stinger_sections(const FieldValue& root);

/// The steel's law beyond yield: part of check_model.
void check_materials(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// The vessel's motion: part of check_model.
void check_motion(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// `lay_table`: part of check_model.
void check_lay_table(Checker& check);

/// What is built into the pipe, and its passage: part of check_model.
void check_structures(Checker& check);

/// The lay route: part of check_model.
void check_route(Checker& check);

/// Mooring lines: part of check_model. Adds the types of line in use.
void check_moorings(Checker& check, std::set<std::string>& used_types);

/// What is done with the moored vessel or the line: part of check_model.
void check_operation(Checker& check);

/// Operations on the line: cable, head, winch, anchor and stages. `type` is one of them; part of check_operation.
/// Stages of a lift: what they name is there, and what they join can be.
void check_lift(Checker& check, const FieldValue& operation);
void check_lay_operation(Checker& check, const FieldValue& operation, OperationType type);

/// Bodies besides the vessel: part of check_model.
void check_bodies(Checker& check, const std::string& file);

/// Where a motion comes from: `vessel.motion`, or that of another body; part of check_motion and check_bodies.
void check_motion_source(Checker& check, const FieldValue& motion);

/// Lines by themselves: part of check_model.
void check_free_lines(Checker& check, std::set<std::string>& used_types);

/// The floating hull: part of check_model.
void check_hull(Checker& check, const std::string& file);

/// What a goal seek varies and looks for: part of check_model.
void check_seek(Checker& check);

/// Whether the hull is found by statics instead of held as drawn.
bool hull_floats(const FieldValue& root);

}  // namespace overbend
