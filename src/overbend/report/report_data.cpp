#include "report/report_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "report/places.h"

namespace overbend {
namespace {

using nlohmann::json;

constexpr std::size_t kMostStations = 2500;  ///< More than a printed figure can show; keeps the page small.

/// Seven significant digits: a tenth of a millimetre in a kilometre.
json number(double value) {
  if (value == 0.0 || !std::isfinite(value)) {
    return 0;
  }
  const double scale = std::pow(10.0, 6.0 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

json point(const StaticResults& results, const Vec3& p_W) {
  const Vec3 p = ship_point(results, p_W);
  return json::array({number(p.x()), number(p.y()), number(p.z())});
}

json direction(const StaticResults& results, const Vec3& d_W) {
  const Vec3 d = ship_point(results, results.stern_shoe_W + d_W);
  return json::array({number(d.x()), number(d.y()), number(d_W.z())});
}

/// Every station that is an extreme, touchdown's neighbour or a multiple of the stride.
std::vector<const Station*> thinned(const StaticResults& results) {
  const std::vector<Station>& all = results.stations;
  const std::size_t stride = (all.size() + kMostStations - 1) / kMostStations;
  std::set<std::size_t> keep = {0, all.size() - 1};
  for (std::size_t i = 0; i < all.size(); i += std::max<std::size_t>(stride, 1)) {
    keep.insert(i);
  }
  for (double Station::*member : {&Station::bending_moment, &Station::von_mises, &Station::effective_tension}) {
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
      const bool peak = all[i].*member >= all[i - 1].*member && all[i].*member > all[i + 1].*member;
      if (peak && all[i].region != Region::seabed) {
        keep.insert(i);
      }
    }
  }
  std::vector<const Station*> out;
  for (auto i = keep.rbegin(); i != keep.rend(); ++i) {
    out.push_back(&all[*i]);
  }
  return out;
}

/// Columns run from the tensioner to the anchor; `s` is the distance along the pipe from the tensioner.
json stations(const StaticResults& results) {
  json columns = json::object();
  for (const Station* at : thinned(results)) {
    const Vec3 p = ship_point(results, at->p_W);
    const auto add = [&](const char* name, double value) { columns[name].push_back(number(value)); };
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

json roller(const StaticResults& results, const RollerResult& r) {
  static constexpr const char* kWords[] = {"bottom", "port", "starboard"};
  return {{"position", kWords[static_cast<int>(r.position)]},
          {"p", point(results, r.p_W)},
          {"normal", direction(results, r.normal_W)},
          {"axis", direction(results, r.axis_W)},
          {"radius", number(r.radius)},
          {"face", number(r.face)},
          {"reaction", number(r.reaction)},
          {"separation", number(r.separation)},
          {"off_end", number(r.off_end)}};
}

json supports(const StaticResults& results) {
  json boxes = json::array();
  for (const SupportResult& box : results.supports) {
    json rows = json::array();
    for (const RowResult& row : box.rows) {
      json rollers = json::array();
      for (const RollerResult& r : row.rollers) {
        rollers.push_back(roller(results, r));
      }
      rows.push_back({{"p", point(results, row.p_W)}, {"reaction", number(row.reaction)}, {"rollers", rollers}});
    }
    boxes.push_back({{"name", box.name},
                     {"stinger", box.stinger},
                     {"p", point(results, box.p_W)},
                     {"s", number(from_tensioner(results, box.s))},
                     {"inclination", number(box.inclination)},
                     {"length", number(box.length)},
                     {"reaction", number(box.reaction)},
                     {"separation", number(box.separation)},
                     {"rows", rows}});
  }
  return boxes;
}

json region(const StaticResults& results, const RegionResult& r) {
  const auto extreme = [&](const Extreme& e) {
    return json{{"value", number(e.value)},
                {"s", number(from_tensioner(results, e.s))},
                {"p", point(results, e.p_W)},
                {"place", place_name(results, e.s)}};
  };
  return {{"moment", extreme(r.bending_moment)},
          {"bending", extreme(r.bending_stress)},
          {"mises", extreme(r.von_mises)},
          {"strain", extreme(r.strain)},
          {"tension", extreme(r.effective_tension)}};
}

}  // namespace

std::string report_data(const StaticResults& results) {
  json vessel_axes = json::array();
  for (int i = 0; i < 3; ++i) {
    vessel_axes.push_back(direction(results, results.R_WV.col(i)));
  }
  const Vec3 north = Vec3::UnitY();
  json data = {
      {"stations", stations(results)},
      {"supports", supports(results)},
      {"overbend", results.overbend ? region(results, *results.overbend) : json(nullptr)},
      {"sagbend", region(results, results.sagbend)},
      {"touchdown",
       {{"s", number(from_tensioner(results, results.touchdown.s))}, {"p", point(results, results.touchdown.p_W)}}},
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
  return data.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace overbend
