/// The contents of a netCDF file on their way from one process to another.
#pragma once

#include <string>

#include "seafiles/netcdf_arrays.h"

namespace overbend {

std::string bytes_of_contents(const NetcdfContents& contents);

/// Takes nothing for granted: whoever wrote the bytes read a file that may be damaged. Throws std::runtime_error where
/// they are no contents.
NetcdfContents contents_of_bytes(std::string_view bytes);

}  // namespace overbend
