#include "modelfile/binding/stinger_binding.h"

#include <algorithm>
#include <string>
#include <vector>

#include "model/description/description_enum_names.h"
#include "model/vessel/supports.h"

namespace overbend {
namespace {

/// Inclination of the curve before the first box of a structure: for the stinger that of the ramp, for a ramp that of
/// the tensioner.
double incline_before(const Description& description, Structure structure) {
  const std::optional<BoxPlace> end = structure == Structure::stinger ? ramp_end(description) : std::nullopt;
  return end ? end->incline : description.tensioner.incline;
}

void complete_first(const FieldValue& root, Structure structure, double radius, Description& description,
                    BoxRowDescription& row) {
  const FieldValue* first = root.find(std::string("supports.") + enum_name(structure) + ".boxes.first");
  if (first != nullptr) {
    if (first->find("incline") == nullptr) {
      row.incline = incline_before(description, structure);
    }
    return;
  }
  if (const std::optional<BoxPlace> end = ramp_end(description)) {
    const BoxPlace next = along_arc(*end, radius, row.spacing);
    row.first = {next.x, next.z};
    row.incline = next.incline;
  }
}

void place_row(const BoxRowDescription& row, double radius, Structure structure, std::vector<BoxDescription>& boxes) {
  int index = 0;
  for (BoxDescription& box : boxes) {
    if (box.structure == structure) {
      const BoxPlace place = box_of_row(row, radius, index++);
      box.x = place.x;
      box.z = place.z;
      box.incline = place.incline;
      box.length = row.length;
    }
  }
}

}  // namespace

std::optional<BoxPlace> ramp_end(const Description& description) {
  std::vector<Eigen::Vector2d> points;
  const BoxDescription* last = nullptr;
  for (const BoxDescription& box : description.supports.boxes) {
    if (box.structure == Structure::ramp) {
      points.emplace_back(box.x, box.z);
      last = &box;
    }
  }
  if (last == nullptr) {
    return std::nullopt;
  }
  const double tangent = curve_inclinations(points, description.tensioner.incline).back();
  return BoxPlace{last->x, last->z, last->incline.value_or(tangent)};
}

void place_box_rows(const FieldValue& root, Description& description) {
  SupportsDescription& supports = description.supports;
  for (const Structure structure : {Structure::ramp, Structure::stinger}) {
    const bool ramp = structure == Structure::ramp;
    std::optional<BoxRowDescription>& row = ramp ? supports.ramp_row : supports.stinger_row;
    std::optional<double>& radius = ramp ? supports.ramp_radius : supports.stinger_radius;
    if (!row) radius.reset();  // listed boxes have no radius
    if (row && radius) {
      complete_first(root, structure, *radius, description, *row);
      place_row(*row, *radius, structure, supports.boxes);
    }
  }
}

void choose_stinger_setting(SupportsDescription& supports) {
  const auto chosen =
      std::find_if(supports.settings.begin(), supports.settings.end(),
                   [&](const StingerSettingDescription& setting) { return setting.name == supports.setting; });
  if (chosen == supports.settings.end()) {
    return;
  }
  for (std::size_t i = 0; i < std::min(supports.sections.size(), chosen->angles.size()); ++i) {
    supports.sections[i].angle = chosen->angles[i];
  }
}

}  // namespace overbend
