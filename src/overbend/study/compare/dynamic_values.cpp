#include "study/compare/dynamic_values.h"

#include <cmath>

#include "results/check_results.h"

namespace overbend {
namespace {

class Collector {
 public:
  void add(const std::string& name, const std::string& text, const std::string& unit, double value, bool key = false) {
    if (std::isfinite(value)) values_.push_back({"dynamic." + name, text, unit, value, key});
  }
  void add(const std::string& name, const std::string& text, const std::string& unit, const SummaryStatistics& spread) {
    add(name + ".max", text + ", largest", unit, spread.max, true);
    add(name + ".min", text + ", smallest", unit, spread.min, true);
    add(name + ".mean", text + ", mean", unit, spread.mean);
    add(name + ".std", text + ", standard deviation", unit, spread.std);
  }
  void add_region(const std::string& key, const std::string& label, const DynamicRegion& region) {
    add(key + ".max_bending_moment.max", label + ": largest bending moment", "N m", region.bending_moment.over_time.max,
        true);
    add(key + ".max_von_mises.max", label + ": largest von Mises stress", "Pa", region.von_mises.over_time.max, true);
    add(key + ".max_strain.max", label + ": largest strain", "1", region.strain.over_time.max, true);
  }
  std::vector<ResultValue> take() { return std::move(values_); }

 private:
  std::vector<ResultValue> values_;
};

}  // namespace

std::vector<ResultValue> dynamic_values(const StaticResults& statics, const DynamicResults& results) {
  Collector all;
  all.add("top_tension", "Effective tension at the tensioner", "N", results.top_tension);
  all.add("bottom_tension", "Bottom tension", "N", results.bottom_tension);
  all.add("lay_back", "Lay-back", "m", results.lay_back);
  all.add("departure_angle", "Departure angle", "rad", results.departure_angle);
  if (statics.stinger_tip_clearance) {
    all.add("stinger_tip_clearance", "Stinger tip clearance", "m", results.stinger_tip_clearance);
  }
  all.add("smallest_tension.min", "Smallest effective tension along the line", "N",
          results.min_effective_tension.over_time.min, true);
  if (statics.overbend) all.add_region("overbend", "Overbend", results.overbend);
  if (statics.tower) all.add_region("tower", "Tower", results.tower);
  all.add_region("sagbend", "Sagbend", results.sagbend);
  for (const SupportDynamics& box : results.supports) {
    const std::string name = "supports[" + box.name + "].";
    all.add(name + "reaction.max", "Largest reaction of " + box.name, "N", box.reaction.max);
    all.add(name + "contact_share", "Fraction of time in contact of " + box.name, "1", box.contact_share);
  }
  all.add("impact_count", "Number of impacts", "1", static_cast<double>(results.impact_count));
  if (const CheckRow* worst = find_governing_check(results.checks)) {
    all.add("checks.worst.utilisation", "Largest utilisation over time", "1", worst->utilisation, true);
  }
  return all.take();
}

}  // namespace overbend
