/// A stage of a lift in results.h5.
#pragma once

#include <string>

#include "resultfiles/hdf5/dataset_sink.h"
#include "resultfiles/hdf5/hdf5_readers.h"
#include "results/static_results.h"

namespace overbend {

/// Writes the whole state of a stage below `group`.
void write_lift_group(DatasetSink& file, const std::string& group, const StaticResults& results);
/// Reads the same state back, without `lines`.
StaticResults read_lift_group(const Hdf5Reader& file, const std::string& group);

}  // namespace overbend
