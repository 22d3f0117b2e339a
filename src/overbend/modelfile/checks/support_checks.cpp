#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "base/text.h"
#include "model/description/description_enum_names.h"
#include "modelfile/checks/box_row_checks.h"
#include "modelfile/checks/model_checks.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {
namespace {

std::string file_path(Structure structure) {
  return std::string("supports.") + enum_name(structure);
}

/// Returns "box 'ramp 3'" or, without a name, "the box before".
std::string box_label(const FieldValue& box) {
  const auto name = box.get_text("name");
  return name ? "box '" + for_display(*name) + "'" : "the box before";
}

/// Support before a box, from the tensioner astern.
struct PreviousSupport {
  double x = 0.0;
  std::string shown, label;
};

void check_beyond(Checker& check, const FieldValue& x, const std::optional<PreviousSupport>& before) {
  if (before && x.number <= before->x) {
    check.error(x, x.shown, "more than " + before->shown + " of " + before->label,
                "supports are listed astern: x increases from box to box");
  }
}

/// Returns the boxes of a ramp, a stinger, or all sections of a stinger.
std::vector<const FieldValue*> find_boxes(const FieldValue& structure) {
  std::vector<const FieldValue*> boxes;
  for (const FieldValue& box : Checker::items(structure, "boxes")) boxes.push_back(&box);
  for (const FieldValue& section : Checker::items(structure, "sections")) {
    for (const FieldValue& box : Checker::items(section, "boxes")) boxes.push_back(&box);
  }
  return boxes;
}

/// Checks that x increases from the tensioner to the boxes of the ramp and the stinger.
void check_order(Checker& check) {
  std::optional<PreviousSupport> before;
  if (const FieldValue* tensioner = check.root().find("tensioner.x")) {
    before = PreviousSupport{tensioner->number, tensioner->shown, "the tensioner"};
  }
  for (const auto& [structure, word] : kEnumNames<Structure>) {
    const FieldValue* group = check.root().find(file_path(structure));
    if (group == nullptr) continue;
    for (const FieldValue* box : find_boxes(*group)) {
      const FieldValue* x = box->find("x");
      if (x == nullptr) continue;
      check_beyond(check, *x, before);
      before = PreviousSupport{x->number, x->shown, box_label(*box)};
    }
    if (const FieldValue* x = group->find("boxes.first.x")) {
      check_beyond(check, *x, before);
      if (const std::optional<BoxPlace> end = end_of_row(check.root(), *group)) {
        before = PreviousSupport{end->x, fmt::format("{:.2f} m", end->x), "the last box of the row"};
      }
    }
  }
}

/// Generated boxes are named ramp 1, 2, ...: reports a box of the other structure with the same name.
void check_row_names(Checker& check, const FieldValue& group, const char* word, std::map<std::string, int>& lines) {
  const FieldValue* row = find_box_row(group);
  const std::int64_t count = row != nullptr ? row->get_integer("count").value_or(0) : 0;
  for (std::int64_t i = 1; i <= count; ++i) {
    const std::string name = std::string(word) + " " + std::to_string(i);
    const auto [first, fresh] = lines.emplace(name, row->line);
    if (fresh) continue;
    check.error(*row, "a row with a box named '" + name + "'", "a unique name",
                "it is already used in line " + std::to_string(first->second));
  }
}

void check_names(Checker& check) {
  std::map<std::string, int> lines;
  for (const auto& [structure, word] : kEnumNames<Structure>) {
    const FieldValue* group = check.root().find(file_path(structure));
    if (group == nullptr) continue;
    check_row_names(check, *group, word, lines);
    int number = 0;
    for (const FieldValue* box : find_boxes(*group)) {
      const FieldValue* name_value = box->find("name");
      const std::string name =
          name_value != nullptr ? name_value->text : std::string(word) + " " + std::to_string(number + 1);
      ++number;
      const auto [first, fresh] = lines.emplace(name, box->line);
      if (fresh) continue;
      check.error(name_value != nullptr ? *name_value : *box, "the name '" + for_display(name) + "' again",
                  "a unique name", "it is already used in line " + std::to_string(first->second));
    }
  }
}

/// Warns of a radius given for listed boxes, which are placed by their coordinates only.
void check_radius(Checker& check, const FieldValue& structure) {
  const FieldValue* radius = structure.find("radius");
  if (radius == nullptr || find_boxes(structure).empty()) return;
  check.warn(*radius,
             "a radius of " + radius->shown +
                 " is not used for listed boxes, which are placed by their x and z only; static." + structure.key +
                 "_fitted_radius of the results is the radius of the circle fitted to them; remove the key, or replace "
                 "the list by a row of boxes: {count, spacing, first}");
}

std::vector<std::string> roller_kinds(const FieldValue& root) {
  std::vector<std::string> names;
  if (const FieldValue* rollers = root.find("rollers")) {
    for (const FieldValue& kind : rollers->children) names.push_back(kind.key);
    names.insert(names.end(), rollers->rejected_keys.begin(), rollers->rejected_keys.end());
  }
  return names;
}

void check_kind_is_known(Checker& check, const FieldValue& roller, const std::vector<std::string>& kinds) {
  if (std::find(kinds.begin(), kinds.end(), roller.text) != kinds.end()) return;
  if (kinds.empty()) {
    check.error(roller, "the unknown type of roller " + roller.shown, "a type defined under rollers",
                "there is none; add the group rollers");
    return;
  }
  const std::string near = nearest_word(roller.text, kinds);
  check.error(roller, "the unknown type of roller " + roller.shown, join_choices(kinds),
              near.empty() ? "" : "did you mean '" + near + "'?");
}

/// `box` may represent a whole row.
void check_rows_have_room(Checker& check, const FieldValue& box, const FieldValue& structure) {
  const FieldValue* own_rows = box.find("rows");
  const FieldValue* rows = own_rows != nullptr ? own_rows : structure.find("rows");
  const FieldValue* length = box.find("length");
  if (rows == nullptr || length == nullptr || rows->integer <= 1 || length->number > 0.0) return;
  if (length->given) {
    check.error(*length, length->shown, "more than 0 m for " + std::to_string(rows->integer) + " rows");
  } else {
    check.missing(box, "length",
                  "a length with its unit: " + std::to_string(rows->integer) + " rows are distributed over its length");
  }
}

void check_rollers(Checker& check) {
  if (check.root().find("rollers") == nullptr && check.root().mentions("rollers")) return;
  const std::vector<std::string> kinds = roller_kinds(check.root());
  std::set<std::string> used;
  for (const auto& [structure, word] : kEnumNames<Structure>) {
    const FieldValue* group = check.root().find(file_path(structure));
    if (group == nullptr) continue;
    const FieldValue* common = group->find("roller");
    if (common != nullptr) {
      used.insert(common->text);
      check_kind_is_known(check, *common, kinds);
    }
    if (const FieldValue* row = find_box_row(*group)) {
      if (!group->mentions("roller")) {
        check.missing(*group, "roller", "the name of a type of roller row", "all boxes of a row have the same rollers");
      }
      check_rows_have_room(check, *row, *group);
    }
    for (const FieldValue* box : find_boxes(*group)) {
      const FieldValue* own_roller = box->find("roller");
      if (own_roller != nullptr) {
        used.insert(own_roller->text);
        check_kind_is_known(check, *own_roller, kinds);
      } else if (!group->mentions("roller") && !box->mentions("roller")) {
        check.missing(*box, "roller", "the name of a type of roller row",
                      "give it here or once for all boxes under " + file_path(structure));
      }
      check_rows_have_room(check, *box, *group);
    }
  }
  const FieldValue* rollers = check.root().find("rollers");
  if (rollers == nullptr) return;
  for (const FieldValue& kind : rollers->children) {
    if (used.count(kind.key) == 0) check.warn(kind, "no box uses this type of roller", FindingCode::unused_input);
  }
}

}  // namespace

void check_supports(const FieldValue& root, const std::string& file, Diagnostics& diagnostics) {
  Checker check(root, file, diagnostics);
  check_order(check);
  check_names(check);
  check_rollers(check);
  for (const auto& [structure, word] : kEnumNames<Structure>) {
    const FieldValue* group = root.find(file_path(structure));
    if (group == nullptr) continue;
    check_radius(check, *group);
    check_box_row(check, *group);
  }
  check_stinger(check);
  check_stinger_settings(check);
}

}  // namespace overbend
