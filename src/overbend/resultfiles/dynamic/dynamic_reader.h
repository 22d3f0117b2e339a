/// Reads the results of a dynamic analysis back.
#pragma once

#include <filesystem>

#include "resultfiles/static/results_reader.h"
#include "results/dynamic_results.h"

namespace overbend {

struct StoredDynamics {
  StoredStatics statics;
  DynamicResults results;
};

/// Returns true if the file contains a dynamic analysis. Throws std::runtime_error if it cannot be read.
bool has_dynamic(const std::filesystem::path& h5);

/// Returns the data of write_dynamic_hdf5, bit for bit, except the long data: histories are the thinned ones. Throws
/// std::runtime_error that names the missing dataset if the file has another layout.
StoredDynamics read_dynamic_results(const std::filesystem::path& h5);

}  // namespace overbend
