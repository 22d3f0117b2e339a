#include "report/dynamic/fatigue_section.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/page/json_number.h"
#include "report/page/thinning.h"
#include "results/fields/location_names.h"

namespace overbend {
namespace {

constexpr double kHour = 3600.0;

/// Formats damage, which may be too small for fixed decimals.
std::string damage_text(double value) {
  return fmt::format("{:.3g}", value);
}

std::size_t worst_station(const FatigueSpot& spot) {
  return static_cast<std::size_t>(std::max_element(spot.rate.begin(), spot.rate.end()) - spot.rate.begin());
}

Table spots_table(const StaticResults& statics, const FatigueResults& fatigue) {
  Table table{"Fatigue of welds: damage on the way and allowable standby",
              {TableColumn("Spot"),
               TableColumn("S-N curve"),
               {"Stress factor", "-", 3},
               TableColumn::texts("Largest damage", "1/h"),
               {"Along pipe", "m", 1},
               TableColumn("Place"),
               {"Stress range", "Pa", 1},
               {"Cycles", "1/h", 0},
               TableColumn::texts("Damage on the way"),
               {"Allowable standby", "h", 1}},
              "dense"};
  for (const FatigueSpot& spot : fatigue.spots) {
    const std::size_t worst = worst_station(spot);
    table.row({spot.name, spot.curve, spot.stress_factor, damage_text(kHour * spot.worst_rate),
               from_tensioner(statics, spot.worst_s), location_name(statics, spot.worst_s), spot.range[worst],
               kHour * spot.cycles[worst], damage_text(spot.path_damage), spot.standby / kHour},
              fatigue.design_factor * spot.path_damage > fatigue.budget ? RowMark::over : RowMark::none);
  }
  return table;
}

/// Thinning keeps the station of the maximum rate of every spot.
bool is_maximum_rate(const FatigueResults& fatigue, std::size_t i) {
  return std::any_of(fatigue.spots.begin(), fatigue.spots.end(), [&](const FatigueSpot& spot) {
    return spot.rate[i] >= spot.rate[i - 1] && spot.rate[i] > spot.rate[i + 1];
  });
}

}  // namespace

Blocks fatigue_section(const StaticResults& statics, const DynamicResults& results) {
  if (!results.fatigue || results.fatigue->spots.empty()) return {};
  const FatigueResults& fatigue = *results.fatigue;
  const std::string note = fmt::format(
      "Budget {:.3g} with a design fatigue factor of {:.3g}; mean lay speed {}/h. The stress range is the nominal "
      "one that gives the same damage at the rate of cycles in the next column. Damage on the way and rates are "
      "without the design fatigue factor; the standby is the time that remains for a weld at the worst position "
      "after its path from the tensioner to the seabed, in the sea of this run.",
      fatigue.budget, fatigue.design_factor, shown(kHour * fatigue.lay_rate, "m", 1));
  std::vector<std::string> parts = {"whole"};
  if (!statics.supports.empty()) parts.push_back("overbend");
  return block::section(
      "fatigue", "Fatigue while laying",
      Blocks(spots_table(statics, fatigue)) + block::remark(note) +
          block::figure(
              {"fatigue", "Damage rate of a weld along the pipe, at the worst point round the section", parts}));
}

Json fatigue_figure_data(const StaticResults& statics, const DynamicResults& results) {
  if (!results.fatigue || results.station_s.size() < 3) return nullptr;
  const auto shown =
      thinned(results.station_s.size(), [&](std::size_t i) { return is_maximum_rate(*results.fatigue, i); });
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
