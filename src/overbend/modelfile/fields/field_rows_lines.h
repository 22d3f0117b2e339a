/// Rows of the field table that mooring lines and lines by themselves have in common.
#pragma once

#include <string>
#include <vector>

#include "model/description/mooring_description.h"
#include "model/description/pipe_description.h"
#include "modelfile/schema/field.h"

namespace overbend::field_rows {

/// A type whose derived numbers are still open; resolve_lines (modelfile/binding/line_resolution.h) fills them in.
LineTypeDescription started_type();

/// A new segment with such a type.
LineSegmentDescription& start_segment(std::vector<LineSegmentDescription>& list);

/// Keys of a type of line under `p`, of a LineTypeDescription.
std::vector<Field> line_type_rows(const std::string& p);

/// What a line is made of: type and length, or segments; clumps and buoys. `Line` has `segments` and `points`.
template <typename Line>
std::vector<Field> line_body_rows(const std::string& p);

/// Clumps and buoys under `p`.points by weight and buoyancy, of a `Holder` with `points`. `from`: what their lengths
/// count from.
template <typename Holder>
std::vector<Field> point_rows(const std::string& p, const std::string& from);

}  // namespace overbend::field_rows
