/// netCDF-4, which is HDF5.
#pragma once

#include <string>

#include "seafiles/netcdf_arrays.h"

namespace overbend {

/// All variables of the file's root. HDF5 1.10 does not survive every damaged file, so that it reads in a process of
/// its own (base/child_work.h). Throws std::runtime_error where the file cannot be read, whichever way that ends.
NetcdfContents read_netcdf_hdf5(const std::string& path);

}  // namespace overbend
