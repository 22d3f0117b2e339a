#include "resultfiles/check_tables.h"
#include "resultfiles/dynamic_writer.h"
#include "resultfiles/result_field.h"
#include "resultfiles/summary_json.h"

namespace overbend {
namespace {

Json spread(const Spread& s) {
  return {{"min", s.min}, {"max", s.max}, {"mean", s.mean}, {"std", s.std}};
}

Json extreme(const DynamicExtreme& e) {
  Json json = spread(e.over_time);
  Json at = {{"s", e.s}};
  at.update(place(e.p_W));
  json["at"] = at;
  json["time"] = e.time;
  return json;
}

Json region(const DynamicRegion& r) {
  return {{"max_bending_moment", extreme(r.bending_moment)},
          {"max_bending_stress", extreme(r.bending_stress)},
          {"max_von_mises", extreme(r.von_mises)},
          {"max_strain", extreme(r.strain)}};
}

Json roller(const RollerDynamics& r) {
  return {{"reaction", spread(r.reaction)},
          {"separation", spread(r.separation)},
          {"contact_share", r.contact_share},
          {"impacts", r.impact_count},
          {"largest_approach_velocity", r.largest_approach_velocity},
          {"largest_impact_force", r.largest_impact_force},
          {"largest_impulse", r.largest_impulse},
          {"dent_depth", r.dent_depth},
          {"line_load", r.line_load}};
}

Json support(const SupportDynamics& s) {
  Json rows = Json::array();
  for (const RollerDynamics& r : s.rollers) {
    while (static_cast<int>(rows.size()) <= r.row) rows.push_back(Json::object());
    rows[static_cast<std::size_t>(r.row)][word(r.position)] = roller(r);
  }
  return {{"name", s.name},
          {"structure", s.stinger ? "stinger" : "ramp"},
          {"s", s.s},
          {"reaction", spread(s.reaction)},
          {"reaction_percentiles",
           {{"p50", s.reaction_over_time.p50}, {"p90", s.reaction_over_time.p90}, {"p99", s.reaction_over_time.p99}}},
          {"vertical", spread(s.vertical)},
          {"longitudinal", spread(s.longitudinal)},
          {"lateral", spread(s.lateral)},
          {"separation", spread(s.separation)},
          {"contact_share", s.contact_share},
          {"impacts", s.impact_count},
          {"rows", rows}};
}

/// The rollers of a support together.
Json impacts(const SupportDynamics& s) {
  double velocity = 0.0, force = 0.0, impulse = 0.0, dent = 0.0, load = 0.0;
  for (const RollerDynamics& r : s.rollers) {
    velocity = std::max(velocity, r.largest_approach_velocity);
    force = std::max(force, r.largest_impact_force);
    impulse = std::max(impulse, r.largest_impulse);
    dent = std::max(dent, r.dent_depth);
    load = std::max(load, r.line_load);
  }
  return {{"name", s.name},
          {"count", s.impact_count},
          {"largest_approach_velocity", velocity},
          {"largest_impact_force", force},
          {"largest_impulse", impulse},
          {"dent_depth", dent},
          {"line_load", load}};
}

Json tensioner(const TensionerDynamics& t) {
  return {{"mode", t.mode},
          {"min_tension", t.tension.min},
          {"max_tension", t.tension.max},
          {"mean_tension", t.tension.mean},
          {"std_tension", t.tension.std},
          {"travel_min", t.travel.min},
          {"travel_max", t.travel.max},
          {"travel_mean", t.travel.mean},
          {"travel_std", t.travel.std},
          {"time_out_of_range", t.time_out_of_range},
          {"time_at_limit", t.time_at_limit},
          {"pay_out_count", t.pay_out_count},
          {"haul_in_count", t.haul_in_count},
          {"limit_count", t.limit_count},
          {"time_holding", t.time_holding},
          {"time_delayed", t.time_delayed},
          {"time_paying_out", t.time_paying_out},
          {"time_hauling_in", t.time_hauling_in},
          {"wanted", t.wanted},
          {"range_low", t.range_low},
          {"range_high", t.range_high},
          {"travel_limit", t.travel_limit}};
}

Json estimate(const ExtremeEstimate& e) {
  return {{"name", e.name},
          {"units", e.units},
          {"smallest", e.smallest},
          {"peaks", e.peaks},
          {"observed", e.observed},
          {"weibull", {{"estimate", e.weibull}, {"low", e.weibull_low}, {"high", e.weibull_high}}},
          {"gumbel", {{"estimate", e.gumbel}, {"low", e.gumbel_low}, {"high", e.gumbel_high}}},
          {"enough", e.enough}};
}

Json solution(const DynamicResults& r) {
  return {{"energy_drift", r.energy.drift()},         {"steps", r.run.steps},
          {"rejected_steps", r.run.rejected_steps},   {"newton_iterations", r.run.newton_iterations},
          {"factorisations", r.run.factorisations},   {"smallest_step", r.run.smallest_step},
          {"largest_step", r.run.largest_step},       {"wall_time", r.run.wall_time},
          {"real_time_ratio", r.run.real_time_ratio}, {"integrator", r.run.integrator}};
}

template <class Row, class Function>
Json list(const std::vector<Row>& rows, Function json_of) {
  Json json = Json::array();
  for (const Row& row : rows) json.push_back(json_of(row));
  return json;
}

}  // namespace

std::string dynamic_summary(const StaticResults& statics, const DynamicResults& r) {
  Json dynamics = {{"duration", r.duration},
                   {"build_up", r.build_up},
                   {"output_step", r.output_step},
                   {"seed", r.seed},
                   {"top_tension", spread(r.top_tension)},
                   {"bottom_tension", spread(r.bottom_tension)},
                   {"lay_back", spread(r.lay_back)},
                   {"departure_angle", spread(r.departure_angle)}};
  dynamics["smallest_tension"] = extreme(r.smallest_tension);
  const Json tip = spread(r.stinger_tip_clearance);
  dynamics["stinger_tip_clearance"] = statics.stinger_tip_clearance ? tip : Json(nullptr);
  dynamics["overbend"] = statics.overbend ? region(r.overbend) : Json(nullptr);
  dynamics["tower"] = statics.tower ? region(r.tower) : Json(nullptr);
  dynamics["sagbend"] = region(r.sagbend);
  dynamics["supports"] = list(r.supports, support);
  dynamics["impacts"] = list(r.supports, impacts);
  dynamics["impact_count"] = r.impact_count;
  dynamics["tensioner"] = tensioner(r.tensioner);
  dynamics["extremes"] = list(r.extremes, estimate);
  dynamics.update(solution(r));
  dynamics["checks"] = checks_json(r.checks);
  dynamics["assumptions"] = r.assumptions;
  dynamics["warnings"] = r.warnings;
  Json summary = static_summary_json(statics);
  summary["dynamic"] = dynamics;
  return summary_text(summary);
}

}  // namespace overbend
