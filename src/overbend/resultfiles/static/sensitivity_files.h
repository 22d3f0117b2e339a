/// Sensitivities in summary.json, sensitivities.csv and results.h5.
#pragma once

#include <optional>
#include <string>

#include "base/json.h"
#include "results/sensitivity_results.h"

namespace overbend {

class Hdf5Reader;
class DatasetSink;

/// Returns the key `sensitivities`: inputs, results, `derivatives` with a row for each result and a column for each
/// input in SI, and the one-sided ones.
Json sensitivities_json(const SensitivityResults& sensitivities);

/// Returns a table with a row for each result and input.
std::string sensitivities_table(const SensitivityResults& sensitivities);

/// Writes the sensitivities as datasets, in SI.
void write_sensitivities(DatasetSink& file, const SensitivityResults& sensitivities);
/// Reads the sensitivities; nothing if the file has none.
std::optional<SensitivityResults> read_sensitivities(const Hdf5Reader& file);

}  // namespace overbend
