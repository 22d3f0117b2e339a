#include "serve/static_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/json_number.h"
#include "resultfiles/check_tables.h"
#include "resultfiles/result_field.h"

namespace overbend {
namespace {

/// Of a place or a direction: what rounding leaves of a zero is zero.
double visible(double value) {
  return std::abs(value) < 1e-9 ? 0.0 : seven_digits(value);
}

double utilisation(const Station& at) {
  return at.yield_stress > 0.0 ? at.von_mises / at.yield_stress : 0.0;
}

/// Distance along the pipe from the tensioner.
double from_tensioner(const StaticResults& r, double s) {
  return r.stations.empty() ? 0.0 : r.stations.back().s - s;
}

/// One number of every station.
template <class Value>
Json column(const StaticResults& r, Value value) {
  Json numbers = Json::array();
  for (auto at = r.stations.rbegin(); at != r.stations.rend(); ++at) numbers.push_back(seven_digits(value(*at)));
  return numbers;
}

/// Utilisation of the code check that decides at every station.
Json governing_checks(const StaticResults& r) {
  const std::vector<double>& used = r.checks.along.governing;
  Json numbers = Json::array();
  for (auto value = used.rbegin(); value != used.rend(); ++value) numbers.push_back(seven_digits(*value));
  return numbers;
}

/// The checks in brief, as summary.json has them in full.
Json checks(const StaticResults& r) {
  Json list = Json::array();
  for (const CheckRow& row : r.checks.rows) {
    Json item = check_head_json(row);
    if (row.status != CheckStatus::not_done) {
      item["quantity"] = row.quantity;
      item["units"] = row.units;
      item["capacity"] = seven_digits(row.capacity);
      item["utilisation"] = seven_digits(row.utilisation);
      item["reserve"] = seven_digits(row.reserve);
      item["at"] = {{"from_top", seven_digits(row.from_top)}};
    }
    list.push_back(std::move(item));
  }
  return list;
}

Json pipe(const StaticResults& r, const std::vector<std::string>* lists) {
  using Value = double (*)(const Station&);
  constexpr std::array<std::pair<const char*, Value>, 6> kLists = {
      {{"tension", [](const Station& at) { return at.effective_tension; }},
       {"moment", [](const Station& at) { return at.bending_moment; }},
       {"bending_stress", [](const Station& at) { return at.bending_stress; }},
       {"von_mises", [](const Station& at) { return at.von_mises; }},
       {"strain", [](const Station& at) { return at.strain; }},
       {"utilisation", utilisation}}};
  Json all = {{"s", column(r, [&](const Station& at) { return from_tensioner(r, at.s); })},
              {"x", column(r, [](const Station& at) { return at.p_W.x(); })},
              {"y", column(r, [](const Station& at) { return at.p_W.y(); })},
              {"z", column(r, [](const Station& at) { return at.p_W.z(); })}};
  for (const auto& [name, value] : kLists) {
    if (lists == nullptr || std::ranges::find(*lists, name) != lists->end()) all[name] = column(r, value);
  }
  if (lists == nullptr || std::ranges::find(*lists, "checks") != lists->end()) all["checks"] = governing_checks(r);
  return all;
}

/// Von Mises stress of an extreme divided by the yield stress at its location.
double utilisation(const StaticResults& r, const Extreme& von_mises) {
  const auto nearest =
      std::ranges::min_element(r.stations, {}, [&](const Station& at) { return std::abs(at.s - von_mises.s); });
  return nearest != r.stations.end() && nearest->yield_stress > 0.0 ? von_mises.value / nearest->yield_stress : 0.0;
}

Json region(const StaticResults& r, const RegionResult& region) {
  return {{"bending_moment", seven_digits(region.bending_moment.value)},
          {"bending_stress", seven_digits(region.bending_stress.value)},
          {"von_mises", seven_digits(region.von_mises.value)},
          {"strain", seven_digits(region.strain.value)},
          {"utilisation", seven_digits(utilisation(r, region.von_mises))},
          {"s", seven_digits(from_tensioner(r, region.von_mises.s))}};
}

Json key(const StaticResults& r) {
  return {{"top_tension", seven_digits(r.top_tension)},
          {"bottom_tension", seven_digits(r.bottom_tension)},
          {"lay_back", seven_digits(r.lay_back)},
          {"departure_angle", seven_digits(r.departure_angle)},
          {"tip_clearance", r.stinger_tip_clearance ? Json(seven_digits(*r.stinger_tip_clearance)) : Json(nullptr)},
          {"suspended_length", seven_digits(r.suspended_length)},
          {"largest_reaction", seven_digits(r.largest_reaction)},
          {"overbend", r.overbend ? region(r, *r.overbend) : Json(nullptr)},
          {"tower", r.tower ? region(r, *r.tower) : Json(nullptr)},
          {"sagbend", region(r, r.sagbend)}};
}

Json roller(const RollerResult& r) {
  return {{"position", word(r.position)},
          {"center", place_json(r.p_W - r.radius * r.normal_W)},
          {"axis", place_json(r.axis_W)},
          {"radius", seven_digits(r.radius)},
          {"face", seven_digits(r.face)},
          {"reaction", seven_digits(r.reaction)},
          {"separation", seven_digits(r.separation)}};
}

Json support(const StaticResults& r, const SupportResult& box) {
  Json rollers = Json::array();
  for (const RowResult& row : box.rows) {
    for (const RollerResult& one : row.rollers) rollers.push_back(roller(one));
  }
  return {{"name", box.name},
          {"structure", box.stinger ? "stinger" : "ramp"},
          {"place", place_json(box.p_W)},
          {"s", seven_digits(from_tensioner(r, box.s))},
          {"reaction", seven_digits(box.reaction)},
          {"separation", seven_digits(box.separation)},
          {"contact", box.reaction > 0.0},
          {"rollers", rollers}};
}

/// Where the pipe leaves the tensioner for, as a unit vector.
Vec3 leaving(const StaticResults& r) {
  const std::size_t count = r.stations.size();
  if (count < 2) return Vec3::UnitX();
  return (r.stations[count - 2].p_W - r.stations[count - 1].p_W).normalized();
}

}  // namespace

Json place_json(const Vec3& p_W) {
  return {visible(p_W.x()), visible(p_W.y()), visible(p_W.z())};
}

Json pose_json(const Vec3& p_WV, const Mat3& R_WV) {
  Json pose = place_json(p_WV);
  for (int i = 0; i < 9; ++i) pose.push_back(visible(R_WV(i / 3, i % 3)));
  return pose;
}

Json static_json(const StaticResults& r, const std::vector<std::string>* lists) {
  Json supports = Json::array();
  for (const SupportResult& box : r.supports) supports.push_back(support(r, box));
  return {
      {"key", key(r)},
      {"pipe", pipe(r, lists)},
      {"touchdown", {{"s", seven_digits(from_tensioner(r, r.touchdown.s))}, {"place", place_json(r.touchdown.p_W)}}},
      {"supports", supports},
      {"tensioner", {{"place", place_json(r.tensioner_W)}, {"direction", place_json(leaving(r))}}},
      {"checks", checks(r)},
      {"warnings", r.warnings}};
}

}  // namespace overbend
