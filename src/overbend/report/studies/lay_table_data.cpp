#include "report/studies/lay_table_data.h"

#include <optional>
#include <vector>

#include "base/shown_unit.h"
#include "report/page/json_number.h"

namespace overbend {
namespace {

/// A curve: its name, its quantity by name and unit, and its value.
struct Curve {
  const char *name, *quantity, *si;
  std::optional<double> (*value)(const LayTableValues&);
};

struct Panel {
  const char* title;
  std::vector<Curve> curves;
  std::optional<double> limit;  ///< Drawn as a line.
};

template <double LayTableValues::*kMember>
std::optional<double> take(const LayTableValues& lay) {
  return lay.*kMember;
}

const std::vector<Panel>& panels() {
  using V = LayTableValues;
  static const std::vector<Panel> kPanels = {
      {"Tension",
       {{"top", "tension", "N", take<&V::top_tension>}, {"bottom", "tension", "N", take<&V::bottom_tension>}},
       {}},
      {"Lay-back", {{"lay-back", "lay_back", "m", take<&V::lay_back>}}, {}},
      {"Bending stress",
       {{"overbend", "stress", "Pa", take<&V::overbend_bending_stress>},
        {"sagbend", "stress", "Pa", take<&V::sagbend_bending_stress>}},
       {}},
      {"Strain",
       {{"overbend", "strain", "1", take<&V::overbend_strain>}, {"sagbend", "strain", "1", take<&V::sagbend_strain>}},
       {}},
      {"Largest reaction of a roller", {{"reaction", "force", "N", take<&V::max_reaction>}}, {}},
      {"Separation at the stinger tip",
       {{"separation", "separation", "m", [](const V& lay) { return lay.tip_separation; }}},
       {}},
      {"Departure angle", {{"angle", "angle", "rad", take<&V::departure_angle>}}, {}},
      {"Utilisation of the governing check",
       {{"utilisation", "utilisation", "1", [](const V& lay) { return lay.utilisation; }}},
       1.0}};
  return kPanels;
}

ShownUnit axis_unit(const LayTable& table) {
  if (table.route) return route_length();
  return shown_unit("", table.vary == LayTableVary::tension ? "N" : "m");
}

double row_abscissa(const LayTable& table, const LayTableRow& row) {
  return axis_unit(table).factor * (table.route ? row.distance.value_or(0.0) : row.varied);
}

Json curve_points(const LayTable& table, const Curve& curve, double factor) {
  Json points = Json::array();
  for (const LayTableRow& row : table.rows) {
    if (!row.lay) continue;
    if (const std::optional<double> value = curve.value(*row.lay)) {
      points.push_back(Json::array({json_number(row_abscissa(table, row)), json_number(factor * *value)}));
    }
  }
  return points;
}

Json panel_json(const LayTable& table, const Panel& panel) {
  Json series = Json::array();
  const ShownUnit unit = shown_unit(panel.curves.front().quantity, panel.curves.front().si);
  for (const Curve& curve : panel.curves) {
    Json points = curve_points(table, curve, unit.factor);
    if (!points.empty()) series.push_back({{"name", curve.name}, {"points", points}});
  }
  const std::string title =
      unit.name.empty() ? panel.title : std::string(panel.title) + " [" + std::string(unit.name) + "]";
  return {{"title", title}, {"series", series}, {"limit", panel.limit ? Json(*panel.limit) : Json(nullptr)}};
}

Json limit_json(const LayTable& table, LayRowKind kind) {
  for (const LayTableRow& row : table.rows) {
    if (row.kind == kind) return json_number(row_abscissa(table, row));
  }
  return nullptr;
}

}  // namespace

std::string lay_table_axis(const LayTable& table) {
  const std::string unit = " [" + std::string(axis_unit(table).name) + "]";
  if (table.route) return "Distance along the route" + unit;
  switch (table.vary) {
    case LayTableVary::lay_back:
      return "Lay-back" + unit;
    case LayTableVary::depth:
      return "Water depth" + unit;
    default:
      return "Tension at the tensioner" + unit;
  }
}

Json lay_table_curves(const LayTable& table) {
  Json all = Json::array();
  for (const Panel& panel : panels()) {
    Json json = panel_json(table, panel);
    if (!json["series"].empty()) all.push_back(std::move(json));
  }
  return {{"axis", lay_table_axis(table)},
          {"panels", all},
          {"least", limit_json(table, LayRowKind::minimum)},
          {"largest", limit_json(table, LayRowKind::maximum)}};
}

}  // namespace overbend
