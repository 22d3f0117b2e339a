/// A told motion that does not begin where statics leave the vessel.
#pragma once

#include "model/model.h"

namespace overbend {

/// How far the stern shoe is from where statics have it once a told motion acts in full without a build-up [m]; 0 with
/// a build-up, and of a hull whose motion is computed.
double leap_at_start(const Model& model);

}  // namespace overbend
