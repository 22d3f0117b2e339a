/// Rows of the field table shared by mooring lines and free lines.
#pragma once

#include <string>
#include <vector>

#include "model/description/mooring_description.h"
#include "model/description/pipe_description.h"
#include "modelfile/schema/field.h"

namespace overbend::field_rows {

/// Returns a type with open derived numbers; resolve_lines (modelfile/binding/line_resolution.h) fills them in.
LineTypeDescription make_open_line_type();

/// Appends a new segment with such a type.
LineSegmentDescription& start_segment(std::vector<LineSegmentDescription>& list);

/// Keys of a line type under `p`, members of a LineTypeDescription.
std::vector<Field> line_type_rows(const std::string& p);

/// Body of a line: type and length, or segments; clumps and buoys. `Line` has `segments` and `points`.
template <typename Line>
std::vector<Field> line_body_rows(const std::string& p);

/// Clumps and buoys under `p`.points by weight and buoyancy, of a `Holder` with `points`. `from`: origin of their
/// lengths.
template <typename Holder>
std::vector<Field> point_rows(const std::string& p, const std::string& from);

}  // namespace overbend::field_rows
