/// The section `checks` of the model file.
#pragma once

#include "model/check_settings.h"
#include "modelfile/field_value.h"

namespace overbend {

/// Settings of the code checks; defaults where the file says nothing.
CheckSettings bind_checks(const FieldValue& root);

}  // namespace overbend
