/// Checks shared by mooring lines and free lines.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "modelfile/schema/check_helper.h"

namespace overbend {

/// Returns the names of lines in a list; a line without a name is named by its number.
std::vector<std::string> line_names(const std::vector<FieldValue>& lines);

/// Returns the names of the bodies other than the vessel; a body without a name is named by its number.
std::vector<std::string> body_names(const FieldValue& root);

/// Returns the names below a group, including those with errors.
std::vector<std::string> names_below(const FieldValue& root, const std::string& group);

/// Checks a name against `known`, the names under the key `where`.
void check_name(Checker& check, const FieldValue& name, const std::vector<std::string>& known,
                const std::string& where);

/// Checks that the names of a list's items are unique. `kind` as in "line".
void check_unique_names(Checker& check, const std::vector<FieldValue>& items, const std::string& kind);

/// Checks the numbers or the kind of a type: complete and without duplicates.
void check_line_type(Checker& check, const FieldValue& type);

/// Checks the body of a line. `tension`: key that may replace the length of the first segment, "" if none.
void check_line_body(Checker& check, const FieldValue& line, const std::string& tension, std::set<std::string>& used);

/// Checks the types under moorings.types and warns of unused ones.
void check_line_types(Checker& check, const std::set<std::string>& used);

/// Returns the depth of a level seabed; empty if it slopes or is not known.
std::optional<double> level_bed(const FieldValue& root);

/// Returns true if the path has a value in the file, valid or not.
bool is_given(const FieldValue& root, const std::string& path);

}  // namespace overbend
