/// Layout of the results sent to the page. The functions take a style, so that values and TypeScript types come from
/// the same code; see resultfiles/summary/json_fields.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/ranges.h"
#include "resultfiles/summary/summary_fields.h"
#include "results/line_results.h"
#include "serve/answers/page_moorings.h"

namespace overbend {

inline double yield_utilisation(double von_mises, const Station& station) {
  return station.yield_stress > 0.0 ? von_mises / station.yield_stress : 0.0;
}

/// Returns lists from the tensioner to the anchor. `wanted` as in JsonLists.
template <class Style>
auto page_pipe(const Style& style, const StaticResults& r, const std::vector<std::string>* wanted) {
  JsonLists<Style> lists(style, wanted);
  for (auto station = r.stations.rbegin(); station != r.stations.rend(); ++station) {
    visit_station(*station, lists);
    lists(ResultField{"utilisation", "1", "von Mises stress over yield stress"}.page(),
          yield_utilisation(station->von_mises, *station));
    lists.end_row();
  }
  JsonLists<Style> checks(style, wanted);
  CheckAlong along = r.checks.along;
  std::reverse(along.governing.begin(), along.governing.end());
  for (const double governing : along.governing) {
    checks(ResultField{"checks", "1", "Utilisation of the governing code check at the station"}.page(), governing);
    checks.end_row();
  }
  auto pipe = lists.take();
  pipe.update(checks.take());
  if (r.stations.empty()) {
    for (const char* always : {"s", "x", "y", "z"}) pipe[always] = Json::array();
  }
  return style.named("PipeLists", std::move(pipe));
}

template <class Style>
auto page_region(const Style& style, const StaticResults& r, const RegionResult& region) {
  JsonWriter<Style> json(style);
  visit_region(region, [&](const ResultField& field, const Extreme& extreme) { json(field, extreme.value); });
  const Extreme& peak = region.von_mises;
  const auto nearest =
      ranges::min_element(r.stations, {}, [&](const Station& station) { return std::abs(station.s - peak.s); });
  json["utilisation"] = style.number(nearest == r.stations.end() ? 0.0 : yield_utilisation(peak.value, *nearest));
  json["s"] = style.number(style.along(peak.s));
  return style.named("Region", json.take());
}

template <class Style>
auto page_key(const Style& style, const StaticResults& r) {
  JsonWriter<Style> json(style);
  visit_lay(r, json);
  visit_contacts(r, json);
  json["overbend"] =
      style.maybe(r.overbend.has_value(), [&] { return page_region(style, r, r.overbend.value_or(RegionResult{})); });
  json["tower"] =
      style.maybe(r.tower.has_value(), [&] { return page_region(style, r, r.tower.value_or(RegionResult{})); });
  json["sagbend"] = page_region(style, r, r.sagbend);
  return json.take();
}

template <class Style>
auto page_roller(const Style& style, const RollerResult& roller) {
  JsonWriter<Style> json(style);
  visit_roller(roller, json);
  json["center"] = style.vector(roller.p_W - roller.radius * roller.normal_W);
  return style.named("Roller", json.take());
}

template <class Style>
auto page_support(const Style& style, const SupportResult& box) {
  JsonWriter<Style> json(style);
  visit_support(box, json);
  json["structure"] = style.word(box.stinger ? Structure::stinger : Structure::ramp);
  json["contact"] = style.flag(box.reaction > 0.0);
  std::vector<RollerResult> rollers;
  for (const RowResult& row : box.rows) rollers.insert(rollers.end(), row.rollers.begin(), row.rollers.end());
  json["rollers"] = style.rows(rollers, [&](const RollerResult& roller) { return page_roller(style, roller); });
  return style.named("Support", json.take());
}

/// Returns a section of a hinged stinger.
template <class Style>
auto page_stinger(const Style& style, const StingerSectionResult& section) {
  JsonWriter<Style> json(style);
  visit_stinger_section(section, json);
  json["tanks"] = style.rows(section.tanks, [&](const StingerTankResult& tank) {
    return style.named("StingerTankState", make_object(style, [&](auto& writer) { visit_stinger_tank(tank, writer); }));
  });
  return style.named("StingerSectionState", json.take());
}

/// Returns the laid pipe on an uneven seabed.
template <class Style>
auto page_laid_pipe(const Style& style, const BedResults& bed) {
  JsonWriter<Style> json(style);
  visit_laid_pipe(bed, json);
  json["free_spans"] = style.rows(bed.spans, [&](const FreeSpanResult& span) {
    return style.named("FreeSpanState", make_object(style, [&](auto& writer) { visit_free_span(span, writer); }));
  });
  return style.named("LaidPipeState", json.take());
}

/// Returns a short form of a check; summary.json contains the full form.
template <class Style>
auto page_check(const Style& style, const CheckRow& row) {
  JsonWriter<Style> json(style);
  visit_check_head(row, json);
  json["remark"] = style.text(row.remark);
  json["line"] = style.text(row.line);
  put_check_numbers(style, row, json);
  json["sheet"] = summary_sheet(summary_keys(style), row);
  return style.named("Check", json.take());
}

/// Returns the direction of the pipe at the tensioner, pointing away from it, as a unit vector in frame W.
inline Vec3 leaving(const StaticResults& r) {
  const std::size_t count = r.stations.size();
  if (count < 2) return Vec3::UnitX();
  return (r.stations[count - 2].p_W - r.stations[count - 1].p_W).normalized();
}

/// Returns a static state. Without a pipe, `r` has no stations, and the members about a pipe are null.
template <class Style>
auto page_statics(const Style& style, const StaticResults& r, const std::vector<std::string>* wanted) {
  const bool laid = !r.stations.empty();
  JsonWriter<Style> json(style);
  json["key"] = style.maybe(laid, [&] { return style.named("KeyResults", page_key(style, r)); });
  json["pipe"] = page_pipe(style, r, wanted);
  json["touchdown"] = style.maybe(laid, [&] {
    return style.named("TouchdownPlace",
                       make_object(style, [&](auto& writer) { visit_touchdown(r.touchdown, writer); }));
  });
  json.part(r.bed.has_value(),
            [&](auto& members) { members["seabed"] = page_laid_pipe(style, r.bed.value_or(BedResults{})); });
  put_route_parts(style, r, json);
  json["supports"] = style.rows(r.supports, [&](const SupportResult& box) { return page_support(style, box); });
  json.part(!r.stinger.empty(), [&](auto& members) {
    members["stinger"] =
        style.rows(r.stinger, [&](const StingerSectionResult& section) { return page_stinger(style, section); });
  });
  json["tensioner"] = style.maybe(laid, [&] {
    JsonWriter<Style> tensioner(style);
    tensioner["place"] = style.vector(r.tensioner_W);
    tensioner["direction"] = style.vector(leaving(r));
    return style.named("TensionerPlace", tensioner.take());
  });
  json["moorings"] =
      style.maybe(r.moorings.has_value(), [&] { return page_moorings(style, r.moorings.value_or(MooringResults{})); });
  json["lines"] = style.rows(r.lines, [&](const LineResult& line) { return page_line(style, line); });
  json["checks"] = style.rows(r.checks.rows, [&](const CheckRow& row) { return page_check(style, row); });
  json["findings"] = style.findings(r.findings);
  const Verdict verdict = make_verdict(r.checks, r.findings);
  json["verdict"] = style.named("Verdict", Json{{"kind", style.word(verdict.kind)},
                                                {"words", style.text(verdict.headline)},
                                                {"because", style.text(verdict.because)}});
  return json.take();
}

/// Collects the lists of envelopes, from the tensioner to the anchor.
template <class Style>
class EnvelopeLists {
 public:
  /// `over_time` is false if there is only the static state.
  EnvelopeLists(const Style& style, bool over_time) : style_(style), over_time_(over_time), json_(style) {}

  void operator()(const ResultField& f, const std::vector<double>& values) {
    if (f.key(Style::kOutput)) json_[f.name] = reversed(values, f.from_anchor);
  }
  void operator()(const ResultField& f, const std::vector<Vec3>& places) {
    if (!f.key(Style::kOutput)) return;
    for (const int axis : {0, 2}) {
      std::vector<double> values;
      for (const Vec3& place : places) values.push_back(place(axis));
      json_[std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1)] = reversed(values, false);
    }
  }
  void over_time(const ResultField& f, const Envelope& envelope, const std::vector<double>& statics) {
    const std::optional<std::string_view> key = f.key(Style::kOutput);
    if (!key) return;
    JsonWriter<Style> band(style_);
    band["static"] = reversed(statics, false);
    band.part(over_time_, [&](auto& dynamic) {
      dynamic["min"] = reversed(envelope.min, false);
      dynamic["max"] = reversed(envelope.max, false);
      dynamic["mean"] = reversed(envelope.mean, false);
    });
    json_[*key] = style_.named("Band", band.take());
  }
  void spread(const ResultField&, const Envelope&) {}  // position ranges are not drawn
  Json take() { return json_.take(); }

 private:
  Json reversed(const std::vector<double>& values, bool along) const {
    std::vector<double> turned(values.rbegin(), values.rend());
    return style_.rows(turned, [&](double value) { return style_.number(along ? style_.along(value) : value); });
  }

  Style style_;
  bool over_time_;
  JsonWriter<Style> json_;
};

template <class Style>
auto page_envelopes(const Style& style, const DynamicResults& r, bool over_time) {
  EnvelopeLists<Style> lists(style, over_time);
  visit_dynamic_stations(r, lists);
  return style.named("Envelopes", lists.take());
}

/// Returns an impact with `support`, `row` and `position` of the roller.
template <class Style>
auto page_impact(const Style& style, const DynamicResults& r, const Impact& impact) {
  JsonWriter<Style> json(style);
  const SupportDynamics* support = nullptr;
  RollerDynamics hit;
  for (const SupportDynamics& box : r.supports) {
    for (const RollerDynamics& roller : box.rollers) {
      if (roller.roller != impact.roller) continue;
      support = &box;
      hit = roller;
    }
  }
  json["support"] = style.text(support == nullptr ? std::string() : support->name);
  json["row"] = style.count(hit.row);
  json["position"] = style.word(hit.position);
  visit_impact(impact, json);
  return style.named("Impact", json.take());
}

}  // namespace overbend
