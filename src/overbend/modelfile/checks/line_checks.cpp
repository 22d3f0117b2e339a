#include "modelfile/checks/line_checks.h"

#include <algorithm>
#include <map>

#include "base/text.h"
#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

/// Keys that define a type by its numbers.
constexpr const char* kNumbers[] = {"diameter", "mass", "weight_in_air", "weight_submerged", "axial_stiffness"};
constexpr const char* kKinds[] = {"wire_rope", "chain"};
/// Keys of a type that are allowed in a segment.
constexpr const char* kAny[] = {
    "wire_rope",        "chain",           "diameter",          "mass",          "weight_in_air",
    "weight_submerged", "axial_stiffness", "bending_stiffness", "breaking_load", "friction"};

void need(Checker& check, const FieldValue& group, const std::string& key, const std::string& expected,
          const std::string& hint) {
  if (!group.mentions(key)) check.missing(group, key, expected, hint);
}

/// Checks that a segment either names a type or has properties of its own.
void check_segment(Checker& check, const FieldValue& segment, const std::vector<std::string>& types,
                   std::set<std::string>& used) {
  const FieldValue* name = segment.find("type");
  const auto* own_key = std::find_if(std::begin(kAny), std::end(kAny), [&](const char* key) {
    const FieldValue* value = segment.find(key);
    return value != nullptr && value->given;
  });
  if (name != nullptr) {
    used.insert(name->text);
    check_name(check, *name, types, "moorings.types");
    if (const FieldValue* steel = segment.find("steel"); steel != nullptr && steel->given) {
      check.error(*steel, "steel and the type " + name->shown, "one of them", "a segment is either pipe or of a type");
    }
    if (own_key != std::end(kAny)) {
      check.error(*segment.find(*own_key), "a property in addition to the type " + name->shown,
                  "either a type or properties in place", "put the property into the type");
    }
  } else if (segment.mentions("steel")) {
    if (own_key != std::end(kAny)) {
      check.error(*segment.find(*own_key), "a property of a cable in a segment with steel",
                  "only steel, coatings and contents");
    }
  } else if (!segment.mentions("type")) {
    check_line_type(check, segment);
  }
}

/// Returns the total length of the segments; empty if one has no length.
std::optional<double> total_length(const std::vector<FieldValue>& segments) {
  double total = 0.0;
  for (const FieldValue& segment : segments) {
    const auto length = segment.get_number("length");
    if (!length) return std::nullopt;
    total += *length;
  }
  return total;
}

void check_points(Checker& check, const FieldValue& line, std::optional<double> length) {
  for (const char* kind : {"clumps", "buoys"}) {
    for (const FieldValue& point : Checker::items(line, kind)) {
      const FieldValue* arc_length = point.find("at");
      if (arc_length != nullptr && length && arc_length->number >= *length) {
        check.error(*arc_length, arc_length->shown,
                    "less than the line's length, " + format_quantity(*length, "m", "m"));
      }
      const bool cylinder = point.get_word<BuoyShape>("shape") == BuoyShape::cylinder;
      if (cylinder && point.get_number("height").value_or(0.0) == 0.0 && !point.mentions("height")) {
        check.missing(point, "height", "a length with its unit", "required for a cylinder");
      }
    }
  }
}

/// Checks the length of the only segment, or of the first of several.
void check_first_length(Checker& check, const FieldValue& line, const FieldValue& holder, const std::string& tension) {
  const bool open = !tension.empty() && line.mentions(tension);
  const FieldValue* length = holder.find("length");
  if (open && length != nullptr) {
    check.error(*length, "a length and a " + tension, "one of them", "the length follows from the " + tension);
  }
  if (!open && !holder.mentions("length")) {
    check.missing(holder, "length", "a length with its unit",
                  tension.empty() ? "" : "or give the line's " + tension + ", from which it follows");
  }
}

}  // namespace

bool is_given(const FieldValue& root, const std::string& path) {
  const FieldValue* value = root.find(path);
  return value != nullptr ? value->given : root.mentions(path);
}

std::optional<double> level_bed(const FieldValue& root) {
  const auto depth = root.get_number("environment.water_depth");
  const bool shaped = is_given(root, "environment.seabed.profile") || is_given(root, "environment.seabed.bathymetry");
  if (!depth || shaped || root.get_number("environment.seabed.slope").value_or(0.0) != 0.0) return std::nullopt;
  return depth;
}

std::vector<std::string> names_below(const FieldValue& root, const std::string& group) {
  std::vector<std::string> names;
  if (const FieldValue* found = root.find(group)) {
    for (const FieldValue& item : found->children) names.push_back(item.key);
    names.insert(names.end(), found->rejected_keys.begin(), found->rejected_keys.end());
  }
  return names;
}

namespace {

std::vector<std::string> item_names(const std::vector<FieldValue>& items, const std::string& kind) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < items.size(); ++i) {
    names.push_back(items[i].get_text("name").value_or(kind + " " + std::to_string(i + 1)));
  }
  return names;
}

}  // namespace

std::vector<std::string> line_names(const std::vector<FieldValue>& lines) {
  return item_names(lines, "line");
}

std::vector<std::string> body_names(const FieldValue& root) {
  return item_names(Checker::items(root, "bodies"), "body");
}

void check_name(Checker& check, const FieldValue& name, const std::vector<std::string>& known,
                const std::string& where) {
  if (std::find(known.begin(), known.end(), name.text) != known.end()) return;
  const std::string near = nearest_word(name.text, known);
  check.error(name, "the unknown name " + name.shown, known.empty() ? "a name under " + where : join_choices(known),
              known.empty()  ? "there is none; add the group " + where
              : near.empty() ? ""
                             : "did you mean '" + near + "'?");
}

void check_unique_names(Checker& check, const std::vector<FieldValue>& items, const std::string& kind) {
  std::map<std::string, int> lines;
  int number = 0;
  for (const FieldValue& item : items) {
    const FieldValue* name_value = item.find("name");
    const std::string name = name_value != nullptr ? name_value->text : kind + " " + std::to_string(number + 1);
    ++number;
    const auto [first, fresh] = lines.emplace(name, item.line);
    if (fresh) continue;
    check.error(name_value != nullptr ? *name_value : item, "the name '" + for_display(name) + "' again",
                "a unique name", "it is already used in line " + std::to_string(first->second));
  }
}

void check_line_type(Checker& check, const FieldValue& type) {
  int kinds = 0;
  for (const char* kind : kKinds) kinds += type.mentions(kind) ? 1 : 0;
  const FieldValue* chain = type.find("chain");
  if (kinds == 2 && chain != nullptr) check.error(*chain, "wire_rope and chain", "one of them");
  if (kinds > 0) {
    for (const char* key : {"diameter", "mass"}) {
      const FieldValue* number = type.find(key);
      if (number != nullptr) check.error(*number, "a number together with wire_rope or chain", "one of them");
    }
    return;
  }
  const std::string hint = "or give wire_rope or chain with its diameter";
  const bool any =
      std::any_of(std::begin(kNumbers), std::end(kNumbers), [&](const char* key) { return type.mentions(key); });
  if (!any) {
    check.missing(type, "diameter", "wire_rope, chain or the numbers of a line",
                  "a line needs a diameter, weight_in_air or mass, and axial_stiffness");
    return;
  }
  need(check, type, "diameter", "a length with its unit", hint);
  need(check, type, "axial_stiffness", "a force with its unit", hint);
  const bool mass = type.mentions("mass"), weight = type.mentions("weight_in_air");
  if (!mass && !weight) check.missing(type, "weight_in_air", "a force per length with its unit", "or give mass");
  if (mass && weight && type.find("mass") != nullptr) {
    check.error(*type.find("mass"), "mass and weight_in_air", "one of them");
  }
}

void check_line_body(Checker& check, const FieldValue& line, const std::string& tension, std::set<std::string>& used) {
  const std::vector<std::string> types = names_below(check.root(), "moorings.types");
  const std::vector<FieldValue>& segments = Checker::items(line, "segments");
  if (!line.mentions("segments")) {
    if (line.find("type") != nullptr) {
      used.insert(line.find("type")->text);
      check_name(check, *line.find("type"), types, "moorings.types");
    } else if (!line.mentions("type")) {
      check.missing(line, "type", "the name of a type of line", "or give segments");
    }
    check_first_length(check, line, line, tension);
    check_points(check, line, line.get_number("length"));
    return;
  }
  for (const char* key : {"type", "length"}) {
    const FieldValue* own_value = line.find(key);
    if (own_value != nullptr) check.error(*own_value, std::string("segments and the line's own ") + key, "one of them");
  }
  for (const FieldValue& segment : segments) check_segment(check, segment, types, used);
  if (segments.empty()) return;
  check_first_length(check, line, segments.front(), tension);
  for (std::size_t i = 1; i < segments.size(); ++i) {
    need(check, segments[i], "length", "a length with its unit",
         "only the length of the first segment follows from a tension");
  }
  check_points(check, line, total_length(segments));
}

void check_line_types(Checker& check, const std::set<std::string>& used) {
  const FieldValue* types = check.root().find("moorings.types");
  if (types == nullptr) return;
  for (const FieldValue& type : types->children) {
    check_line_type(check, type);
    if (used.count(type.key) == 0) check.warn(type, "no line uses this type", FindingCode::unused_input);
  }
}

}  // namespace overbend
