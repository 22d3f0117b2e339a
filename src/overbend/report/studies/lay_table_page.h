/// The page of a lay table: its curves and its rows.
#pragma once

#include <filesystem>
#include <string>

#include "report/page/page.h"
#include "results/lay_table_results.h"

namespace overbend {

/// The whole page. `model_text` is the model as the user wrote it.
Document lay_table_document(const LayTable& table, const std::string& model_text);

/// Writes it, beside its place first and then renamed. Throws std::runtime_error where that fails.
void write_lay_table_page(const LayTable& table, const std::string& model_text, const std::filesystem::path& file);

}  // namespace overbend
