#include "base/json.h"

#include <fstream>
#include <sstream>
#include <utility>

namespace overbend {

Json read_json(const std::string& text) {
  return Json::parse(text);
}

Json read_json_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {};
  std::ostringstream text;
  text << stream.rdbuf();
  Json json = Json::parse(text.str(), nullptr, false);
  return json.is_discarded() ? Json() : json;
}

std::optional<Json> read_json_object(const std::filesystem::path& file) {
  Json json = read_json_file(file);
  return json.is_object() ? std::optional(std::move(json)) : std::nullopt;
}

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace overbend
