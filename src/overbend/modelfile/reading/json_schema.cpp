#include "modelfile/reading/json_schema.h"

#include <cmath>

#include "base/json.h"
#include "base/units.h"
#include "modelfile/fields/field_table.h"

namespace overbend {
namespace {

constexpr const char* kQuantityPattern =
    R"(^\s*[-+]?((0|[1-9][0-9]*)(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?\s*(1/)?[^\s0-9+*/.^,()-][^@,:;=&|<>{}]*$)";

/// Of a plain number that is written in per cent.
constexpr const char* kPercentPattern = R"(^\s*[-+]?((0|[1-9][0-9]*)(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?\s*%\s*$)";

Json schema_of(const FieldNode& node);

/// Description and default of a row; quantities name their unit, so that forms can show it.
void add_words(const Field& field, Json& schema) {
  std::string text = field.text;
  const std::string range = range_words(field, field.range);
  if (!field.unit.empty()) text += " [" + dimension_name(field.unit) + ", " + field.show + "]";
  if (!range.empty()) text += " Range: " + range + ".";
  if (!field.fallback_text.empty()) text += " If omitted: " + field.fallback_text + ".";
  schema["description"] = text;
}

void add_bounds(const Field& field, Json& schema) {
  const Range& range = field.range;
  if (std::isfinite(range.low)) schema[range.low_open ? "exclusiveMinimum" : "minimum"] = range.low;
  if (std::isfinite(range.high)) schema[range.high_open ? "exclusiveMaximum" : "maximum"] = range.high;
}

/// Words of a choice; one of digits also as the number that YAML takes an unquoted one for, `true` as the truth value.
Json choices_json(const std::vector<std::string>& choices) {
  Json words = choices;
  for (const std::string& word : choices) {
    if (const std::optional<double> number = parse_number(word)) words.push_back(static_cast<int>(*number));
    if (word == "true") words.push_back(true);
  }
  return words;
}

Json scalar_schema(const Field& field) {
  Json schema;
  switch (field.kind) {
    case FieldKind::quantity:
      schema["type"] = "string";
      schema["pattern"] = kQuantityPattern;
      schema["x-unit"] = field.show;  // for forms
      schema["examples"] = {field.fallback.empty() ? "1 " + field.show : field.fallback};
      if (!field.fallback.empty()) schema["default"] = field.fallback;
      break;
    case FieldKind::number:
      schema["type"] = {"number", "string"};
      schema["pattern"] = kPercentPattern;
      add_bounds(field, schema);
      if (!field.fallback.empty()) schema["default"] = *parse_number(field.fallback);
      break;
    case FieldKind::integer:
      schema["type"] = "integer";
      add_bounds(field, schema);
      if (!field.fallback.empty()) schema["default"] = std::stoll(field.fallback);
      break;
    case FieldKind::choice:
      if (field.unit.empty()) {
        schema["enum"] = choices_json(field.choices);
      } else {
        schema["anyOf"] = {{{"enum", choices_json(field.choices)}},
                           {{"type", "string"}, {"pattern", kQuantityPattern}, {"x-unit", field.show}}};
      }
      if (!field.fallback.empty()) schema["default"] = field.fallback;
      break;
    case FieldKind::text:
    case FieldKind::map:
    case FieldKind::list:
      schema["type"] = {"string", "number", "boolean"};  // YAML reads an unquoted 12 or no as such
      schema["minLength"] = 1;
      if (!field.fallback.empty()) schema["default"] = field.fallback;
      break;
  }
  add_words(field, schema);
  return schema;
}

void add_counts(const Field& field, const char* least, const char* most, Json& schema) {
  if (field.least > 0) schema[least] = field.least;
  if (field.most < kMaxItems) schema[most] = field.most;
}

Json map_schema(const FieldNode& node) {
  Json schema;
  schema["type"] = "object";
  add_words(*node.map, schema);
  if (node.any_name()) {
    schema["additionalProperties"] = schema_of(*node.members.front());
    return schema;
  }
  Json properties = Json::object(), required = Json::array();
  for (const auto& member : node.members) {
    properties[member->key] = schema_of(*member);
    if (member->first().required) required.push_back(member->key);
  }
  schema["properties"] = properties;
  if (!required.empty()) schema["required"] = required;
  schema["additionalProperties"] = false;
  add_counts(*node.map, "minProperties", "maxProperties", schema);
  return schema;
}

Json list_schema(const FieldNode& node) {
  Json schema;
  schema["type"] = "array";
  add_words(*node.list, schema);
  schema["items"] = schema_of(*node.item);
  add_counts(*node.list, "minItems", "maxItems", schema);
  return schema;
}

Json schema_of(const FieldNode& node) {
  std::vector<Json> shapes;
  if (node.scalar != nullptr) shapes.push_back(scalar_schema(*node.scalar));
  if (node.map != nullptr) shapes.push_back(map_schema(node));
  if (node.list != nullptr) shapes.push_back(list_schema(node));
  if (shapes.size() == 1) return shapes.front();
  Json schema;
  schema["anyOf"] = shapes;
  return schema;
}

}  // namespace

std::string json_schema() {
  Json schema;
  schema["$schema"] = "http://json-schema.org/draft-07/schema#";
  schema["title"] = "Overbend model file";
  schema.update(schema_of(field_tree()));
  // A model is one of a pipe, of a vessel on lines or floating free, or of lines by themselves.
  schema["anyOf"] = {{{"required", {"vessel"}}}, {{"required", {"lines"}}}};
  schema["dependencies"] = {{"pipe", {"tensioner", "vessel"}}, {"tensioner", {"pipe"}}, {"moorings", {"vessel"}}};
  return json_text(schema, 2) + "\n";
}

}  // namespace overbend
