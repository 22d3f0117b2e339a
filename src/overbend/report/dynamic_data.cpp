#include "report/dynamic_data.h"

#include <array>
#include <map>
#include <set>

#include "report/history_data.h"
#include "report/json_number.h"
#include "report/places.h"
#include "report/thinning.h"

namespace overbend {
namespace {

using nlohmann::json;

struct Column {
  const char* name;
  Envelope DynamicResults::*envelope;
  std::vector<double> DynamicResults::*before;  ///< The static curve.
};

constexpr std::array<Column, 4> kColumns = {
    {{"tension", &DynamicResults::effective_tension, &DynamicResults::static_tension},
     {"moment", &DynamicResults::bending_moment, &DynamicResults::static_moment},
     {"mises", &DynamicResults::von_mises, &DynamicResults::static_von_mises},
     {"strain", &DynamicResults::strain, &DynamicResults::static_strain}}};

bool is_extreme(const DynamicResults& results, std::size_t i) {
  for (const Column& column : kColumns) {
    const std::vector<double>& most = (results.*(column.envelope)).max;
    if (most[i] >= most[i - 1] && most[i] > most[i + 1]) {
      return true;
    }
  }
  return false;
}

json column_data(const std::vector<double>& values, const std::set<std::size_t>& shown) {
  json out = json::array();
  for (auto i = shown.rbegin(); i != shown.rend(); ++i) {
    out.push_back(json_number(values.at(*i)));
  }
  return out;
}

json envelope_data(const StaticResults& statics, const DynamicResults& results) {
  const std::set<std::size_t> shown =
      thinned(results.station_s.size(), [&](std::size_t i) { return is_extreme(results, i); });
  json s = json::array();
  for (auto i = shown.rbegin(); i != shown.rend(); ++i) {
    s.push_back(json_number(from_tensioner(statics, results.station_s[*i])));
  }
  json out = {{"s", s}};
  for (const Column& column : kColumns) {
    const Envelope& envelope = results.*(column.envelope);
    out[column.name] = {{"min", column_data(envelope.min, shown)},
                        {"max", column_data(envelope.max, shown)},
                        {"mean", column_data(envelope.mean, shown)},
                        {"before", column_data(results.*(column.before), shown)}};
  }
  return out;
}

json region_data(const StaticResults& statics, const DynamicRegion& region) {
  const auto extreme = [&](const DynamicExtreme& e) {
    return json{{"value", json_number(e.over_time.max)},
                {"s", json_number(from_tensioner(statics, e.s))},
                {"time", json_number(e.time)},
                {"place", place_name(statics, e.s)}};
  };
  return {{"moment", extreme(region.bending_moment)},
          {"mises", extreme(region.von_mises)},
          {"strain", extreme(region.strain)}};
}

json support_data(const SupportDynamics& box) {
  std::map<int, json> rows;  // by index, so that a box without side rollers in a row is no trouble
  for (const RollerDynamics& r : box.rollers) {
    rows[r.row][word(r.position)] = {
        {"share", json_number(r.contact_share)}, {"before", json_number(r.static_reaction)},
        {"least", json_number(r.reaction.min)},  {"mean", json_number(r.reaction.mean)},
        {"most", json_number(r.reaction.max)},   {"impacts", r.impact_count}};
  }
  json list = json::array();
  for (auto& [index, row] : rows) {
    list.push_back(std::move(row));
  }
  return {{"name", box.name}, {"rows", list}};
}

json impact_data(const DynamicResults& results) {
  std::map<int, const SupportDynamics*> box_of;
  std::map<int, const RollerDynamics*> roller_of;
  for (const SupportDynamics& box : results.supports) {
    for (const RollerDynamics& r : box.rollers) {
      box_of[r.roller] = &box;
      roller_of[r.roller] = &r;
    }
  }
  json all = json::array();
  for (const Impact& impact : results.hardest_impacts) {
    const auto roller = roller_of.find(impact.roller);
    if (roller == roller_of.end()) {
      continue;
    }
    all.push_back({{"time", json_number(impact.time)},
                   {"velocity", json_number(impact.approach_velocity)},
                   {"force", json_number(impact.peak_force)},
                   {"box", box_of[impact.roller]->name},
                   {"row", roller->second->row + 1},
                   {"position", word(roller->second->position)}});
  }
  return all;
}

}  // namespace

json dynamic_figure_data(const StaticResults& statics, const DynamicResults& results) {
  json supports = json::array();
  for (const SupportDynamics& box : results.supports) {
    supports.push_back(support_data(box));
  }
  return {{"duration", json_number(results.duration)},
          {"build_up", json_number(results.build_up)},
          {"envelopes", envelope_data(statics, results)},
          {"overbend", statics.overbend ? region_data(statics, results.overbend) : json(nullptr)},
          {"tower", statics.tower ? region_data(statics, results.tower) : json(nullptr)},
          {"sagbend", region_data(statics, results.sagbend)},
          {"histories", history_data(statics, results)},
          {"spectra", spectrum_data(results)},
          {"supports", supports},
          {"impacts", impact_data(results)}};
}

}  // namespace overbend
