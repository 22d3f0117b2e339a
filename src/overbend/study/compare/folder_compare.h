/// Two or more folders of results beside each other, whatever made them.
#pragma once

#include <filesystem>
#include <vector>

#include "results/folder_comparison.h"

namespace overbend {

/// Reads folders of static and dynamic analyses, of seeds and of operations on the line, or their results.h5. The first
/// is what the others are compared with. Mixtures are compared on what they share; `notes` say what is left out.
/// Throws std::runtime_error, naming the folder, where one holds no results that can be compared.
FolderComparison compare_folders(const std::vector<std::filesystem::path>& folders);

}  // namespace overbend
