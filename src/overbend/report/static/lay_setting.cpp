#include <algorithm>

#include "report/page/sections.h"
#include "results/fields/location_names.h"

namespace overbend {
namespace {

const BoxDescription* find_box(const std::optional<Description>& description, const std::string& name) {
  if (!description) return nullptr;
  const std::vector<BoxDescription>& boxes = description->supports.boxes;
  const auto found =
      std::find_if(boxes.begin(), boxes.end(), [&](const BoxDescription& box) { return box.name == name; });
  return found == boxes.end() ? nullptr : &*found;
}

const SupportDynamics* over_time(const DynamicResults* dynamic, const std::string& name) {
  if (dynamic == nullptr) return nullptr;
  const auto found = std::find_if(dynamic->supports.begin(), dynamic->supports.end(),
                                  [&](const SupportDynamics& box) { return box.name == name; });
  return found == dynamic->supports.end() ? nullptr : &*found;
}

Table setting_table(bool dynamic) {
  Table table{"",
              {TableColumn("Box"),
               TableColumn("On"),
               {"X", "m", 3},
               {"Z", "m", 3},
               {"Offset", section_length(), 0},
               {"Along pipe", "m", 1},
               {"Reaction", "N", 1}},
              "plain setting"};
  if (dynamic) table.column({"Largest", "N", 1});
  table.column({"Separation", section_length(), 1});
  if (dynamic) table.column({"Smallest", section_length(), 1});
  return table;
}

std::vector<TableCell> cells(const StaticResults& results, const SupportResult& box, const BoxDescription* setting,
                             const SupportDynamics* moved) {
  const Vec3 p = ship_point(results, box.p_W);
  std::vector<TableCell> row = {box.name, box.stinger ? "stinger" : "ramp"};
  if (setting != nullptr) {
    row.insert(row.end(), {setting->x, setting->z, setting->offset});
  } else {
    row.insert(row.end(), {p.x(), p.z() - results.stern_shoe_W.z(), TableCell()});
  }
  row.insert(row.end(), {from_tensioner(results, box.s), box.reaction});
  if (moved != nullptr) row.emplace_back(moved->reaction.max);
  row.emplace_back(box.separation);
  if (moved != nullptr) row.emplace_back(moved->separation.min);
  return row;
}

}  // namespace

Blocks lay_setting_section(const StaticResults& results, const std::optional<Description>& description,
                           const DynamicResults* dynamic) {
  Table table = setting_table(dynamic != nullptr);
  for (const SupportResult& box : results.supports) {
    table.row(cells(results, box, find_box(description, box.name), over_time(dynamic, box.name)),
              box.reaction > 0.0 ? RowMark::none : RowMark::soft);
  }
  if (table.empty()) return {};
  return block::section(
      "lay-setting", "Lay setting",
      table +
          block::remark(
              "X, Z: from the stern shoe, astern and up, in the vessel's axes, where the underside of the coated pipe "
              "rests; offset: raises the box from there along the normal of the support curve. Along pipe: from the "
              "tensioner. Reaction: resultant of the box; separation: the smallest of its bottom rollers, negative is "
              "penetration due to the contact stiffness. Boxes in grey carry no load" +
              std::string(dynamic != nullptr ? " in the static state. Maxima and minima are those of the run." : ".")));
}

}  // namespace overbend
