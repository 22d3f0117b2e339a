/// The HTML report of an operation on the line: verdict over all stages, figures and tables of the stages, the
/// procedure sheet. See report.h.
#pragma once

#include <filesystem>
#include <string>

#include "base/json.h"
#include "results/operation_results.h"

namespace overbend {

/// A section before those of the stages, such as that of a goal seek.
struct FirstSection {
  std::string html;
  Json data;        ///< Of its figures.
  int figures = 0;  ///< Their number.
};

/// The whole page. `model_text` is the model file as the user wrote it.
std::string operation_report_html(const OperationResults& results, const std::string& model_text,
                                  const FirstSection* first = nullptr);

/// Writes it, beside its place first and then renamed. Throws std::runtime_error where that fails.
void write_operation_report(const OperationResults& results, const std::string& model_text,
                            const std::filesystem::path& file, const FirstSection* first = nullptr);

}  // namespace overbend
