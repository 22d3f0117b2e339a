/// The page on which results of several folders are compared.
#pragma once

#include <filesystem>

#include "report/page/page.h"
#include "results/folder_comparison.h"

namespace overbend {

/// The whole page.
Document folder_comparison_document(const FolderComparison& comparison);

/// Writes it, beside its place first and then renamed. Throws std::runtime_error where that fails.
void write_folder_comparison_page(const FolderComparison& comparison, const std::filesystem::path& file);

}  // namespace overbend
