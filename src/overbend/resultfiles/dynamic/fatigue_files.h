/// Fatigue of welds in the files of a run.
#pragma once

#include <string>

#include "resultfiles/hdf5/hdf5_file.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Rates along the line by spot: fatigue.csv.
std::string fatigue_table(const DynamicResults& results);

/// Groups /dynamic/fatigue; nothing where the run has no fatigue.
void write_fatigue(DatasetSink& file, const DynamicResults& results);
void read_fatigue(const Hdf5Reader& file, DynamicResults& results);

}  // namespace overbend
