/// The long data of a dynamic run in results.h5.
#pragma once

#include "resultfiles/hdf5/hdf5_file.h"
#include "runstore/run_store.h"

namespace overbend {

/// /dynamic/histories, /dynamic/impacts and /dynamic/snapshots, from the store in blocks; /dynamic/stations must
/// stand. Throws std::runtime_error when a number is none.
void write_long_data(Hdf5Writer& file, const RunStore& store);

}  // namespace overbend
