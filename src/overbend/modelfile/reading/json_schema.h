/// The field table as JSON Schema, for editors and forms.
#pragma once

#include <string>

namespace overbend {

/// JSON Schema draft-07 of the model file. What a schema cannot say (dimensions of units, one value against another)
/// is left to the reader; every file that the reader accepts is valid.
std::string json_schema();

}  // namespace overbend
