/// The file with the depths of an uneven sea bed.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/description.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// How far the depth of a shaped bed at the stern shoe may be from `environment.water_depth` [m].
inline constexpr double kDepthTolerance = 0.1;

/// What is found where the depths disagree by more; nothing where they agree.
std::optional<std::string> depth_disagrees(double bed_depth, double water_depth);

/// Fills `environment.seabed.bathymetry` from its file. Statics cannot do without: a file that is not there is an
/// error, as is one whose depth at the stern shoe is not the water depth.
void read_bathymetry_file(const FieldValue& root, Description& description, Diagnostics& diagnostics);

/// Warns of a bed that rises astern and leaves the water where a pipe is laid. After the bathymetry was read.
void check_shore(const FieldValue& root, const Description& description, Diagnostics& diagnostics);

}  // namespace overbend
