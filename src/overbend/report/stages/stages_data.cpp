#include "report/stages/stages_data.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "report/moored/line_parts.h"
#include "report/page/json_number.h"
#include "report/page/quantity.h"
#include "report/stages/hold_points.h"
#include "report/stages/stage_labels.h"
#include "results/fields/location_names.h"
#include "results/sagbend.h"

namespace overbend {
namespace {

constexpr std::size_t kMaxLinePoints = 400;  // per line in a figure with many lines
constexpr double kLaidPipeFraction = 0.15;   // length drawn behind touchdown, as a fraction of the length from the top
                                             // to touchdown

const char* enum_name(SectionKind kind) {
  return kind == SectionKind::cable ? "cable" : kind == SectionKind::head ? "head" : "pipe";
}

/// Stations from the top on, thinned for long lines, including those next to the head.
std::vector<const Station*> drawn(const StaticResults& lay, const std::optional<LineParts>& parts) {
  const std::size_t count = lay.stations.size();
  const std::size_t stride = std::max<std::size_t>(1, count / kMaxLinePoints);
  const double top = lay.stations.back().s;
  const double end = lay.touchdown.s - std::max(30.0, kLaidPipeFraction * (top - lay.touchdown.s));
  std::vector<const Station*> all;
  for (std::size_t i = count; i-- > 0;) {
    const Station& station = lay.stations[i];
    if (station.s < end) break;
    const bool borders = parts && ((i + 1 < count && parts->at(lay.stations[i + 1].s) != parts->at(station.s)) ||
                                   (i > 0 && parts->at(lay.stations[i - 1].s) != parts->at(station.s)));
    if (i % stride == 0 || i + 1 == count || borders) all.push_back(&station);
  }
  return all;
}

/// Runs of points of one kind; each ends at the start of the next.
Json line_runs(const StaticResults& lay, double head_length) {
  const std::optional<LineParts> parts = line_parts(lay, head_length);
  Json runs = Json::array();
  SectionKind kind = SectionKind::pipe;
  for (const Station* station : drawn(lay, parts)) {
    const SectionKind next_kind = parts ? parts->at(station->s) : SectionKind::pipe;
    const Vec3 p = ship_point(lay, station->p_W);
    const Json point = {json_number(p.x()), json_number(p.z())};
    if (runs.empty() || next_kind != kind) {
      if (!runs.empty()) runs.back()["points"].push_back(point);
      runs.push_back({{"of", enum_name(next_kind)}, {"points", Json::array()}});
      kind = next_kind;
    }
    runs.back()["points"].push_back(point);
  }
  return runs;
}

Json or_null(const std::optional<double>& value) {
  return value ? json_number(*value) : Json(nullptr);
}

/// A curve over the stages.
struct Curve {
  const char* key;
  const char* name;
  Quantity unit;
  std::function<std::optional<double>(const StageResult&, const StaticResults&)> value;
};

Quantity distances() {
  Quantity lengths_to_read = lengths();
  lengths_to_read.digits = 2;
  return lengths_to_read;
}

std::vector<Curve> curves() {
  using Stage = const StageResult&;
  using Lay = const StaticResults&;
  const Quantity percent{"", "%", 100.0, 1}, plain{"", "", 1.0, 3};
  return {
      {"top", "Tension at the top", forces(), [](Stage, Lay lay) { return std::optional(lay.top_tension); }},
      {"bottom", "Tension at touchdown", forces(), [](Stage, Lay lay) { return std::optional(lay.bottom_tension); }},
      {"winch", "Pull at the winch", forces(),
       [](Stage, Lay lay) { return lay.dragging ? std::optional(lay.dragging->winch_tension) : std::nullopt; }},
      {"depth", "Depth of the head", distances(),
       [](Stage, Lay lay) { return lay.head ? std::optional(-lay.head->p_W.z()) : std::nullopt; }},
      {"cable", "Cable, of its breaking load", percent,
       [](Stage, Lay lay) { return lay.cable ? lay.cable->utilisation : std::nullopt; }},
      {"sagbend_stress", "Sagbend, von Mises stress", stresses(),
       [](Stage, Lay lay) { return has_sagbend(lay) ? std::optional(lay.sagbend.von_mises.value) : std::nullopt; }},
      {"sagbend_strain", "Sagbend, strain", strains(),
       [](Stage, Lay lay) { return has_sagbend(lay) ? std::optional(lay.sagbend.strain.value) : std::nullopt; }},
      {"overbend_strain", "Overbend, strain", strains(),
       [](Stage, Lay lay) { return lay.overbend ? std::optional(lay.overbend->strain.value) : std::nullopt; }},
      {"tip", "Clearance at the stinger tip", distances(), [](Stage, Lay lay) { return lay.stinger_tip_clearance; }},
      {"roller", "Largest load of a roller", forces(),
       [](Stage, Lay lay) { return lay.supports.empty() ? std::nullopt : std::optional(lay.max_reaction); }},
      {"use", "Largest utilisation", plain,
       [](Stage stage, Lay) {
         const std::optional<StageUtilisation> use = find_max_utilisation(stage);
         return use ? std::optional(use->utilisation) : std::nullopt;
       }},
  };
}

std::map<std::string, double> stage_limit_values(const std::optional<Description>& description) {
  std::map<std::string, double> limits = {{"use", 1.0}, {"cable", 1.0}};
  if (!description || !description->operation.lay.program) return limits;
  const StageLimits& stage_limits = description->operation.lay.program->limits;
  const auto put = [&](const char* key, const std::optional<double>& value) {
    if (value) limits[key] = *value;
  };
  put("sagbend_stress", stage_limits.sagbend_stress);
  put("sagbend_strain", stage_limits.sagbend_strain);
  put("tip", stage_limits.tip_clearance);
  put("roller", stage_limits.roller_load);
  put("use", stage_limits.utilisation);
  put("cable", stage_limits.utilisation);
  return limits;
}

Json curve_data(const OperationResults& results, const std::optional<Description>& description) {
  const std::map<std::string, double> limits = stage_limit_values(description);
  Json all = Json::array();
  for (const Curve& curve : curves()) {
    Json values = Json::array();
    bool any = false;
    for (const StageResult& stage : results.stages) {
      std::optional<double> value = stage.lay ? curve.value(stage, *stage.lay) : std::nullopt;
      if (value) value = curve.unit.shown(*value);
      any = any || value;
      values.push_back(or_null(value));
    }
    if (!any) continue;
    const auto limit = limits.find(curve.key);
    all.push_back({{"key", curve.key},
                   {"name", curve.name},
                   {"unit", curve.unit.unit},
                   {"digits", curve.unit.digits},
                   {"values", std::move(values)},
                   {"limit", limit == limits.end() ? Json(nullptr) : json_number(curve.unit.shown(limit->second))}});
  }
  return all;
}

Json stage_data(const OperationResults& results, std::size_t i, double head_length) {
  const StageResult& stage = results.stages[i];
  Json row = {{"name", stage_title(results, i)},
              {"out", or_null(stage_progress(stage.stage))},
              {"ahead", json_number(stage.barge_ahead)},
              {"line", stage.lay ? line_runs(*stage.lay, head_length) : Json(nullptr)},
              {"touchdown", stage.lay ? json_number(stage.lay->touchdown.astern) : Json(nullptr)}};
  const std::optional<StageUtilisation> use = find_max_utilisation(stage);
  row["use"] = use ? json_number(use->utilisation) : Json(nullptr);
  row["governing"] = use ? use->what : std::string();
  row["why"] = stage.failure ? stage.failure->what + ": " + stage.failure->why : std::string();
  return row;
}

Json hull_outline(const StaticResults& lay) {
  Json corners = Json::array();
  if (!(lay.vessel_length > 0.0)) return corners;
  for (const auto& [along, up] : {std::pair{-1, 0}, {1, 0}, {1, 1}, {-1, 1}}) {
    const double z = up == 0 ? -lay.vessel_draught : lay.vessel_depth - lay.vessel_draught;
    const Vec3 p = ship_point(lay, midship(lay) + lay.R_WV * Vec3(0.5 * along * lay.vessel_length, 0.0, z));
    corners.push_back({json_number(p.x()), json_number(p.z())});
  }
  return corners;
}

Json support_outlines(const StaticResults& lay) {
  Json boxes = Json::array();
  for (const SupportResult& box : lay.supports) {
    Json rows = Json::array();
    for (const RowResult& row : box.rows) {
      const Vec3 p = ship_point(lay, row.p_W);
      rows.push_back({json_number(p.x()), json_number(p.z())});
    }
    boxes.push_back({{"name", box.name}, {"stinger", box.stinger}, {"rows", std::move(rows)}});
  }
  return boxes;
}

/// Known points of the seabed: below the stern shoe, and at the touchdown points.
Json seabed_points(const OperationResults& results) {
  std::map<double, double> points;
  for (const StageResult& stage : results.stages) {
    if (!stage.lay) continue;
    const StaticResults& lay = *stage.lay;
    points.emplace(0.0, -lay.water_depth);
    points.emplace(lay.touchdown.astern, lay.touchdown.p_W.z() - 0.5 * lay.pipe_outer_diameter);
  }
  Json bed = Json::array();
  for (const auto& [x, z] : points) bed.push_back({json_number(x), json_number(z)});
  return bed;
}

}  // namespace

Json stages_data(const OperationResults& results, const std::optional<Description>& description) {
  const double head_length = description ? find_head_length(description->operation.lay) : 0.0;
  Json stages = Json::array(), hull = Json::array(), supports = Json::array();
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    stages.push_back(stage_data(results, i, head_length));
    if (!results.stages[i].lay || !hull.empty()) continue;
    hull = hull_outline(*results.stages[i].lay);
    supports = support_outlines(*results.stages[i].lay);
  }
  return {{"stages",
           {{"list", std::move(stages)},
            {"curves", curve_data(results, description)},
            {"out", progress_name(results.type)},
            {"hull", std::move(hull)},
            {"supports", std::move(supports)},
            {"bed", seabed_points(results)}}}};
}

}  // namespace overbend
