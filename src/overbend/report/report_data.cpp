#include "report/report_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "report/checks_section.h"
#include "report/comparison_data.h"
#include "report/dynamic_data.h"
#include "report/json_number.h"
#include "report/places.h"
#include "report/thinning.h"

namespace overbend {
namespace {

using nlohmann::json;

/// Their peaks are never thinned away.
constexpr std::array<double Station::*, 3> kExtremes = {&Station::bending_moment, &Station::von_mises,
                                                        &Station::effective_tension};

json point(const StaticResults& results, const Vec3& p_W) {
  const Vec3 p = ship_point(results, p_W);
  return json::array({json_number(p.x()), json_number(p.y()), json_number(p.z())});
}

json direction(const StaticResults& results, const Vec3& d_W) {
  const Vec3 d = ship_point(results, results.stern_shoe_W + d_W);
  return json::array({json_number(d.x()), json_number(d.y()), json_number(d_W.z())});
}

bool is_extreme(const std::vector<Station>& all, std::size_t i) {
  return all[i].region != Region::seabed &&
         std::any_of(kExtremes.begin(), kExtremes.end(), [&](double Station::*member) {
           return all[i].*member >= all[i - 1].*member && all[i].*member > all[i + 1].*member;
         });
}

/// Columns run from the tensioner to the anchor; `s` is the distance along the pipe from the tensioner.
json stations(const StaticResults& results) {
  json columns = json::object();
  const std::set<std::size_t> shown =
      thinned(results.stations.size(), [&](std::size_t i) { return is_extreme(results.stations, i); });
  for (auto i = shown.rbegin(); i != shown.rend(); ++i) {
    const Station* at = &results.stations[*i];
    const Vec3 p = ship_point(results, at->p_W);
    const auto add = [&](const char* name, double value) { columns[name].push_back(json_number(value)); };
    add("s", from_tensioner(results, at->s));
    add("x", p.x());
    add("y", p.y());
    add("z", p.z());
    add("tension", at->effective_tension);
    add("wall", at->wall_tension);
    add("moment", at->bending_moment);
    add("vertical_moment", at->vertical_moment);
    add("lateral_moment", at->lateral_moment);
    add("curvature", at->curvature);
    add("axial", at->axial_stress);
    add("bending", at->bending_stress);
    add("hoop", at->hoop_stress);
    add("mises", at->von_mises);
    add("strain", at->strain);
    add("bed", at->seabed_reaction);
    add("yield", at->yield_stress);
    columns["region"].push_back(static_cast<int>(at->region));
  }
  return columns;
}

/// Whether the pipe has gone over the end of the roller and lies behind it: where it crosses the row it is on the wrong
/// side of the face.
bool passed(const StaticResults& results, const RowResult& row, const RollerResult& r) {
  if (r.off_end <= 0.0 || r.reaction > 0.0 || row.s < 0.0) return false;
  return (station_at(results, row.s).p_W - r.p_W).dot(r.normal_W) < 0.5 * results.pipe_outer_diameter;
}

json roller(const StaticResults& results, const RowResult& row, const RollerResult& r) {
  static constexpr const char* kWords[] = {"bottom", "port", "starboard"};
  return {{"position", kWords[static_cast<int>(r.position)]},
          {"p", point(results, r.p_W)},
          {"normal", direction(results, r.normal_W)},
          {"axis", direction(results, r.axis_W)},
          {"radius", json_number(r.radius)},
          {"face", json_number(r.face)},
          {"reaction", json_number(r.reaction)},
          {"separation", json_number(r.separation)},
          {"off_end", json_number(r.off_end)},
          {"passed", passed(results, row, r)}};
}

json supports(const StaticResults& results) {
  json boxes = json::array();
  for (const SupportResult& box : results.supports) {
    json rows = json::array();
    for (const RowResult& row : box.rows) {
      json rollers = json::array();
      for (const RollerResult& r : row.rollers) {
        rollers.push_back(roller(results, row, r));
      }
      rows.push_back({{"p", point(results, row.p_W)}, {"reaction", json_number(row.reaction)}, {"rollers", rollers}});
    }
    boxes.push_back({{"name", box.name},
                     {"stinger", box.stinger},
                     {"p", point(results, box.p_W)},
                     {"s", json_number(from_tensioner(results, box.s))},
                     {"inclination", json_number(box.inclination)},
                     {"length", json_number(box.length)},
                     {"reaction", json_number(box.reaction)},
                     {"separation", json_number(box.separation)},
                     {"rows", rows}});
  }
  return boxes;
}

json region(const StaticResults& results, const RegionResult& r) {
  const auto extreme = [&](const Extreme& e) {
    return json{{"value", json_number(e.value)},
                {"s", json_number(from_tensioner(results, e.s))},
                {"p", point(results, e.p_W)},
                {"place", place_name(results, e.s)}};
  };
  return {{"moment", extreme(r.bending_moment)},
          {"bending", extreme(r.bending_stress)},
          {"mises", extreme(r.von_mises)},
          {"strain", extreme(r.strain)},
          {"tension", extreme(r.effective_tension)}};
}

json static_figure_data(const StaticResults& results) {
  json vessel_axes = json::array();
  for (int i = 0; i < 3; ++i) {
    vessel_axes.push_back(direction(results, results.R_WV.col(i)));
  }
  const Vec3 north = Vec3::UnitY();
  return {{"stations", stations(results)},
          {"supports", supports(results)},
          {"overbend", results.overbend ? region(results, *results.overbend) : json(nullptr)},
          {"tower", results.tower ? region(results, *results.tower) : json(nullptr)},
          {"sagbend", region(results, results.sagbend)},
          {"touchdown",
           {{"s", json_number(from_tensioner(results, results.touchdown.s))},
            {"p", point(results, results.touchdown.p_W)}}},
          {"anchor", point(results, results.anchor_W)},
          {"tensioner", point(results, results.tensioner_W)},
          {"stern_shoe", point(results, results.stern_shoe_W)},
          {"last_support", results.last_support},
          {"vessel",
           {{"name", results.vessel_name},
            {"axes", vessel_axes},
            {"origin", point(results, Vec3::Zero())},
            {"length", results.vessel_length},
            {"beam", results.vessel_beam},
            {"depth", results.vessel_depth},
            {"draught", results.vessel_draught}}},
          {"north", direction(results, north)},
          {"water_depth", results.water_depth},
          {"diameter", results.pipe_outer_diameter},
          {"steel_diameter", results.steel_outer_diameter}};
}

std::string text(const json& data) {
  return data.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::string report_data(const StaticResults& results, const DynamicResults* dynamic) {
  json data = static_figure_data(results);
  data["checks"] = checks_figure_data(results, dynamic != nullptr ? dynamic->checks : results.checks);
  if (dynamic != nullptr) {
    data["dynamic"] = dynamic_figure_data(results, *dynamic);
  }
  return text(data);
}

std::string report_data(const StaticResults& results, const Comparison& comparison) {
  json data = static_figure_data(results);
  data["comparison"] = comparison_data(comparison);
  return text(data);
}

}  // namespace overbend
