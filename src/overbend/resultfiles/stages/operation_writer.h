/// Writes the results of the stages of an operation on the line: summary.json, stages.csv, results.h5.
#pragma once

#include <filesystem>
#include <string>

#include "model/description/description.h"
#include "resultfiles/hdf5/dataset_sink.h"
#include "results/operation_results.h"

namespace overbend {

/// Returns the text of summary.json: operation.stages, each with the keys of `static` or its failure, in SI.
std::string operation_summary(const OperationResults& results);

/// Writes the group /operation with a group per stage.
void write_operation_groups(DatasetSink& file, const OperationResults& results);

/// Writes results.h5: groups model and operation, the latter with a group per stage with the tables of a static
/// analysis.
void write_operation_hdf5(const OperationResults& results, const Description& description,
                          const std::filesystem::path& file);

/// Writes all files into an existing folder. Throws std::runtime_error if a quantity is not finite (and names it) or a
/// file cannot be written.
void write_operation_files(const OperationResults& results, const Description& description,
                           const std::filesystem::path& folder);

}  // namespace overbend
