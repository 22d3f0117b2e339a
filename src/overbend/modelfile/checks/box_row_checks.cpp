#include "modelfile/checks/box_row_checks.h"

#include <fmt/format.h>

#include <map>

#include "base/constants.h"
#include "base/text.h"

namespace overbend {
namespace {

constexpr double kMaxIncline = 85.0 * kDegree;

double first_incline(const FieldValue& root, const FieldValue& row) {
  return row.get_number("first.incline").value_or(root.get_number("tensioner.incline").value_or(0.0));
}

double arc_length(const FieldValue& row) {
  return static_cast<double>(row.get_integer("count").value_or(1) - 1) * row.get_number("spacing").value_or(0.0);
}

/// Number of sections that a setting has to give.
std::size_t section_count(const FieldValue& stinger) {
  const std::vector<FieldValue>& sections = Checker::items(stinger, "sections");
  return sections.empty() && stinger.find("hinge") != nullptr ? 1 : sections.size();
}

void check_angles(Checker& check, const FieldValue& setting, std::size_t sections) {
  const FieldValue* angle = setting.find("angle");
  const FieldValue* angles = setting.find("angles");
  if (angle != nullptr && angles != nullptr) {
    check.error(*angle, "angle and angles", "one of them", "angle is for a stinger of one section");
    return;
  }
  if (angle == nullptr && angles == nullptr) {
    if (!setting.mentions("angle") && !setting.mentions("angles")) {
      check.missing(setting, "angles", "an angle for each section");
    }
    return;
  }
  const FieldValue& entry = angle != nullptr ? *angle : *angles;
  const std::size_t count = angle != nullptr ? 1 : angles->children.size();
  if (sections > 0 && count != sections) {
    check.error(entry, fmt::format("{} angle{}", count, count == 1 ? "" : "s"),
                fmt::format("{}, one for each section", sections));
  }
}

/// Checks that the angles of a setting are between the stops of their sections.
void check_stops(Checker& check, const FieldValue& stinger, const FieldValue& setting) {
  const std::vector<FieldValue>& sections = Checker::items(stinger, "sections");
  const FieldValue* alone = setting.find("angle");
  const std::vector<FieldValue>& listed = Checker::items(setting, "angles");
  const std::size_t count = alone != nullptr ? 1 : listed.size();
  for (std::size_t i = 0; i < count; ++i) {
    const FieldValue& section = i < sections.size() ? sections[i] : stinger;
    const std::vector<FieldValue>& limits = Checker::items(section, "limits");
    const FieldValue& angle = alone != nullptr ? *alone : listed[i];
    if (limits.size() != 2 || (angle.number >= limits[0].number && angle.number <= limits[1].number)) continue;
    check.error(angle, angle.shown, "between the stops, " + limits[0].shown + " and " + limits[1].shown);
  }
}

void check_chosen(Checker& check, const FieldValue& stinger, const std::map<std::string, int>& names) {
  const FieldValue* chosen = stinger.find("setting");
  if (chosen == nullptr || names.count(chosen->text) != 0) {
    return;
  }
  std::vector<std::string> known;
  for (const auto& [name, line] : names) known.push_back(name);
  if (known.empty()) {
    check.error(*chosen, "the setting " + chosen->shown, "a table supports.stinger.settings that contains it");
    return;
  }
  const std::string near = nearest_word(chosen->text, known);
  check.error(*chosen, "the unknown setting " + chosen->shown, join_choices(known),
              near.empty() ? "" : "did you mean '" + near + "'?");
}

}  // namespace

const FieldValue* find_box_row(const FieldValue& structure) {
  const FieldValue* boxes = structure.find("boxes");
  return boxes != nullptr && boxes->kind == FieldValue::Kind::map ? boxes : nullptr;
}

std::optional<BoxPlace> end_of_row(const FieldValue& root, const FieldValue& structure) {
  const FieldValue* row = find_box_row(structure);
  const auto radius = structure.get_number("radius");
  const auto x = row != nullptr ? row->get_number("first.x") : std::nullopt;
  const auto z = row != nullptr ? row->get_number("first.z") : std::nullopt;
  if (!radius || !x || !z) {
    return std::nullopt;
  }
  return along_arc({*x, *z, first_incline(root, *row)}, *radius, arc_length(*row));
}

void check_box_row(Checker& check, const FieldValue& structure) {
  const FieldValue* row = find_box_row(structure);
  if (row == nullptr) {
    return;
  }
  if (!structure.mentions("radius")) {
    check.missing(structure, "radius", "the radius of the arc of the row of boxes, a length in m");
  }
  const bool after_ramp = structure.key == "stinger" && check.root().find("supports.ramp") != nullptr;
  if (!row->mentions("first") && !after_ramp) {
    check.missing(*row, "first", "the position of the first box", "without a ramp the row has no curve to continue");
  }
  const FieldValue* radius = structure.find("radius");
  if (radius == nullptr) {
    return;
  }
  const double incline = first_incline(check.root(), *row) + arc_length(*row) / radius->number;
  if (incline > kMaxIncline) {
    check.error(*radius,
                fmt::format("{}, on which the last box dips by {:.0f} deg", radius->shown, incline * kToDegrees),
                "at most 85 deg at the last box", "a larger radius, fewer boxes or less spacing");
  }
}

void check_stinger_settings(Checker& check) {
  const FieldValue* stinger = check.root().find("supports.stinger");
  if (stinger == nullptr) {
    return;
  }
  std::map<std::string, int> names;
  const std::size_t sections = section_count(*stinger);
  for (const FieldValue& setting : Checker::items(*stinger, "settings")) {
    if (sections == 0) {
      check.error(setting, "a setting of a stinger without a hinge", "a hinge or sections to which it applies",
                  "add supports.stinger.hinge");
    }
    check_angles(check, setting, sections);
    check_stops(check, *stinger, setting);
    const FieldValue* name = setting.find("name");
    if (name == nullptr) continue;
    const auto [first, fresh] = names.emplace(name->text, name->line);
    if (!fresh) {
      check.error(*name, "the name '" + for_display(name->text) + "' again", "a unique name",
                  "it is already used in line " + std::to_string(first->second));
    }
  }
  check_chosen(check, *stinger, names);
  if (const FieldValue* angle = stinger->find("angle"); angle != nullptr && stinger->find("setting") != nullptr) {
    check.error(*angle, "angle and setting", "one of them", "a setting gives the angles of all sections");
  }
}

}  // namespace overbend
