/// Field table as JSON Schema, for editors and forms.
#pragma once

#include <string>

namespace overbend {

/// Returns the JSON Schema draft-07 of the model file. The reader checks what a schema cannot express (dimensions of
/// units, relations between values); every file that the reader accepts is valid.
std::string json_schema();

}  // namespace overbend
