/// The section `checks` of the model file.
#pragma once

#include "io/field_value.h"
#include "model/check_settings.h"

namespace overbend {

/// Settings of the code checks; defaults where the file says nothing.
CheckSettings bind_checks(const FieldValue& root);

}  // namespace overbend
