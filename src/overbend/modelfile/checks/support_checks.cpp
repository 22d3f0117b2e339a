#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "base/text.h"
#include "model/description/description_words.h"
#include "modelfile/checks/box_row_checks.h"
#include "modelfile/checks/model_checks.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {
namespace {

std::string path_of(Structure structure) {
  return std::string("supports.") + word_of(structure);
}

/// "box 'ramp 3'" or, without a name, "the box before".
std::string box_words(const FieldValue& box) {
  const auto name = box.get_text("name");
  return name ? "box '" + for_display(*name) + "'" : "the box before";
}

/// The support before a box, from the tensioner astern.
struct Before {
  double x = 0.0;
  std::string shown, words;
};

void check_beyond(Checker& check, const FieldValue& x, const std::optional<Before>& before) {
  if (before && x.number <= before->x) {
    check.error(x, x.shown, "more than " + before->shown + " of " + before->words,
                "supports are listed astern: x increases from box to box");
  }
}

/// Those of a ramp, a stinger, or of all sections of a stinger.
std::vector<const FieldValue*> boxes_of(const FieldValue& structure) {
  std::vector<const FieldValue*> boxes;
  for (const FieldValue& box : Checker::items(structure, "boxes")) boxes.push_back(&box);
  for (const FieldValue& section : Checker::items(structure, "sections")) {
    for (const FieldValue& box : Checker::items(section, "boxes")) boxes.push_back(&box);
  }
  return boxes;
}

/// Boxes run astern: every x beyond the one before, the first beyond the tensioner, the stinger beyond the ramp.
void check_order(Checker& check) {
  std::optional<Before> before;
  if (const FieldValue* tensioner = check.root().find("tensioner.x")) {
    before = Before{tensioner->number, tensioner->shown, "the tensioner"};
  }
  for (const auto& [structure, word] : kWords<Structure>) {
    const FieldValue* group = check.root().find(path_of(structure));
    if (group == nullptr) continue;
    for (const FieldValue* box : boxes_of(*group)) {
      const FieldValue* x = box->find("x");
      if (x == nullptr) continue;
      check_beyond(check, *x, before);
      before = Before{x->number, x->shown, box_words(*box)};
    }
    if (const FieldValue* x = group->find("boxes.first.x")) {
      check_beyond(check, *x, before);
      if (const std::optional<BoxPlace> end = end_of_row(check.root(), *group)) {
        before = Before{end->x, fmt::format("{:.2f} m", end->x), "the last box of the row"};
      }
    }
  }
}

/// The boxes of a row are called ramp 1, 2, ...: a box of the other structure may have taken such a name.
void check_row_names(Checker& check, const FieldValue& group, const char* word, std::map<std::string, int>& lines) {
  const FieldValue* row = box_row_of(group);
  const std::int64_t count = row != nullptr ? row->get_integer("count").value_or(0) : 0;
  for (std::int64_t i = 1; i <= count; ++i) {
    const std::string name = std::string(word) + " " + std::to_string(i);
    const auto [first, fresh] = lines.emplace(name, row->line);
    if (fresh) continue;
    check.error(*row, "a row with a box called '" + name + "'", "a name of its own",
                "it is used already in line " + std::to_string(first->second));
  }
}

void check_names(Checker& check) {
  std::map<std::string, int> lines;
  for (const auto& [structure, word] : kWords<Structure>) {
    const FieldValue* group = check.root().find(path_of(structure));
    if (group == nullptr) continue;
    check_row_names(check, *group, word, lines);
    int number = 0;
    for (const FieldValue* box : boxes_of(*group)) {
      const FieldValue* given = box->find("name");
      const std::string name = given != nullptr ? given->text : std::string(word) + " " + std::to_string(number + 1);
      ++number;
      const auto [first, fresh] = lines.emplace(name, box->line);
      if (fresh) continue;
      check.error(given != nullptr ? *given : *box, "the name '" + for_display(name) + "' again", "a name of its own",
                  "it is used already in line " + std::to_string(first->second));
    }
  }
}

/// Boxes are a row on an arc, or listed: then a radius would say what their coordinates do not.
void check_radius(Checker& check, const FieldValue& structure) {
  const FieldValue* radius = structure.find("radius");
  if (radius == nullptr || boxes_of(structure).empty()) return;
  check.warn(*radius,
             "a radius of " + radius->shown +
                 " beside listed boxes is not used: they stand by their x and z alone, and static." + structure.key +
                 "_fitted_radius of the results is the radius of the circle fitted to them; remove the key, or replace "
                 "the list by a row of boxes: {count, spacing, first}");
}

std::vector<std::string> roller_kinds(const FieldValue& root) {
  std::vector<std::string> names;
  if (const FieldValue* rollers = root.find("rollers")) {
    for (const FieldValue& kind : rollers->children) names.push_back(kind.key);
    names.insert(names.end(), rollers->refused.begin(), rollers->refused.end());
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
  check.error(roller, "the unknown type of roller " + roller.shown, one_of(kinds),
              near.empty() ? "" : "did you mean '" + near + "'?");
}

/// `box` may stand for all of a row.
void check_rows_have_room(Checker& check, const FieldValue& box, const FieldValue& structure) {
  const FieldValue* own = box.find("rows");
  const FieldValue* rows = own != nullptr ? own : structure.find("rows");
  const FieldValue* length = box.find("length");
  if (rows == nullptr || length == nullptr || rows->integer <= 1 || length->number > 0.0) return;
  if (length->given) {
    check.error(*length, length->shown, "more than 0 m for " + std::to_string(rows->integer) + " rows");
  } else {
    check.missing(box, "length",
                  "a length with its unit: " + std::to_string(rows->integer) + " rows are spread along it");
  }
}

void check_rollers(Checker& check) {
  if (check.root().find("rollers") == nullptr && check.root().mentions("rollers")) return;
  const std::vector<std::string> kinds = roller_kinds(check.root());
  std::set<std::string> used;
  for (const auto& [structure, word] : kWords<Structure>) {
    const FieldValue* group = check.root().find(path_of(structure));
    if (group == nullptr) continue;
    const FieldValue* common = group->find("roller");
    if (common != nullptr) {
      used.insert(common->text);
      check_kind_is_known(check, *common, kinds);
    }
    if (const FieldValue* row = box_row_of(*group)) {
      if (!group->mentions("roller")) {
        check.missing(*group, "roller", "the name of a type of roller row", "the boxes of a row have the same rollers");
      }
      check_rows_have_room(check, *row, *group);
    }
    for (const FieldValue* box : boxes_of(*group)) {
      const FieldValue* own = box->find("roller");
      if (own != nullptr) {
        used.insert(own->text);
        check_kind_is_known(check, *own, kinds);
      } else if (!group->mentions("roller") && !box->mentions("roller")) {
        check.missing(*box, "roller", "the name of a type of roller row",
                      "give it here or once for all boxes under " + path_of(structure));
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
  for (const auto& [structure, word] : kWords<Structure>) {
    const FieldValue* group = root.find(path_of(structure));
    if (group == nullptr) continue;
    check_radius(check, *group);
    check_box_row(check, *group);
  }
  check_stinger(check);
  check_stinger_settings(check);
}

}  // namespace overbend
