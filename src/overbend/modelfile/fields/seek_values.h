/// Keys and results named by a goal seek, and values with their dimensions.
#pragma once

#include <optional>
#include <string>

#include "modelfile/schema/field.h"
#include "modelfile/schema/scalar_reader.h"

namespace overbend {

/// Returns the row of a key that may be varied, a quantity or a number; null if there is none. `key` as in
/// SeekVariable.
const Field* varied_row(const std::string& key);

/// Returns the SI unit of its dimension.
std::string row_unit(const Field& row);

/// Returns a row, as for a key, for values of the result; empty if there is no such result.
std::optional<Field> result_row(const std::string& result);

/// Reads a text as a value of the row: with its unit, within its range. Plain numbers may be written in per cent.
ScalarReading read_row_value(const std::string& text, const Field& row);

}  // namespace overbend
