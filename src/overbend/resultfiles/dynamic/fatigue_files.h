/// Fatigue of welds in the result files of a run.
#pragma once

#include <string>

#include "resultfiles/hdf5/hdf5_file.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns fatigue.csv: damage rates along the line by spot.
std::string fatigue_table(const DynamicResults& results);

/// Writes the groups /dynamic/fatigue; nothing for a run without fatigue.
void write_fatigue(DatasetSink& file, const DynamicResults& results);
void read_fatigue(const Hdf5Reader& file, DynamicResults& results);

}  // namespace overbend
