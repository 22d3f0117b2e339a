/// Reads the results of an operation on the line back.
#pragma once

#include <filesystem>
#include <string>

#include "results/operation_results.h"

namespace overbend {

/// Results of an operation with the model file they came from.
struct StoredOperation {
  OperationResults results;
  std::string model_text;
  std::string model_file;  ///< Its path as it was given.
};

/// Whether results.h5 is one of the stages of an operation on the line.
bool has_lay_operation(const std::filesystem::path& h5);

/// Gives back what write_operation_files wrote, bit for bit. Throws std::runtime_error that says what is missing where
/// the file is none of ours.
StoredOperation read_operation_results(const std::filesystem::path& h5);

}  // namespace overbend
