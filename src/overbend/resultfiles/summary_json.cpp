#include "resultfiles/summary_json.h"

#include "resultfiles/check_tables.h"
#include "resultfiles/result_field.h"
#include "resultfiles/results_writer.h"

namespace overbend {
namespace {

Json place_of(const Extreme& extreme) {
  Json json = {{"s", extreme.s}};
  json.update(place(extreme.p_W));
  json["astern"] = extreme.astern;
  return json;
}

Json section(const DerivedSection& s) {
  return {{"name", s.name},
          {"EA", s.EA},
          {"EI", s.EI},
          {"weight_in_air", s.weight_in_air},
          {"weight_submerged", s.weight_submerged},
          {"steel_area", s.steel_area},
          {"second_moment", s.second_moment},
          {"outer_diameter", s.outer_diameter},
          {"mass", s.mass}};
}

Json region(const RegionResult& r) {
  return {{"max_bending_moment", r.bending_moment.value},
          {"max_bending_stress", r.bending_stress.value},
          {"max_von_mises", r.von_mises.value},
          {"max_strain", r.strain.value},
          {"max_effective_tension", r.effective_tension.value},
          {"at", place_of(r.bending_moment)},
          {"at_bending_stress", place_of(r.bending_stress)},
          {"at_von_mises", place_of(r.von_mises)},
          {"at_strain", place_of(r.strain)},
          {"at_effective_tension", place_of(r.effective_tension)}};
}

Json row(const RowResult& r) {
  Json json = Json::object();
  for (const RollerResult& roller : r.rollers) {
    json[word(roller.position)] = {{"reaction", roller.reaction}, {"separation", roller.separation}};
  }
  return json;
}

Json support(const SupportResult& s) {
  Json rows = Json::array();
  for (const RowResult& r : s.rows) rows.push_back(row(r));
  return {{"name", s.name},
          {"structure", s.stinger ? "stinger" : "ramp"},
          {"reaction", s.reaction},
          {"vertical", s.vertical},
          {"longitudinal", s.longitudinal},
          {"lateral", s.lateral},
          {"separation", s.separation},
          {"separation_lateral", s.has_sides ? Json(s.separation_lateral) : Json(nullptr)},
          {"s", s.s},
          {"astern", s.astern},
          {"max_effective_tension", s.effective_tension},
          {"max_bending_moment", s.bending_moment},
          {"max_bending_stress", s.bending_stress},
          {"max_von_mises", s.von_mises},
          {"max_strain", s.strain},
          {"rows", rows}};
}

/// Where the line lies and how it is pulled.
Json lay(const StaticResults& r) {
  Json touchdown = place(r.touchdown.p_W);
  touchdown["s"] = r.touchdown.s;
  touchdown["astern"] = r.touchdown.astern;
  return {{"top_tension", r.top_tension},
          {"bottom_tension", r.bottom_tension},
          {"residual_curvature", r.residual_curvature},
          {"largest_tension", r.largest_tension},
          {"smallest_tension",
           {{"value", r.smallest_tension.value},
            {"at",
             {{"s", r.smallest_tension.s},
              {"x", r.smallest_tension.p_W.x()},
              {"y", r.smallest_tension.p_W.y()},
              {"z", r.smallest_tension.p_W.z()}}}}},
          {"wanted_tension", r.wanted_tension},
          {"lay_back", r.lay_back},
          {"suspended_length", r.suspended_length},
          {"departure_angle", r.departure_angle},
          {"touchdown", touchdown},
          {"anchor", place(r.anchor_W)},
          {"top_to_touchdown", r.top_to_touchdown},
          {"length_top_to_touchdown", r.length_top_to_touchdown},
          {"total_length", r.total_length},
          {"stinger_tip_clearance", r.stinger_tip_clearance ? Json(*r.stinger_tip_clearance) : Json(nullptr)},
          {"last_support", r.last_support.empty() ? Json(nullptr) : Json(r.last_support)}};
}

Json contact(const StaticResults& r) {
  Json supports = Json::array();
  for (const SupportResult& s : r.supports) supports.push_back(support(s));
  Json largest = nullptr;
  if (!r.supports.empty()) largest = {{"value", r.largest_reaction}, {"support", r.largest_reaction_support}};
  return {{"supports", supports},
          {"largest_reaction", largest},
          {"smallest_separation", r.supports.empty() ? Json(nullptr) : Json(r.smallest_separation)},
          {"largest_penetration", r.largest_penetration},
          {"roller_stiffness", r.roller_stiffness}};
}

Json solution(const StaticResults& r) {
  return {{"balance", {{"force_residual", r.force_residual}, {"global", r.global_residual}}},
          {"iterations", r.solve.iterations},
          {"relaxation_steps", r.solve.relaxation_steps},
          {"wall_time", r.solve.wall_time},
          {"method", r.solve.method},
          {"history", r.solve.history}};
}

}  // namespace

Json place(const Vec3& p_W) {
  return {{"x", p_W.x()}, {"y", p_W.y()}, {"z", p_W.z()}};
}

Json static_summary_json(const StaticResults& r) {
  Json statics = lay(r);
  statics["overbend"] = r.overbend ? region(*r.overbend) : Json(nullptr);
  statics["tower"] = r.tower ? region(*r.tower) : Json(nullptr);
  statics["sagbend"] = region(r.sagbend);
  statics.update(contact(r));
  statics.update(solution(r));
  Json sections = Json::array();
  for (const DerivedSection& s : r.sections) sections.push_back(section(s));
  return {{"status", "converged"},  {"title", r.title},
          {"version", r.version},   {"units", "SI: m, N, Pa, rad, s; angles from horizontal"},
          {"frame", kWorldFrame},   {"assumptions", r.assumptions},
          {"warnings", r.warnings}, {"derived", r.sections.empty() ? Json::object() : sections.front()},
          {"sections", sections},   {"checks", checks_json(r.checks)},
          {"static", statics}};
}

std::string summary_text(const Json& summary) {
  // A title may hold bytes that are no UTF-8; they become the replacement character.
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string static_summary(const StaticResults& results) {
  return summary_text(static_summary_json(results));
}

}  // namespace overbend
