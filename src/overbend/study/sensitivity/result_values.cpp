#include "study/sensitivity/result_values.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "base/ranges.h"
#include "results/fields/check_fields.h"
#include "results/fields/static_scalars.h"

namespace overbend {
namespace {

constexpr std::array<std::string_view, 11> kMainResults = {
    "static.bottom_tension",         "static.lay_back",
    "static.departure_angle",        "static.stinger_tip_clearance",
    "static.overbend.max_von_mises", "static.overbend.max_strain",
    "static.sagbend.max_von_mises",  "static.sagbend.max_bending_moment",
    "static.tower.max_von_mises",    "static.largest_reaction.value",
    "checks.worst.utilisation"};
/// Labels shorter than the descriptions of the results.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kLabels = {
    {{"static.bottom_tension", "Bottom tension"},
     {"static.lay_back", "Lay-back"},
     {"static.departure_angle", "Departure angle"},
     {"static.stinger_tip_clearance", "Stinger tip clearance"}}};
/// Settings and repeated values.
constexpr std::array<std::string_view, 4> kNoResults = {"wanted_tension", "total_length", "largest_penetration",
                                                        "roller_stiffness"};

std::string first_lower(std::string text) {
  const bool initials = text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1]));
  if (!text.empty() && !initials) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

class Collector {
 public:
  void add(const std::string& name, std::string text, std::string_view unit, double value) {
    const bool key = ranges::find(kMainResults, name) != kMainResults.end();
    const auto named = ranges::find(kLabels, name, &std::pair<std::string_view, std::string_view>::first);
    if (named != kLabels.end()) text = named->second;
    values_.push_back({name, std::move(text), std::string(unit), value, key});
  }
  void operator()(const ResultField& field, double value) {
    const auto key = field.key(Output::summary);
    if (!key || ranges::find(kNoResults, field.name) != kNoResults.end()) return;
    std::string name(*key);
    ranges::replace(name, '/', '.');
    add("static." + name, std::string(field.description), field.units, value);
  }
  void operator()(const ResultField& field, const std::optional<double>& value) {
    if (value) (*this)(field, *value);
  }
  template <class Other>
  requires(!std::is_arithmetic_v<Other>) void operator()(const ResultField&, const Other&) {}

  void add_region(const std::string& key, const std::string& label, const RegionResult& region) {
    visit_region(region, [&](const ResultField& field, const Extreme& extreme) {
      add("static." + key + "." + std::string(*field.key(Output::summary)),
          label + ": " + first_lower(std::string(field.description)), field.units, extreme.value);
    });
  }
  void add_checks(const CheckTable& checks) {
    for (std::size_t i = 0; i < checks.rows.size(); ++i) {
      const CheckRow& row = checks.rows[i];
      if (!row.judged()) continue;
      const std::string where = row.region == CheckRegion::line ? "" : std::string(", ") + word(row.region);
      add("checks.list[" + std::to_string(i) + "].utilisation", "Utilisation: " + first_lower(row.name) + where, "1",
          row.utilisation);
    }
    if (const CheckRow* worst = find_governing_check(checks)) {
      add("checks.worst.utilisation", "Largest utilisation: " + first_lower(worst->name), "1", worst->utilisation);
    }
  }
  std::vector<ResultValue> take() { return std::move(values_); }

 private:
  std::vector<ResultValue> values_;
};

}  // namespace

std::vector<ResultValue> result_values(const StaticResults& results) {
  Collector collect;
  visit_lay(results, collect);
  if (results.overbend) collect.add_region("overbend", "Overbend", *results.overbend);
  if (results.tower) collect.add_region("tower", "Tower", *results.tower);
  collect.add_region("sagbend", "Sagbend", results.sagbend);
  if (!results.supports.empty()) visit_contacts(results, collect);
  for (const SupportResult& box : results.supports) {
    const std::string name = "static.supports[" + box.name + "].";
    collect.add(name + "reaction", "Reaction of " + box.name, "N", box.reaction);
    collect.add(name + "separation", "Separation at " + box.name, "m", box.separation);
  }
  collect.add_checks(results.checks);
  return collect.take();
}

}  // namespace overbend
