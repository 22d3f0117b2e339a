#include <algorithm>

#include "report/page/html.h"
#include "report/page/places.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"

namespace overbend {
namespace {

const BoxDescription* setting_of(const std::optional<Description>& description, const std::string& name) {
  if (!description) return nullptr;
  const std::vector<BoxDescription>& boxes = description->supports.boxes;
  const auto at = std::find_if(boxes.begin(), boxes.end(), [&](const BoxDescription& box) { return box.name == name; });
  return at == boxes.end() ? nullptr : &*at;
}

const SupportDynamics* over_time(const DynamicResults* dynamic, const std::string& name) {
  if (dynamic == nullptr) return nullptr;
  const auto at = std::find_if(dynamic->supports.begin(), dynamic->supports.end(),
                               [&](const SupportDynamics& box) { return box.name == name; });
  return at == dynamic->supports.end() ? nullptr : &*at;
}

std::vector<html::Head> head(bool dynamic) {
  std::vector<html::Head> columns = {{"Box", "", true},
                                     {"On", "", true},
                                     {"X", shown_name("m")},
                                     {"Z", shown_name("m")},
                                     {"Offset", clearances().unit},
                                     {"Along pipe", shown_name("m")},
                                     {"Reaction", shown_name("N")}};
  if (dynamic) columns.push_back({"Largest", shown_name("N")});
  columns.push_back({"Separation", clearances().unit});
  if (dynamic) columns.push_back({"Smallest", clearances().unit});
  return columns;
}

std::vector<std::string> cells(const StaticResults& results, const SupportResult& box, const BoxDescription* setting,
                               const SupportDynamics* moved) {
  const Vec3 p = ship_point(results, box.p_W);
  std::vector<std::string> row = {box.name, box.stinger ? "stinger" : "ramp"};
  row.push_back(shown_number(setting != nullptr ? setting->x : p.x(), "m", 3));
  row.push_back(shown_number(setting != nullptr ? setting->z : p.z() - results.stern_shoe_W.z(), "m", 3));
  row.push_back(setting != nullptr ? clearances().text(setting->offset, 0) : "");
  row.push_back(shown_number(from_tensioner(results, box.s), "m", 1));
  row.push_back(forces().text(box.reaction, 1));
  if (moved != nullptr) row.push_back(forces().text(moved->reaction.max, 1));
  row.push_back(clearances().text(box.separation, 1));
  if (moved != nullptr) row.push_back(clearances().text(moved->separation.min, 1));
  return row;
}

}  // namespace

std::string lay_setting_section(const StaticResults& results, const std::optional<Description>& description,
                                const DynamicResults* dynamic) {
  if (results.supports.empty()) return "";
  html::Table table("", head(dynamic != nullptr), "plain setting");
  for (const SupportResult& box : results.supports) {
    table.row(cells(results, box, setting_of(description, box.name), over_time(dynamic, box.name)),
              box.reaction > 0.0 ? "" : "soft");
  }
  return html::section(
      "lay-setting", "Lay setting",
      table.str() +
          "<p class=\"small\">X, Z: from the stern shoe, astern and up, in the vessel's axes, where the underside of "
          "the coated pipe rests; offset: raises the box from there along the normal of the support curve. Along pipe: "
          "from the tensioner. Reaction: resultant of the box; separation: the smallest of its bottom rollers, "
          "negative "
          "is penetration due to the contact stiffness. Boxes in grey carry no load" +
          std::string(dynamic != nullptr ? " in the static state. Maxima and minima are those of the run.</p>\n"
                                         : ".</p>\n"));
}

}  // namespace overbend
