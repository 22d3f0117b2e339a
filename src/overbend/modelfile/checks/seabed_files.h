/// File with the depths of an uneven seabed.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/description.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// Max. difference between the depth of the seabed shape at the stern shoe and `environment.water_depth` [m].
inline constexpr double kDepthTolerance = 0.1;

/// Returns a message if the depths differ by more; empty otherwise.
std::optional<std::string> depth_disagrees(double bed_depth, double water_depth);

/// Fills `environment.seabed.bathymetry` from its file. Statics needs it: a missing file is an error, as is a depth at
/// the stern shoe that differs from the water depth.
void read_bathymetry_file(const FieldValue& root, Description& description, Diagnostics& diagnostics);

/// Warns of a seabed that rises astern above the water where a pipe is laid. Call after the bathymetry is read.
void check_shore(const FieldValue& root, const Description& description, Diagnostics& diagnostics);

}  // namespace overbend
