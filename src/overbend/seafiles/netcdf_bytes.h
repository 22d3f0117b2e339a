/// Serialisation of the contents of a netCDF file, for transfer between processes.
#pragma once

#include <string>

#include "seafiles/netcdf_arrays.h"

namespace overbend {

/// Returns the contents as bytes.
std::string serialise_contents(const NetcdfContents& contents);

/// Parses the bytes. Checks every length and count, because the writing process may have read a damaged file. Throws
/// std::runtime_error.
NetcdfContents parse_contents(std::string_view bytes);

}  // namespace overbend
