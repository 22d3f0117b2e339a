/// The page of a lay table: its curves and its rows.
#pragma once

#include <filesystem>
#include <string>

#include "report/page/page.h"
#include "results/lay_table_results.h"

namespace overbend {

/// Returns the whole page. `model_text` is the model as the user wrote it.
Document lay_table_document(const LayTable& table, const std::string& model_text);

/// Writes the page to a temporary file and renames it. Throws std::runtime_error on failure.
void write_lay_table_page(const LayTable& table, const std::string& model_text, const std::filesystem::path& file);

}  // namespace overbend
