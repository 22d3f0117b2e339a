#include "modelfile/schema/field_value.h"

#include <algorithm>

namespace overbend {

const FieldValue* FieldValue::find(const std::string& below) const {
  const FieldValue* value = this;
  std::size_t start = 0;
  while (start <= below.size()) {
    const std::size_t dot = std::min(below.find('.', start), below.size());
    const std::string name = below.substr(start, dot - start);
    const auto found = std::find_if(value->children.begin(), value->children.end(),
                                    [&](const FieldValue& child) { return child.key == name; });
    if (found == value->children.end()) return nullptr;
    value = &*found;
    start = dot + 1;
  }
  return value;
}

bool FieldValue::mentions(const std::string& member) const {
  return find(member) != nullptr ||
         std::find(rejected_keys.begin(), rejected_keys.end(), member) != rejected_keys.end();
}

std::optional<double> FieldValue::get_number(const std::string& below) const {
  const FieldValue* value = find(below);
  if (value == nullptr || value->kind != Kind::number) return std::nullopt;
  return value->number;
}

std::optional<std::int64_t> FieldValue::get_integer(const std::string& below) const {
  const FieldValue* value = find(below);
  if (value == nullptr || value->kind != Kind::integer) return std::nullopt;
  return value->integer;
}

std::optional<std::string> FieldValue::get_text(const std::string& below) const {
  const FieldValue* value = find(below);
  if (value == nullptr || value->kind != Kind::text) return std::nullopt;
  return value->text;
}

}  // namespace overbend
