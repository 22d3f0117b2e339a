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

/// Whether the file holds a dynamic analysis. Throws std::runtime_error when it cannot be read.
bool has_dynamic(const std::filesystem::path& h5);

/// Gives back what write_dynamic_hdf5 wrote, bit for bit, but the long data: of the histories it gives the thinned
/// ones. Throws std::runtime_error that says what is missing where the file is none of ours.
StoredDynamics read_dynamic_results(const std::filesystem::path& h5);

}  // namespace overbend
