/// Paths in results.h5 derived from names.
#pragma once

#include <string>

#include "resultfiles/hdf5/hdf5_file.h"

namespace overbend {

/// Returns the path of the history or spectrum `name` below its group: its parts between '/' are groups; a part with a
/// special meaning in HDF5 (empty, ".") becomes "_".
std::string dataset_path(const std::string& name);

/// Creates the missing groups above the dataset or group `path`.
void make_groups_above(Hdf5Writer& file, const std::string& path, const std::string& description);

}  // namespace overbend
