#include "report/dynamic/fatigue_section.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/shown_unit.h"
#include "report/page/figure_list.h"
#include "report/page/html.h"
#include "report/page/json_number.h"
#include "report/page/places.h"
#include "report/page/thinning.h"

namespace overbend {
namespace {

constexpr double kHour = 3600.0;

/// Damage, which may be small beyond any decimals.
std::string damage_text(double value) {
  return fmt::format("{:.3g}", value);
}

std::size_t worst_station(const FatigueSpot& spot) {
  return static_cast<std::size_t>(std::max_element(spot.rate.begin(), spot.rate.end()) - spot.rate.begin());
}

std::string spots_table(const StaticResults& statics, const DynamicResults& results) {
  html::Table table("Fatigue of welds: damage on the way and allowable standby",
                    {{"Spot", "", true},
                     {"S-N curve", "", true},
                     {"Stress factor", "-"},
                     {"Largest damage", "1/h"},
                     {"Along pipe", shown_name("m")},
                     {"Place", "", true},
                     {"Stress range", shown_name("Pa")},
                     {"Cycles", "1/h"},
                     {"Damage on the way", "-"},
                     {"Allowable standby", "h"}},
                    "dense");
  const FatigueResults& fatigue = *results.fatigue;
  for (const FatigueSpot& spot : fatigue.spots) {
    const std::size_t worst = worst_station(spot);
    table.row({spot.name, spot.curve, html::fixed(spot.stress_factor, 3), damage_text(kHour * spot.worst_rate),
               shown_number(from_tensioner(statics, spot.worst_s), "m", 1), place_name(statics, spot.worst_s),
               shown_number(spot.range[worst], "Pa", 1), html::fixed(kHour * spot.cycles[worst], 0),
               damage_text(spot.path_damage), html::fixed(spot.standby / kHour, 1)},
              fatigue.design_factor * spot.path_damage > fatigue.budget ? "over" : "");
  }
  return table.str();
}

/// Every spot's largest rate is kept where stations are thinned.
bool is_largest(const FatigueResults& fatigue, std::size_t i) {
  return std::any_of(fatigue.spots.begin(), fatigue.spots.end(), [&](const FatigueSpot& spot) {
    return spot.rate[i] >= spot.rate[i - 1] && spot.rate[i] > spot.rate[i + 1];
  });
}

}  // namespace

std::string fatigue_section(const StaticResults& statics, const DynamicResults& results, int& figure) {
  if (!results.fatigue || results.fatigue->spots.empty()) return "";
  const FatigueResults& fatigue = *results.fatigue;
  const std::string note = fmt::format(
      "<p class=\"small\">Budget {:.3g} with a design fatigue factor of {:.3g}; mean lay speed {}/h. The stress "
      "range is the nominal one that gives the same damage at the rate of cycles beside it. Damage on the way and "
      "rates are without the design fatigue factor; the standby is what a weld at the worst place has left beside its "
      "way from the tensioner to the bed, in the sea of this run.</p>\n",
      fatigue.budget, fatigue.design_factor, shown(kHour * fatigue.lay_rate, "m", 1));
  const std::vector<Figure> figures = {
      {"fatigue", "Damage rate of a weld along the pipe, at the worst point round the section", {"whole", "overbend"}}};
  const std::string drawn = figure_list(
      figures, [&](const Figure&, const std::string& part) { return part == "whole" || !statics.supports.empty(); },
      figure);
  return html::section("fatigue", "Fatigue while laying", spots_table(statics, results) + note + drawn);
}

Json fatigue_figure_data(const StaticResults& statics, const DynamicResults& results) {
  if (!results.fatigue || results.station_s.size() < 3) return nullptr;
  const auto shown = thinned(results.station_s.size(), [&](std::size_t i) { return is_largest(*results.fatigue, i); });
  Json s = Json::array(), spots = Json::array();
  for (auto i = shown.rbegin(); i != shown.rend(); ++i) {
    s.push_back(json_number(from_tensioner(statics, results.station_s[*i])));
  }
  for (const FatigueSpot& spot : results.fatigue->spots) {
    Json rate = Json::array();
    for (auto i = shown.rbegin(); i != shown.rend(); ++i) rate.push_back(json_number(kHour * spot.rate[*i]));
    spots.push_back({{"name", spot.name}, {"curve", spot.curve}, {"rate", rate}});
  }
  return {{"s", s}, {"spots", spots}};
}

}  // namespace overbend
