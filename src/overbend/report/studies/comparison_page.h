/// The page of a comparison: variants of one model beside each other.
#pragma once

#include <filesystem>
#include <string>

#include "report/page/page.h"
#include "results/comparison_results.h"
#include "results/static_results.h"

namespace overbend {

/// The whole page. `statics` are those of the first variant, `model_text` is the model as the user wrote it.
Document comparison_document(const StaticResults& statics, const Comparison& comparison, const std::string& model_text);

/// Writes it, beside its place first and then renamed. Throws std::runtime_error where that fails.
void write_comparison_page(const StaticResults& statics, const Comparison& comparison, const std::string& model_text,
                           const std::filesystem::path& file);

}  // namespace overbend
