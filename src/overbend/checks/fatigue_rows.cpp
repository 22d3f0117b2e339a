#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "checks/calculation_sheet.h"
#include "checks/check_row.h"
#include "checks/check_rows.h"
#include "checks/check_station.h"
#include "checks/fatigue_spot.h"
#include "model/description/fatigue_enum_names.h"

namespace overbend {
namespace {

constexpr double kMega = 1e6;
constexpr const char* kSources2016 = "fatpack; ANYstructure; pythagoras";
constexpr const char* kSources2024 = "pCrunch";

std::size_t station_number(const DynamicResults& dynamics, double s) {
  const auto station = std::lower_bound(dynamics.station_s.begin(), dynamics.station_s.end(), s);
  return std::min(static_cast<std::size_t>(station - dynamics.station_s.begin()), dynamics.station_s.size() - 1);
}

bool differs(const SnCurve& a, const SnCurve& b) {
  return a.slope != b.slope || a.log_a != b.log_a || a.log_a_below != b.log_a_below;
}

/// Adds the constants of the branch of the S-N curve that contains `range` [Pa].
void add_curve(CalculationSheet& sheet, const FatigueDescription& fatigue, const FatigueSpotDescription& spot,
               const FatiguePlace& place, double range) {
  const SnCurve& curve = place.curve;
  const bool below = range < curve.knee;
  const bool renewed = differs(curve, sn_curve(spot.curve, place.medium, FatigueEdition::year_2016));
  const Confirmation confirmed = renewed ? Confirmation::one_source : Confirmation::two_sources;
  const char* const sources = renewed ? kSources2024 : kSources2016;
  const std::string clause = fmt::format("{}, curve {}, {}, {} the change of slope", fatigue_code(fatigue.edition),
                                         enum_name(spot.curve), enum_name(place.medium), below ? "below" : "above");
  sheet.computed({"m", "slope of the S-N curve", "", "1", clause, confirmed, sources},
                 below ? curve.slope_below : curve.slope);
  sheet.computed({"log_a", "constant of the S-N curve, for MPa", "", "1", clause, confirmed, sources},
                 below ? curve.log_a_below : curve.log_a);
}

/// Adds the damage rate of the worst station from its equivalent range, to show the use of the S-N curve.
void add_worst_station(CalculationSheet& sheet, const Model& model, const DynamicResults& dynamics,
                       const FatigueSpot& worst) {
  const FatigueDescription& fatigue = *model.description.fatigue;
  const std::vector<FatigueSpotDescription> spots = fatigue_spots(fatigue);
  const auto spot = std::find_if(spots.begin(), spots.end(), [&](const auto& each) { return each.name == worst.name; });
  const std::size_t i = station_number(dynamics, worst.worst_s);
  if (spot == spots.end() || worst.range[i] <= 0.0) return;
  const std::size_t section = section_of_node(model, dynamics.station_s.back() - worst.worst_s);
  const FatiguePlace place = fatigue_place(fatigue, *spot, model.sections[section], dynamics.static_place[i].z());
  const double range = worst.range[i] * place.factor();
  sheet.given("S_n", "equivalent nominal stress range at the worst station", worst.range[i] / kMega, "MPa", "run");
  sheet.given("SCF", "stress factor of the place", place.stress_factor, "1", "fatigue.spots, fatigue.hi_lo");
  sheet.given("f_t", "factor for walls thicker than 25 mm, (t/25 mm)^k", place.thickness_factor, "1",
              fmt::format("2.4 with k = {:.4g}", place.curve.thickness_exponent));
  sheet.computed({"S", "hot spot stress range", "S_n SCF f_t", "MPa", "2.4"}, range / kMega);
  add_curve(sheet, fatigue, *spot, place, range);
  sheet.given("n_d", "rate of stress cycles at the station", worst.cycles[i], "1/s", "run");
  sheet.computed({"D_d", "damage rate at the station, log N = log_a - m log S", "n_d/10^(log_a - m log10(S))", "1/s",
                  "2.4", Confirmation::two_sources, kSources2016},
                 worst.rate[i]);
}

std::vector<SheetLine> fatigue_sheet(const Model& model, const DynamicResults& dynamics, const FatigueSpot& worst,
                                     double utilisation) {
  CalculationSheet sheet;
  if (model.description.fatigue) add_worst_station(sheet, model, dynamics, worst);
  sheet.given("D_w", "damage of a weld during laying, sum of n/N over rainflow cycles and stops", worst.path_damage,
              "1", "run");
  sheet.given("DFF", "design fatigue factor", dynamics.fatigue->design_factor, "1", "fatigue.design_factor");
  sheet.given("D_lim", "allowed damage during laying", dynamics.fatigue->budget, "1", "fatigue.budget");
  sheet.computed({"U", "utilisation", "DFF D_w/D_lim", "1", "project limit"}, utilisation);
  return sheet.lines;
}

}  // namespace

std::vector<CheckRow> fatigue_rows(const Model& model, const DynamicResults& dynamics) {
  if (!dynamics.fatigue || dynamics.fatigue->spots.empty()) return {};
  const FatigueEdition edition =
      model.description.fatigue ? model.description.fatigue->edition : FatigueEdition::year_2016;
  const CheckTitle title = {"fatigue", "Fatigue of welds on their way",        fatigue_code(edition),
                            "2.4",     "damage from the tensioner to the bed", "1"};
  const FatigueResults& fatigue = *dynamics.fatigue;
  const FatigueSpot& worst =
      *std::max_element(fatigue.spots.begin(), fatigue.spots.end(),
                        [](const FatigueSpot& a, const FatigueSpot& b) { return a.path_damage < b.path_damage; });
  CheckRow row = make_row(title, CheckRegion::line);
  row.s = worst.worst_s;
  row.from_top = dynamics.station_s.back() - worst.worst_s;
  row.p_W = dynamics.static_place[station_number(dynamics, worst.worst_s)];
  set_utilisation(row, fatigue.design_factor * worst.path_damage, fatigue.budget);
  row.remark = "spot '" + worst.name + "', curve " + worst.curve + "; without standby";
  row.inputs = {{"DFF", "design fatigue factor", fatigue.design_factor, "1"},
                {"SCF", "stress factor", worst.stress_factor, "1"}};
  row.sheet = fatigue_sheet(model, dynamics, worst, row.utilisation);
  return {row};
}

}  // namespace overbend
