/// Translates OrcaFlex text data files into models.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "orcaflex/account.h"
#include "orcaflex/document.h"

namespace overbend::orcaflex {

struct ImportOptions {
  std::optional<double> yield_stress;  ///< Yield stress of pipes without one in the file [Pa].
  std::filesystem::path model_folder;  ///< Folder of the model, from which it refers to the files with RAOs.
  bool is_one_folder = false;          ///< The model finds all files in its own folder, wherever they were read.
  std::string title;                   ///< Title of the model; empty: the name of the file.
};

struct ImportedModel {
  std::string text;  ///< Model as YAML.
  Account account;
};

/// Translates an OrcaFlex file and the files that it includes. Returns nothing if there are errors, which go to
/// `diagnostics` with file and line: unknown units, variable data, ambiguous or damaged data.
///
/// Frames: the file's X is east and Y north. The vessel's origin at the water line is midship; its stern shoe is half
/// the length of its type behind. A support's position is the axis of its cylinder (OrcaFlex help, "Supports").
std::optional<ImportedModel> import_orcaflex(const std::filesystem::path& file, const ImportOptions& options,
                                             Diagnostics& diagnostics, const FileText& file_text = read_file_text);

}  // namespace overbend::orcaflex
