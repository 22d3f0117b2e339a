#include "report/dynamic/dynamic_data.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "base/ranges.h"
#include "report/dynamic/fatigue_section.h"
#include "report/dynamic/history_data.h"
#include "report/page/report_style.h"
#include "report/page/thinning.h"
#include "report/static/mooring_data.h"
#include "results/fields/dynamic_scalars.h"
#include "results/fields/location_names.h"

namespace overbend {
namespace {

/// Their maxima are never removed by thinning.
constexpr std::array<Envelope DynamicResults::*, 4> kExtremes = {&DynamicResults::effective_tension,
                                                                 &DynamicResults::bending_moment,
                                                                 &DynamicResults::von_mises, &DynamicResults::strain};

bool is_extreme(const DynamicResults& results, std::size_t i) {
  return ranges::any_of(kExtremes, [&](Envelope DynamicResults::*envelope) {
    const std::vector<double>& maxima = (results.*envelope).max;
    return maxima[i] >= maxima[i - 1] && maxima[i] > maxima[i + 1];
  });
}

/// The lists of the stations shown, starting at the tensioner.
struct EnvelopeData {
  const ReportStyle& style;
  const std::set<std::size_t>& shown;
  Json lists = Json::object();

  void operator()(const ResultField& field, const std::vector<double>& values) {
    if (field.key(Output::report)) lists[field.name] = list(values, field.from_anchor);
  }
  void operator()(const ResultField&, const std::vector<Vec3>&) {}
  void over_time(const ResultField& field, const Envelope& envelope, const std::vector<double>& statics) {
    if (!field.key(Output::report)) return;
    lists[field.name] = {{"min", list(envelope.min, false)},
                         {"max", list(envelope.max, false)},
                         {"mean", list(envelope.mean, false)},
                         {"static", list(statics, false)}};
  }
  void spread(const ResultField&, const Envelope&) {}

  Json list(const std::vector<double>& values, bool along) const {
    Json out = Json::array();
    for (auto i = shown.rbegin(); i != shown.rend(); ++i) {
      const double value = values.at(*i);
      out.push_back(style.number(along ? style.along(value) : value));
    }
    return out;
  }
};

Json envelope_data(const ReportStyle& style, const DynamicResults& results) {
  const std::set<std::size_t> shown =
      thinned(results.station_s.size(), [&](std::size_t i) { return is_extreme(results, i); });
  EnvelopeData data{style, shown};
  visit_dynamic_stations(results, data);
  return data.lists;
}

Json region_data(const ReportStyle& style, const StaticResults& statics, const DynamicRegion& region) {
  Json all = Json::object();
  visit_dynamic_region(region, [&](const ResultField& field, const DynamicExtreme& extreme) {
    if (!field.key(Output::report)) return;
    JsonWriter<ReportStyle> item(style);
    visit_instant_of_extreme(extreme, item);
    item["value"] = style.number(extreme.over_time.max);
    item["place"] = location_name(statics, extreme.s);
    all[field.name] = item.take();
  });
  return all;
}

Json support_data(const ReportStyle& style, const SupportDynamics& box) {
  std::map<int, Json> rows;  // by index, as a row may have no side rollers
  for (const RollerDynamics& r : box.rollers) {
    JsonWriter<ReportStyle> item(style);
    visit_dynamic_roller(r, item);
    rows[r.row][word(r.position)] = item.take();
  }
  Json list = Json::array();
  for (auto& [index, row] : rows) {
    list.push_back(std::move(row));
  }
  return {{"name", box.name}, {"rows", list}};
}

Json impact_data(const ReportStyle& style, const DynamicResults& results) {
  std::map<int, const SupportDynamics*> boxes_by_roller;
  std::map<int, const RollerDynamics*> rollers_by_index;
  for (const SupportDynamics& box : results.supports) {
    for (const RollerDynamics& r : box.rollers) {
      boxes_by_roller[r.roller] = &box;
      rollers_by_index[r.roller] = &r;
    }
  }
  Json all = Json::array();
  for (const Impact& impact : results.hardest_impacts) {
    const auto roller = rollers_by_index.find(impact.roller);
    if (roller == rollers_by_index.end()) {
      continue;
    }
    JsonWriter<ReportStyle> item(style);
    visit_impact(impact, item);
    item["box"] = boxes_by_roller[impact.roller]->name;
    item["row"] = roller->second->row + 1;
    item["position"] = word(roller->second->position);
    all.push_back(item.take());
  }
  return all;
}

void add_pipe(const ReportStyle& style, const StaticResults& statics, const DynamicResults& results,
              JsonWriter<ReportStyle>& data) {
  data["envelopes"] = envelope_data(style, results);
  data["overbend"] = statics.overbend ? region_data(style, statics, results.overbend) : Json(nullptr);
  data["tower"] = statics.tower ? region_data(style, statics, results.tower) : Json(nullptr);
  data["sagbend"] = region_data(style, statics, results.sagbend);
  data["supports"] = style.rows(results.supports, [&](const SupportDynamics& box) { return support_data(style, box); });
  data["impacts"] = impact_data(style, results);
  data["fatigue"] = fatigue_figure_data(statics, results);
}

}  // namespace

Json dynamic_figure_data(const StaticResults& statics, const DynamicResults& results) {
  const ReportStyle style(statics);
  JsonWriter data(style);
  visit_dynamic_settings(results, data);
  if (statics.has_pipe()) add_pipe(style, statics, results, data);
  data["histories"] = history_data(statics, results);
  data["spectra"] = spectrum_data(results);
  data["vessel"] = results.vessel ? vessel_figure_data(*results.vessel) : Json(nullptr);
  return data.take();
}

}  // namespace overbend
