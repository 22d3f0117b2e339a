/// Keys and results that a goal seek names, and values with the dimension of one.
#pragma once

#include <optional>
#include <string>

#include "modelfile/schema/field.h"
#include "modelfile/schema/scalar_reader.h"

namespace overbend {

/// The row of a key that may be varied, a quantity or a number; null where there is none. `key` as in SeekVariable.
const Field* varied_row(const std::string& key);

/// The SI unit of its dimension.
std::string unit_of(const Field& row);

/// A row like that of a key, for values of the result; nothing where there is no such result.
std::optional<Field> result_row(const std::string& result);

/// A text as a value of the row: with its unit, within its range. Plain numbers may be written in percent.
ScalarReading read_value_of(const std::string& text, const Field& row);

}  // namespace overbend
