#include "modelfile/reading/json_schema.h"

#include <cmath>

#include "base/json.h"
#include "base/units.h"
#include "modelfile/fields/field_table.h"

namespace overbend {
namespace {

constexpr const char* kQuantityPattern =
    R"(^\s*[-+]?((0|[1-9][0-9]*)(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?\s*(1/)?[^\s0-9+*/.^,()-][^@,:;=&|<>{}]*$)";

/// Pattern of a plain number written in per cent.
constexpr const char* kPercentPattern = R"(^\s*[-+]?((0|[1-9][0-9]*)(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?\s*%\s*$)";

Json make_schema(const FieldNode& node);

/// Adds description and default of a row; the unit of a quantity is included for forms.
void add_description(const Field& field, Json& schema) {
  std::string text = field.text;
  const std::string range = field_range_label(field, field.range);
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

/// Texts of a choice; digits also as a number and `true` also as a boolean, as YAML reads them without quotes.
Json choices_json(const std::vector<std::string>& choices) {
  Json values = choices;
  for (const std::string& word : choices) {
    if (const std::optional<double> number = parse_number(word)) values.push_back(static_cast<int>(*number));
    if (word == "true") values.push_back(true);
  }
  return values;
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
      schema["type"] = {"string", "number", "boolean"};  // YAML reads an unquoted 12 or no as a number or boolean
      schema["minLength"] = 1;
      if (!field.fallback.empty()) schema["default"] = field.fallback;
      break;
  }
  add_description(field, schema);
  return schema;
}

void add_counts(const Field& field, const char* min_key, const char* max_key, Json& schema) {
  if (field.min_items > 0) schema[min_key] = field.min_items;
  if (field.max_items < kMaxItems) schema[max_key] = field.max_items;
}

Json map_schema(const FieldNode& node) {
  Json schema;
  schema["type"] = "object";
  add_description(*node.map, schema);
  if (node.any_name()) {
    schema["additionalProperties"] = make_schema(*node.members.front());
    return schema;
  }
  Json properties = Json::object(), required = Json::array();
  for (const auto& member : node.members) {
    properties[member->key] = make_schema(*member);
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
  add_description(*node.list, schema);
  schema["items"] = make_schema(*node.item);
  add_counts(*node.list, "minItems", "maxItems", schema);
  return schema;
}

Json make_schema(const FieldNode& node) {
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
  schema.update(make_schema(field_tree()));
  // A model contains a pipe, a vessel on lines or floating freely, or free lines.
  schema["anyOf"] = {{{"required", {"vessel"}}}, {{"required", {"lines"}}}};
  schema["dependencies"] = {{"pipe", {"tensioner", "vessel"}}, {"tensioner", {"pipe"}}, {"moorings", {"vessel"}}};
  return json_text(schema, 2) + "\n";
}

}  // namespace overbend
