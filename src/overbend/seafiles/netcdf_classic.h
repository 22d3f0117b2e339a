/// Reader of the classic netCDF formats: CDF-1, CDF-2 (64-bit offset) and CDF-5 (64-bit data).
#pragma once

#include <string>

#include "seafiles/netcdf_arrays.h"

namespace overbend {

/// Reads all variables of the file. Every number of its header is checked against the length of the file before use.
/// Format: NetCDF Classic Format Specification, Unidata. Throws std::runtime_error if the header is inconsistent.
NetcdfContents read_netcdf_classic(const std::string& path);

}  // namespace overbend
