/// The long data of a dynamic run in results.h5.
#pragma once

#include "resultfiles/hdf5/hdf5_file.h"
#include "runstore/run_store.h"

namespace overbend {

/// Writes /dynamic/histories, /dynamic/impacts and /dynamic/snapshots from the store in blocks; /dynamic/stations must
/// exist. Throws std::runtime_error if a number is not finite.
void write_long_data(Hdf5Writer& file, const RunStore& store);

}  // namespace overbend
