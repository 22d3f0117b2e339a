/// What results hang on, in summary.json, sensitivities.csv and results.h5.
#pragma once

#include <optional>
#include <string>

#include "base/json.h"
#include "results/sensitivity_results.h"

namespace overbend {

class Hdf5Reader;
class DatasetSink;

/// The key `sensitivities`: inputs, results, `derivatives` with a row for each result and a column for each input in
/// SI, and those of them that hold on one side only.
Json sensitivities_json(const SensitivityResults& sensitivities);

/// A line for each result and input.
std::string sensitivities_table(const SensitivityResults& sensitivities);

void write_sensitivities(DatasetSink& file, const SensitivityResults& sensitivities);
/// What was written; nothing where the file has none.
std::optional<SensitivityResults> read_sensitivities(const Hdf5Reader& file);

}  // namespace overbend
