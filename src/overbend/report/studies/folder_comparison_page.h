/// The page of the comparison of several result folders.
#pragma once

#include <filesystem>

#include "report/page/page.h"
#include "results/folder_comparison.h"

namespace overbend {

/// Returns the whole page.
Document folder_comparison_document(const FolderComparison& comparison);

/// Writes the page to a temporary file and renames it. Throws std::runtime_error on failure.
void write_folder_comparison_page(const FolderComparison& comparison, const std::filesystem::path& file);

}  // namespace overbend
