#include "modelfile/fields/seek_values.h"

#include "base/result_path.h"
#include "base/units.h"
#include "modelfile/fields/field_table.h"
#include "modelfile/schema/scalar_row.h"
#include "resultfiles/summary/named_results.h"

namespace overbend {

const Field* scalar_row(const std::string& key) {
  const auto parts = split_result_path(key);
  if (!parts) return nullptr;
  const FieldNode* node = &field_tree();
  for (const PathPart& part : *parts) {
    const bool named = part.item && node->item == nullptr && node->any_name();  // "lengths[davit 1]"
    node = part.item && !named ? node->item.get() : node->member(part.text);
    if (node == nullptr) return nullptr;
  }
  return node->scalar;
}

const Field* varied_row(const std::string& key) {
  const Field* row = scalar_row(key);
  const bool number = row != nullptr && (row->kind == FieldKind::quantity || row->kind == FieldKind::number);
  return number ? row : nullptr;
}

std::string row_unit(const Field& row) {
  return row.kind == FieldKind::quantity ? row.unit : "1";
}

std::optional<Field> result_row(const std::string& result) {
  const std::optional<std::string> unit = result_unit(result);
  if (!unit) return std::nullopt;
  Field row;
  row.path = result;
  row.kind = *unit == "1" ? FieldKind::number : FieldKind::quantity;
  row.unit = *unit;
  row.show = usual_units(*unit).empty() ? "" : usual_units(*unit).front();
  return row;
}

ScalarReading read_row_value(const std::string& text, const Field& row) {
  YamlNode node;
  node.kind = YamlNode::Kind::scalar;
  node.text = text;
  if (row.kind == FieldKind::number) {
    const QuantityReading percent = parse_quantity(text, "1");
    if (percent.value) node.text = format_number(*percent.value, 17);
  }
  ScalarReading reading = read_scalar(node, row);
  if (reading.value) reading.value->shown = "'" + text + "'";
  return reading;
}

}  // namespace overbend
