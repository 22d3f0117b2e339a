/// The report of an operation on the line: verdict over all stages, figures and tables of the stages, the
/// procedure sheet. See report.h.
#pragma once

#include <filesystem>
#include <string>

#include "report/page/page.h"
#include "results/operation_results.h"

namespace overbend {

/// A section before those of the stages, such as that of a goal seek.
struct FirstSection {
  Blocks body;
  Json data;  ///< Data of its figures.
};

/// Returns the whole page. `model_text` is the model file as the user wrote it.
Document operation_report_document(const OperationResults& results, const std::string& model_text,
                                   const FirstSection* first = nullptr);

/// Writes the page to a temporary file and renames it. Throws std::runtime_error on failure.
void write_operation_report(const OperationResults& results, const std::string& model_text,
                            const std::filesystem::path& file, const FirstSection* first = nullptr);

}  // namespace overbend
