/// OrcaFlex text data files (.yml): their groups, with those of the files that they include.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/yaml_document.h"

namespace overbend::orcaflex {

/// Group at the top of a file, such as General or Lines.
struct Group {
  std::string name;
  std::string file;  ///< File with the group, for messages.
  YamlNode content;
};

struct Document {
  std::vector<Group> groups;
  std::vector<std::filesystem::path> files;  ///< Files read, the named one first.
};

/// Returns the text of a file; nothing if it cannot be read.
using FileText = std::function<std::optional<std::string>(const std::filesystem::path&)>;

/// Reads a file of the disk of at most 64 MB.
std::optional<std::string> read_file_text(const std::filesystem::path& file);

/// Reads `file` and the files that it names by `includefile`, relative to the file with the name. Errors go to
/// `diagnostics`: files that cannot be read or include each other, and files that state the changes of another one only
/// (BaseFile, groups with the name of an object, indices in brackets).
Document read_document(const std::filesystem::path& file, const FileText& file_text, Diagnostics& diagnostics);

}  // namespace overbend::orcaflex
