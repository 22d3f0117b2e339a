/// Reads the results of an operation on the line back.
#pragma once

#include <filesystem>
#include <string>

#include "results/operation_results.h"

namespace overbend {

/// Results of an operation with its model file.
struct StoredOperation {
  OperationResults results;
  std::string model_text;
  std::string model_file;  ///< Path as given by the user.
};

/// Returns true if results.h5 contains the stages of an operation on the line.
bool has_lay_operation(const std::filesystem::path& h5);

/// Returns the data of write_operation_files, bit for bit. Throws std::runtime_error that names the missing dataset if
/// the file has another layout.
StoredOperation read_operation_results(const std::filesystem::path& h5);

}  // namespace overbend
