#include "modelfile/reference_page.h"

#include "base/text.h"
#include "base/units.h"
#include "modelfile/field_table.h"

namespace overbend {
namespace {

constexpr const char* kHead =
    R"(# The model file

Made by `overbend schema --reference` from the program's table of keys; change it there.

A model is a YAML text. A dimensional value is a number and a unit: `406.4 mm`, `16 in`, `250 kN`, `55 kip`, `12 ksi`, `30 deg`.
Any unit of the right dimension will do; a missing one is an error, also for 0. Plain numbers (coefficients, counts) take no
unit. The decimal sign is a point. Every key of this page may stand in a file, no other may: `overbend check MODEL.yaml` names
each fault with its line. `overbend schema` prints the same as JSON Schema, which editors use to complete and check while typing.

Frames: vessel positions count from midship at the water line, x forward and z up. Tensioner, ramp and stinger count from the
stern shoe, X astern and Z up. Azimuths go clockwise from north.

In the tables, `[]` stands for each item of a list and `*` for a name of your own. "required" holds where the group around it
is given.
)";

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '|' ? std::string("\\|") : std::string(1, c);
  return safe;
}

std::string kind_cell(const Field& field) {
  switch (field.kind) {
    case FieldKind::quantity:
      return dimension_name(field.unit) + " (" + field.show + ")";
    case FieldKind::number:
      return "number";
    case FieldKind::integer:
      return "whole number";
    case FieldKind::choice:
      return "`" + join_words(field.choices, "or") + "`";
    case FieldKind::map:
      return "group";
    case FieldKind::list:
      return "list";
    case FieldKind::text:
      break;
  }
  return "text";
}

std::string fallback_cell(const Field& field) {
  if (field.required) return "**required**";
  if (!field.fallback.empty()) return "`" + field.fallback + "`";
  return field.fallback_text;
}

std::string range_cell(const Field& field) {
  if (field.kind == FieldKind::list || field.kind == FieldKind::map) {
    if (field.least > 0 && field.least == field.most) return "exactly " + std::to_string(field.least);
    return field.least > 0 ? "at least " + std::to_string(field.least) : "";
  }
  return range_words(field, field.range);
}

std::string row(const Field& field) {
  return "| `" + field.path + "` | " + kind_cell(field) + " | " + fallback_cell(field) + " | " + range_cell(field) +
         " | " + escaped(field.text) + " |\n";
}

std::string top_key(const Field& field) {
  return field.path.substr(0, field.path.find_first_of(".["));
}

}  // namespace

std::string reference_page() {
  std::string page = kHead;
  std::string section;
  for (const Field& field : field_table()) {
    const bool alone = field.kind != FieldKind::map && field.path == top_key(field);
    const std::string key = alone ? "Head" : top_key(field);
    if (key != section) {
      section = key;
      page += "\n## " + section + "\n\n| key | kind (unit) | left out | range | meaning |\n|---|---|---|---|---|\n";
    }
    page += row(field);
  }
  return page;
}

}  // namespace overbend
