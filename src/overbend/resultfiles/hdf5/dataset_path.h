/// Paths in results.h5 that follow from names.
#pragma once

#include <string>

#include "resultfiles/hdf5/hdf5_file.h"

namespace overbend {

/// Where the history or spectrum `name` stands below its group: its parts between '/' are groups; a part that HDF5
/// would take for something else (empty, ".") becomes "_".
std::string dataset_path(const std::string& name);

/// Makes those groups above the dataset or group `path` that are not there yet.
void make_groups_above(Hdf5Writer& file, const std::string& path, const std::string& description);

}  // namespace overbend
