/// A floating hull and its mooring lines over time in results.h5: /dynamic/vessel, /dynamic/moorings.
#pragma once

#include "resultfiles/hdf5/hdf5_file.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Writes nothing where the vessel does not float.
void write_moored_dynamics(DatasetSink& file, const DynamicResults& results);

/// Gives back what write_moored_dynamics wrote, bit for bit.
void read_moored_dynamics(const Hdf5Reader& file, DynamicResults& results);

}  // namespace overbend
