/// The tables of checks in results.h5.
#pragma once

#include <string>

#include "resultfiles/hdf5/hdf5_file.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Writes /static/checks or /dynamic/checks (`group`): list, inputs, along.
void write_checks(DatasetSink& file, const std::string& group, const CheckTable& table);

/// Reads them back, bit for bit; returns an empty table for a file without checks.
CheckTable read_checks(const Hdf5Reader& file, const std::string& group);

/// Writes /dynamic/design: design values per station.
void write_design(DatasetSink& file, const StationDesign& design);
StationDesign read_design(const Hdf5Reader& file);

}  // namespace overbend
