/// JSON: the one type that the program uses, whose members stand in the order in which they came, and its text, which
/// is read and written here alone (what does it is long, and compiled once).
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace overbend {

using Json = nlohmann::ordered_json;

/// Throws Json::parse_error where the text is no JSON.
Json read_json(const std::string& text);

/// Null where there is no such file, or it is no JSON.
Json read_json_file(const std::filesystem::path& file);

/// Nothing where it holds no object.
std::optional<Json> read_json_object(const std::filesystem::path& file);

/// `indent`: of each level, in spaces; below zero, all in one line. Bytes that are no UTF-8 become the replacement
/// character.
std::string json_text(const Json& json, int indent = -1);

}  // namespace overbend
