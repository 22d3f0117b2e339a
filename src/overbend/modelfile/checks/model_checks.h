/// Checks of values of a model file against each other.
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

/// Reports impossible combinations (errors) and doubtful ones (warnings). Checks whose values are missing or invalid
/// are skipped: these are reported before.
void check_model(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// Checks the waves: required keys of each type, breaking, validity of the theory. Part of check_model.
void check_waves(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// Warns if the waves of an irregular sea, of all groups together, break at this depth; call after the files with
/// spectra are read.
void check_sea_over_bed(const FieldValue& root, const Description& description, Diagnostics& diagnostics);

/// Checks the direction of waves from files against `from`, and the length of records against that of the run; call
/// after the files are read.
void check_wave_files(const FieldValue& root, const Description& description, Diagnostics& diagnostics);

/// Supports, rollers and tensioner: part of check_model.
void check_supports(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// The shape of the seabed: part of check_model.
void check_seabed(Checker& check);
/// A stinger on hinges: part of check_supports.
void check_stinger(Checker& check);

/// Returns the stinger sections given in the file; the stinger itself if it is a single section. Empty without a
/// stinger.
std::vector<const FieldValue*> stinger_sections(const FieldValue& root);

/// Checks the material law of the steel beyond yield: part of check_model.
void check_materials(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// The vessel's motion: part of check_model.
void check_motion(const FieldValue& root, const std::string& file, Diagnostics& diagnostics);

/// `lay_table`: part of check_model.
void check_lay_table(Checker& check);

/// In-line structures and their passage: part of check_model.
void check_structures(Checker& check);

/// The lay route: part of check_model.
void check_route(Checker& check);

/// Mooring lines: part of check_model. Adds the line types in use to `used_types`.
void check_moorings(Checker& check, std::set<std::string>& used_types);

/// Operations of the moored vessel or the line: part of check_model.
void check_operation(Checker& check);

/// Operations on the laid line: cable, head, winch, anchor and stages, with `type` one of them; and stages of a lift:
/// the names that they refer to, and the joins. Part of check_operation.
void check_lift(Checker& check, const FieldValue& operation);
void check_lay_operation(Checker& check, const FieldValue& operation, OperationType type);

/// Bodies other than the vessel: part of check_model.
void check_bodies(Checker& check, const std::string& file);

/// Source of a motion: `vessel.motion`, or that of another body; part of check_motion and check_bodies.
void check_motion_source(Checker& check, const FieldValue& motion);

/// Free lines: part of check_model.
void check_free_lines(Checker& check, std::set<std::string>& used_types);

/// The floating hull: part of check_model.
void check_hull(Checker& check, const std::string& file);

/// Variables and conditions of a goal seek: part of check_model.
void check_seek(Checker& check);

/// Returns true if statics finds the position of the hull, which is otherwise held as drawn.
bool hull_floats(const FieldValue& root);

}  // namespace overbend
