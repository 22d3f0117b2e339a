/// The text of a model for a file in another folder.
#pragma once

#include <filesystem>
#include <string>

namespace overbend {

/// The text with comments and layout kept; files that it names beside `file` are named from `folder`.
std::string moved_text(const std::string& text, const std::string& file, const std::filesystem::path& folder);

}  // namespace overbend
