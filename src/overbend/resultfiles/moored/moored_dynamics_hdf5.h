/// A floating hull and its mooring lines over time in results.h5: /dynamic/vessel, /dynamic/moorings.
#pragma once

#include "resultfiles/hdf5/hdf5_file.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Writes nothing unless the vessel floats.
void write_moored_dynamics(DatasetSink& file, const DynamicResults& results);

/// Reads the data of write_moored_dynamics, bit for bit.
void read_moored_dynamics(const Hdf5Reader& file, DynamicResults& results);

}  // namespace overbend
