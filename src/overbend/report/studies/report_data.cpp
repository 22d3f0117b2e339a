#include "report/studies/report_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "report/dynamic/dynamic_data.h"
#include "report/page/report_style.h"
#include "report/page/thinning.h"
#include "report/static/checks_section.h"
#include "report/static/line_data.h"
#include "report/static/mooring_data.h"
#include "report/studies/comparison_data.h"
#include "report/studies/seek_section.h"
#include "results/fields/ground_fields.h"
#include "results/fields/location_names.h"
#include "results/fields/static_scalars.h"
#include "results/fields/static_tables.h"

namespace overbend {
namespace {

/// Their peaks are never removed by thinning.
constexpr std::array<double Station::*, 3> kExtremes = {&Station::bending_moment, &Station::von_mises,
                                                        &Station::effective_tension};

bool is_extreme(const std::vector<Station>& all, std::size_t i) {
  return all[i].region != Region::seabed &&
         std::any_of(kExtremes.begin(), kExtremes.end(), [&](double Station::*member) {
           return all[i].*member >= all[i - 1].*member && all[i].*member > all[i + 1].*member;
         });
}

/// Columns from the tensioner to the anchor; `s` is the distance along the pipe from the tensioner.
Json stations(const ReportStyle& style, const StaticResults& results) {
  JsonLists<ReportStyle> columns(style);
  const std::set<std::size_t> shown =
      thinned(results.stations.size(), [&](std::size_t i) { return is_extreme(results.stations, i); });
  for (auto i = shown.rbegin(); i != shown.rend(); ++i) {
    visit_station(results.stations[*i], columns);
    columns.end_row();
  }
  return columns.take();
}

/// Display units of the columns.
struct ShownColumns {
  Json columns = Json::object();

  void operator()(const ResultField& field, double) {
    const std::optional<std::string_view> key = field.key(Output::report);
    const ShownUnit unit = shown_unit(field);
    if (key) columns[std::string(*key)] = {{"unit", unit.name}, {"factor", unit.factor}, {"digits", unit.digits}};
  }
  template <class Other>
  void operator()(const ResultField&, const Other&) {}
};

/// True if the pipe has passed over the end of the roller and is behind it: at the plane of the row it is on the wrong
/// side of the face.
bool passed(const StaticResults& results, const RowResult& row, const RollerResult& r) {
  if (r.off_end <= 0.0 || r.reaction > 0.0 || row.s < 0.0) return false;
  return (station_at(results, row.s).p_W - r.p_W).dot(r.normal_W) < 0.5 * results.pipe_outer_diameter;
}

Json roller(const ReportStyle& style, const StaticResults& results, const RowResult& row, const RollerResult& r) {
  JsonWriter<ReportStyle> item(style);
  visit_roller(r, item);
  item["passed"] = passed(results, row, r);
  return item.take();
}

Json support(const ReportStyle& style, const StaticResults& results, const SupportResult& box) {
  JsonWriter<ReportStyle> item(style);
  visit_support(box, item);
  item["rows"] = style.rows(box.rows, [&](const RowResult& row) {
    JsonWriter<ReportStyle> line(style);
    visit_row(row, line);
    line["rollers"] = style.rows(row.rollers, [&](const RollerResult& r) { return roller(style, results, row, r); });
    return line.take();
  });
  return item.take();
}

Json region(const ReportStyle& style, const StaticResults& results, const RegionResult& r) {
  Json all = Json::object();
  visit_region(r, [&](const ResultField& field, const Extreme& extreme) {
    JsonWriter<ReportStyle> item(style);
    visit_extreme_fields(field, extreme, item);
    item["place"] = location_name(results, extreme.s);
    all[field.name] = item.take();
  });
  return all;
}

/// The seabed under the line, and the free spans of the laid pipe.
Json bed(const ReportStyle& style, const BedResults& bed) {
  return {{"heights", style.rows(bed.heights,
                                 [&](const BedHeight& height) {
                                   JsonWriter<ReportStyle> item(style);
                                   visit_bed_height(height, item);
                                   return item.take();
                                 })},
          {"spans", style.rows(bed.spans, [&](const FreeSpanResult& span) {
             JsonWriter<ReportStyle> item(style);
             visit_free_span(span, item);
             return item.take();
           })}};
}

/// Empty without a pipe.
Json static_figure_data(const StaticResults& results) {
  if (!results.has_pipe()) return Json::object();
  const ReportStyle style(results);
  JsonWriter data(style);
  ShownColumns shown;
  visit_station(results.stations.front(), shown);
  visit_lay(results, data);
  visit_scene(results, data);
  data["shown"] = shown.columns;
  data["stations"] = stations(style, results);
  data["supports"] =
      style.rows(results.supports, [&](const SupportResult& box) { return support(style, results, box); });
  data["overbend"] = results.overbend ? region(style, results, *results.overbend) : Json(nullptr);
  data["tower"] = results.tower ? region(style, results, *results.tower) : Json(nullptr);
  data["sagbend"] = region(style, results, results.sagbend);
  JsonWriter touchdown(style);
  visit_touchdown(results.touchdown, touchdown);
  data["touchdown"] = touchdown.take();
  if (results.bed) data["bed"] = bed(style, *results.bed);
  data["vessel/origin"] = style.vector(ship_point(results, midship(results)));
  data["north"] = style.vector(ship_direction(results, Vec3::UnitY()));
  return data.take();
}

}  // namespace

Json report_data(const StaticResults& results, const DynamicResults* dynamic,
                 const std::optional<Description>& description, const SeekResults* seek) {
  Json data = static_figure_data(results);
  if (seek != nullptr) data["seek"] = seek_figure_data(*seek);
  if (results.moorings) {
    data["moorings"] = mooring_figure_data(*results.moorings, mooring_scene(description, results));
  }
  if (!results.lines.empty()) {
    data["lines"] = line_figure_data(results.lines, dynamic != nullptr ? dynamic->lines : std::vector<LineDynamics>{});
    data["moved"] = dynamic != nullptr;
    data["water_depth"] = json_number(description ? description->environment.water_depth : 0.0);
  }
  if (results.has_pipe()) {
    data["checks"] = checks_figure_data(results, dynamic != nullptr ? dynamic->checks : results.checks);
  }
  if (dynamic != nullptr) data["dynamic"] = dynamic_figure_data(results, *dynamic);
  return data;
}

Json report_data(const StaticResults& results, const Comparison& comparison) {
  Json data = static_figure_data(results);
  data["comparison"] = comparison_data(comparison);
  return data;
}

}  // namespace overbend
