/// Hull and mooring lines in results.h5: the groups moorings and hull.
#pragma once

#include "resultfiles/hdf5/hdf5_file.h"
#include "results/mooring_results.h"

namespace overbend {

/// Writes the equilibrium and the stages, without the hull.
void write_moorings(DatasetSink& file, const MooringResults& results);

/// Returns the data of write_moorings, bit for bit; nullopt without them.
std::optional<MooringResults> read_moorings(const Hdf5Reader& file);

/// Writes the group hull: radiation, damping and steady loads.
void write_hull(DatasetSink& file, const HullResults& hull);
std::optional<HullResults> read_hull(const Hdf5Reader& file);

}  // namespace overbend
