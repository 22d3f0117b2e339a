/// Hull and mooring lines in results.h5: the groups moorings and hull.
#pragma once

#include "resultfiles/hdf5/hdf5_file.h"
#include "results/mooring_results.h"

namespace overbend {

/// Rest and stages; not the hull.
void write_moorings(DatasetSink& file, const MooringResults& results);

/// Gives back what write_moorings wrote, bit for bit; nullopt where there is none.
std::optional<MooringResults> read_moorings(const Hdf5Reader& file);

/// All of a hull and its lines without a pipe, with the heading.
void write_mooring_groups(DatasetSink& file, const MooringResults& results, const Description& description);

void write_hull(DatasetSink& file, const HullResults& hull);
std::optional<HullResults> read_hull(const Hdf5Reader& file);

}  // namespace overbend
