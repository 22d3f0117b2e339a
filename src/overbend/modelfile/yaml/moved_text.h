/// Text of a model for a file in another folder.
#pragma once

#include <filesystem>
#include <string>

namespace overbend {

/// Returns the text with comments and layout unchanged; files named relative to `file` are renamed relative to
/// `folder`.
std::string moved_text(const std::string& text, const std::string& file, const std::filesystem::path& folder);

}  // namespace overbend
