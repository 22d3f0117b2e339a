/// The classic format of netCDF: CDF-1, CDF-2 (64-bit offset) and CDF-5 (64-bit data).
#pragma once

#include <string>

#include "seafiles/netcdf_arrays.h"

namespace overbend {

/// All variables of the file. Every number of its head is checked against the length of the file before it is used.
/// Format: NetCDF Classic Format Specification, Unidata. Throws std::runtime_error where the head makes no sense.
NetcdfContents read_netcdf_classic(const std::string& path);

}  // namespace overbend
