#include <cmath>

#include "base/text.h"
#include "model/description/description_enum_names.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

/// Keys of a section in addition to its hinge and its boxes.
constexpr const char* kOnHinge[] = {"angle", "body", "tanks", "limits", "springs", "stop_stiffness", "hinge_friction"};

const FieldValue* given(const FieldValue& group, const std::string& key) {
  const FieldValue* value = group.find(key);
  return value != nullptr && value->given ? value : nullptr;
}

/// Checks the order of the stops, and that a prescribed angle is between them.
void check_limits(Checker& check, const FieldValue& section) {
  const std::vector<FieldValue>& limits = Checker::items(section, "limits");
  if (limits.size() != 2) return;
  const FieldValue &up = limits[0], &down = limits[1];
  if (down.number <= up.number) {
    check.error(down, down.shown, "more than the first, " + up.shown, "the minimum angle, then the maximum");
    return;
  }
  const FieldValue* angle = given(section, "angle");
  if (angle != nullptr && (angle->number < up.number || angle->number > down.number)) {
    check.error(*angle, angle->shown, "between the stops, " + up.shown + " and " + down.shown);
  }
}

/// Checks that the ends of a straight element differ.
void check_extent(Checker& check, const FieldValue& item, const char* from, const char* to, const char* what) {
  const FieldValue *start = item.find(from), *end = item.find(to);
  if (start == nullptr || end == nullptr) return;
  const auto x = start->get_number("x"), z = start->get_number("z");
  const auto other_x = end->get_number("x"), other_z = end->get_number("z");
  if (!x || !z || !other_x || !other_z) return;
  if (std::hypot(*x - *other_x, *z - *other_z) < 1e-3) {
    check.error(*end, "the same place as " + std::string(from), std::string("another place: ") + what);
  }
}

void check_section(Checker& check, const FieldValue& section) {
  if (!section.mentions("hinge")) {
    for (const char* key : kOnHinge) {
      if (given(section, key) == nullptr) continue;
      check.missing(section, "hinge", "a group of keys",
                    std::string(key) + " requires a stinger that rotates about a hinge");
      break;
    }
  }
  check_limits(check, section);
  for (const FieldValue& tank : Checker::items(section, "tanks")) {
    check_extent(check, tank, "from", "to", "a tank has a length");
  }
  for (const FieldValue& spring : Checker::items(section, "springs")) {
    check_extent(check, spring, "on_barge", "on_stinger", "a spring has a length");
  }
  check_unique_names(check, Checker::items(section, "springs"), "spring");
}

/// Checks that the hinges are in order from the vessel astern.
void check_hinges(Checker& check, const std::vector<FieldValue>& sections) {
  for (std::size_t i = 1; i < sections.size(); ++i) {
    const FieldValue *before = sections[i - 1].find("hinge.x"), *x = sections[i].find("hinge.x");
    if (before == nullptr || x == nullptr || x->number > before->number) continue;
    check.error(*x, x->shown, "more than " + before->shown + " of the section before",
                "sections are listed from the vessel astern");
  }
}

/// Checks that tank names are unique over all sections.
void check_tank_names(Checker& check, const std::vector<const FieldValue*>& sections) {
  std::vector<FieldValue> tanks;
  for (const FieldValue* section : sections) {
    int number = 0;
    for (FieldValue tank : Checker::items(*section, "tanks")) {
      ++number;
      if (tank.find("name") == nullptr) {
        FieldValue name = tank;
        name.key = "name";
        name.text = "tank " + std::to_string(number);
        tank.children.push_back(name);
      }
      tanks.push_back(std::move(tank));
    }
  }
  check_unique_names(check, tanks, "tank");
}

/// Checks that the stinger is given either by sections or as a single one.
void check_one_way(Checker& check, const FieldValue& stinger) {
  const FieldValue* sections = given(stinger, "sections");
  if (sections == nullptr) {
    if (!stinger.mentions("boxes") && !stinger.mentions("sections")) {
      check.missing(stinger, "boxes", "a list", "Roller boxes in order from the tensioner astern");
    }
    return;
  }
  for (const char* key :
       {"hinge", "boxes", "angle", "body", "tanks", "limits", "springs", "stop_stiffness", "hinge_friction"}) {
    const FieldValue* value = given(stinger, key);
    if (value != nullptr) {
      check.error(*value, std::string(key) + " and sections", "one of them", "each section has its own");
    }
  }
}

}  // namespace

std::vector<const FieldValue*> stinger_sections(const FieldValue& root) {
  const FieldValue* stinger = root.find("supports.stinger");
  if (stinger == nullptr || !stinger->given) return {};
  std::vector<const FieldValue*> sections;
  for (const FieldValue& section : Checker::items(*stinger, "sections")) sections.push_back(&section);
  return sections.empty() ? std::vector{stinger} : sections;
}

void check_stinger(Checker& check) {
  const FieldValue* stinger = check.root().find("supports.stinger");
  if (stinger == nullptr || !stinger->given) return;
  check_one_way(check, *stinger);
  const std::vector<FieldValue>& listed = Checker::items(*stinger, "sections");
  check_unique_names(check, listed, "section");
  check_hinges(check, listed);
  const std::vector<const FieldValue*> sections = stinger_sections(check.root());
  for (const FieldValue* section : sections) check_section(check, *section);
  check_tank_names(check, sections);
}

}  // namespace overbend
