/// Comparison of two or more folders of results of any kind.
#pragma once

#include <filesystem>
#include <vector>

#include "results/folder_comparison.h"

namespace overbend {

/// Reads folders of static and dynamic analyses, of seeds and of lay operations, or their results.h5. The first is the
/// reference. Different kinds are compared in the results that they share; `notes` say what is left out. Throws
/// std::runtime_error, naming the folder, if one holds no results that can be compared.
FolderComparison compare_folders(const std::vector<std::filesystem::path>& folders);

}  // namespace overbend
