/// Hull and mooring lines in results.h5: the groups moorings and hull.
#pragma once

#include "resultfiles/hdf5/hdf5_file.h"
#include "results/mooring_results.h"

namespace overbend {

/// Rest and stages; not the hull.
void write_moorings(DatasetSink& file, const MooringResults& results);

/// Gives back what write_moorings wrote, bit for bit; nullopt where there is none.
std::optional<MooringResults> read_moorings(const Hdf5Reader& file);

void write_hull(DatasetSink& file, const HullResults& hull);
std::optional<HullResults> read_hull(const Hdf5Reader& file);

}  // namespace overbend
