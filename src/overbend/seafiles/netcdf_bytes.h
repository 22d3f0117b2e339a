/// Serialised contents of a netCDF file.
#pragma once

#include <string>

#include "seafiles/netcdf_arrays.h"

namespace overbend {

std::string serialise_contents(const NetcdfContents& contents);

/// Checks every length and count: the writer read a file that may be damaged. Throws std::runtime_error.
NetcdfContents parse_contents(std::string_view bytes);

}  // namespace overbend
