/// The page of a comparison of variants of one model.
#pragma once

#include <filesystem>
#include <string>

#include "report/page/page.h"
#include "results/comparison_results.h"
#include "results/static_results.h"

namespace overbend {

/// Returns the whole page. `statics` are those of the first variant, `model_text` is the model as the user wrote it.
Document comparison_document(const StaticResults& statics, const Comparison& comparison, const std::string& model_text);

/// Writes the page to a temporary file and renames it. Throws std::runtime_error on failure.
void write_comparison_page(const StaticResults& statics, const Comparison& comparison, const std::string& model_text,
                           const std::filesystem::path& file);

}  // namespace overbend
