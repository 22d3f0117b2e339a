/// A told motion that does not begin where statics leave the vessel.
#pragma once

#include "dynamics/integrator/dynamics.h"
#include "model/model.h"

namespace overbend {

/// How far the stern shoe is from where statics have it once a told motion acts in full without a build-up [m]; 0 with
/// a build-up, and of a hull whose motion is computed.
double leap_at_start(const Model& model);

/// How fast the stern shoe is at once where a told motion acts in full without a build-up [m/s]; 0 as above. A motion
/// that begins in its place, as a sine does, still strikes what hangs on the vessel.
double speed_at_start(const Model& model);

/// The same of lines by themselves: the largest leap of an end that moves as told or with the vessel [m].
double line_leap_at_start(const Model& model, const DynamicOptions& options);

}  // namespace overbend
