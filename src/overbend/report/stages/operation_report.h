/// The HTML report of an operation on the line: verdict over all stages, figures and tables of the stages, the
/// procedure sheet. See report.h.
#pragma once

#include <filesystem>
#include <string>

#include "results/operation_results.h"

namespace overbend {

/// The whole page. `model_text` is the model file as the user wrote it.
std::string operation_report_html(const OperationResults& results, const std::string& model_text);

/// Writes it, beside its place first and then renamed. Throws std::runtime_error where that fails.
void write_operation_report(const OperationResults& results, const std::string& model_text,
                            const std::filesystem::path& file);

}  // namespace overbend
