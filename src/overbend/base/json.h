/// JSON: the type used throughout, which keeps the order of members, and its reading and writing, compiled only once
/// because the library is large.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace overbend {

using Json = nlohmann::ordered_json;

/// Throws Json::parse_error if the text is not JSON.
Json read_json(const std::string& text);

/// Returns null if the file does not exist or is not JSON.
Json read_json_file(const std::filesystem::path& file);

/// Returns nothing if the file does not contain an object.
std::optional<Json> read_json_object(const std::filesystem::path& file);

/// `indent`: spaces per level; negative for a single line. Bytes that are not UTF-8 are replaced by the replacement
/// character.
std::string json_text(const Json& json, int indent = -1);

}  // namespace overbend
