/// Checks that mooring lines and lines by themselves share.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "modelfile/schema/check_helper.h"

namespace overbend {

/// Names of lines in a list, those without one by their number.
std::vector<std::string> line_names(const std::vector<FieldValue>& lines);

/// Names of the bodies besides the vessel, those without one by their number.
std::vector<std::string> body_names(const FieldValue& root);

/// Names under moorings.types, those that were complained about as well.
std::vector<std::string> names_below(const FieldValue& root, const std::string& group);

/// A name that refers to one of `known`, which stand under the key `where`.
void check_name(Checker& check, const FieldValue& name, const std::vector<std::string>& known,
                const std::string& where);

/// Names of a list's items differ. `kind` as in "line".
void check_unique_names(Checker& check, const std::vector<FieldValue>& items, const std::string& kind);

/// Numbers of a type in place, or its kind: all that is needed, nothing twice.
void check_line_type(Checker& check, const FieldValue& type);

/// What a line is made of. `tension`: the key that may stand for the length of the first segment, "" where none may.
void check_line_body(Checker& check, const FieldValue& line, const std::string& tension, std::set<std::string>& used);

/// Types under moorings.types, and which of them no line uses.
void check_line_types(Checker& check, const std::set<std::string>& used);

/// Depth of a level seabed; empty where it slopes or is not known.
std::optional<double> level_bed(const FieldValue& root);

/// Whether a value of that path stands in the file, right or wrong.
bool is_given(const FieldValue& root, const std::string& path);

}  // namespace overbend
