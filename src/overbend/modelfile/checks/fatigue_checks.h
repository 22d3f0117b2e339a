/// Requirements of the fatigue keys on the rest of the model.
#pragma once

#include "modelfile/schema/check_helper.h"

namespace overbend {

/// Part of check_model.
void check_fatigue(Checker& check);

}  // namespace overbend
