/// Layout of the results of hull, mooring lines and separate lines for the page; see page_fields.h. Members have the
/// keys of summary.json.
#pragma once

#include <string>

#include "resultfiles/summary/json_fields.h"
#include "results/fields/line_values.h"
#include "results/fields/mooring_fields.h"

namespace overbend {

/// Style with the keys of summary.json.
template <class Style>
struct SummaryKeys : Style {
  static constexpr Output kOutput = Output::summary;
};

template <class Style>
SummaryKeys<Style> summary_keys(const Style& style) {
  return {style};
}

template <class Style>
auto page_places(const Style& style, const std::vector<Vec3>& places) {
  return style.rows(places, [&](const Vec3& place) { return style.vector(place); });
}

template <class Style>
auto page_mooring_line(const Style& style, const MooringLineResult& line) {
  JsonWriter json(summary_keys(style));
  visit_mooring_line(line, json);
  visit_mooring_use(line, json);
  json["nearest_object"] = style.text(line.nearest_object);
  json["shape"] = page_places(style, line.shape_W);
  return style.named("MooringLine", json.take());
}

template <class Style>
auto page_vessel(const Style& style, const VesselResult& vessel) {
  JsonWriter json(summary_keys(style));
  visit_vessel_offset(vessel, json);
  json["natural_periods"] = style.rows(vessel.natural_periods, [&](const PeriodResult& natural_period) {
    JsonWriter<Style> period(style);
    period["mode"] = style.text(natural_period.mode);
    period["period"] = style.number(natural_period.period);
    return period.take();
  });
  return style.named("VesselOffset", json.take());
}

template <class Style>
auto page_moored_state(const Style& style, const MooredState& state) {
  JsonWriter<Style> json(style);
  json["name"] = style.text(state.name);
  json["vessel"] = page_vessel(style, state.vessel);
  json["moorings"] =
      style.rows(state.moorings, [&](const MooringLineResult& line) { return page_mooring_line(style, line); });
  return style.named("MooredState", json.take());
}

/// Returns the equilibrium of the hull and the stages of its operation.
template <class Style>
auto page_moorings(const Style& style, const MooringResults& r) {
  JsonWriter<Style> json(style);
  json["rest"] = page_moored_state(style, r.rest);
  json["operation"] = style.text(r.operation);
  json["stages"] = style.rows(r.stages, [&](const MooredState& stage) { return page_moored_state(style, stage); });
  return style.named("Moorings", json.take());
}

template <class Style>
auto page_line_end(const Style& style, const LineEndResult& end) {
  JsonWriter json(summary_keys(style));
  visit_line_end(end, json);
  return style.named("LineEnd", json.take());
}

/// Returns a separate line with its nodes from end A to end B.
template <class Style>
auto page_line(const Style& style, const LineResult& line) {
  JsonWriter json(summary_keys(style));
  visit_line(line, json);
  json["first"] = page_line_end(style, line.first);
  json["second"] = page_line_end(style, line.second);
  json["s"] = style.rows(line.nodes, [&](const LineNodeResult& node) { return style.number(node.s); });
  json["shape"] = style.rows(line.nodes, [&](const LineNodeResult& node) { return style.vector(node.place); });
  json["tension"] = style.rows(line.nodes, [&](const LineNodeResult& node) { return style.number(node.tension); });
  return style.named("LineAtRest", json.take());
}

}  // namespace overbend
