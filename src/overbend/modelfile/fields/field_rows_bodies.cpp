#include <algorithm>

#include "base/ranges.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

using Body = BodyDescription;

const std::string kVessel = "vessel", kBody = "bodies[]";

/// Returns true for keys of the vessel that another body has too.
bool is_shared(const std::string& path) {
  constexpr const char* kShared[] = {"length", "beam", "depth", "draught", "heading", "trim", "heel", "motion"};
  return ranges::any_of(kShared, [&](const char* key) {
    const std::string shared = kVessel + "." + key;
    return path == shared || path.starts_with(shared + ".");
  });
}

/// Default dimensions of a body: those of a tug.
std::optional<double> default_size(const std::string& path) {
  const VesselDescription tug = Body{}.hull;
  const std::pair<const char*, double> sizes[] = {
      {".length", tug.length}, {".beam", tug.beam}, {".depth", tug.depth}, {".draught", tug.draught}};
  for (const auto& [key, value] : sizes) {
    if (path == kBody + key) return value;
  }
  return std::nullopt;
}

/// Converts rows of the vessel to those of a body; rows directly below its group refer to its hull.
std::vector<Field> as_of_vessel(const std::vector<Field>& rows) {
  std::vector<Field> shared;
  for (Field row : rows) {
    if (!is_shared(row.path)) continue;
    const bool below_another = row.path.find('.', kVessel.size() + 1) != std::string::npos;
    row.path = kBody + row.path.substr(kVessel.size());
    if (!below_another) row.member = through(&Body::hull, row.member);
    if (const std::optional<double> size = default_size(row.path)) row.member.standard = *size;
    if (row.path == kBody + ".motion" && row.kind == FieldKind::map) {
      row.text = "Source of the motion: one of raos, history, harmonic; with convention and columns if needed.";
    }
    shared.push_back(std::move(row));
  }
  return shared;
}

}  // namespace

std::vector<Field> bodies() {
  std::vector<std::string> axes = world_axis_texts();
  axes.pop_back();
  const std::string place = kBody + ".place";
  std::vector<Field> rows = {
      list_row("bodies", enters(&Description::bodies),
               "Bodies other than the vessel to which lines are attached: a tug, a second vessel, a platform. Their "
               "motion is prescribed.",
               "none"),
      group_row(kBody, appends_named<Body>("body"),
                "One body. Its frame: origin midship on its water line, x forward, y to port, z up."),
      otherwise(row_of_kind(FieldKind::text, kBody + ".name", fills(&Body::name),
                            "Name to which line ends refer; must be unique, and not `vessel`."),
                "body 1, 2, ...")};
  append(rows, vector_rows({.group = required(group_row(place, enters(&Body::place), "Position of its origin.")),
                            .shown = kLength,
                            .texts = axes}));
  rows.push_back(quantity_row(place + ".z", with_default(component(2), 0.0),
                              "Above the mean water level, for a platform whose origin is not on the water.", kLength));
  append(rows, as_of_vessel(vessel()));
  append(rows, as_of_vessel(motion_convention()));
  return rows;
}

}  // namespace overbend::field_rows
