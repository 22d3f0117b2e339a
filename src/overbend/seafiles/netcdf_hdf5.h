/// Reader of netCDF-4 files, which are HDF5 files.
#pragma once

#include <string>

#include "seafiles/netcdf_arrays.h"

namespace overbend {

/// Reads all variables; names of those in groups begin with the path of the group, "body1/properties/cg". HDF5 1.10
/// crashes on some damaged files, so a child process reads them (base/child_work.h). Throws std::runtime_error if the
/// file cannot be read, also if the child process crashes.
NetcdfContents read_netcdf_hdf5(const std::string& path);

}  // namespace overbend
