#include "study/compare/moored_values.h"

#include <array>
#include <cmath>
#include <utility>

#include "results/fields/mooring_fields.h"

namespace overbend {
namespace {

constexpr double kRounding = 1e-9;  ///< Smaller values are rounding errors [m, rad, N].

class Collector {
 public:
  void add(const std::string& name, const std::string& text, const std::string& unit, double value, bool key = false) {
    values_.push_back({name, text, unit, std::abs(value) < kRounding ? 0.0 : value, key});
  }
  void add(const std::string& name, const std::string& text, const std::string& unit,
           const std::optional<double>& value, bool key = false) {
    if (value) add(name, text, unit, *value, key);
  }
  void add_motion(const std::string& name, const std::string& text, const std::string& unit,
                  const MotionStatistics& m) {
    add(name + ".max", text + ", largest", unit, m.whole.max, true);
    add(name + ".min", text + ", smallest", unit, m.whole.min, true);
    add(name + ".mean", text + ", mean", unit, m.whole.mean);
    add(name + ".slow.std", text + ", standard deviation of the slow part", unit, m.slow.std);
    add(name + ".wave.std", text + ", standard deviation of the wave part", unit, m.wave.std);
    add(name + ".most_probable_max", text + ", most probable largest in three hours", unit, m.most_probable_max);
  }
  std::vector<ResultValue> take() { return std::move(values_); }

 private:
  std::vector<ResultValue> values_;
};

/// Adds the offsets of a vessel under a name prefix.
struct ShiftVisitor {
  Collector& all;
  std::string front, stage;

  void operator()(const ResultField& field, double value) {
    all.add(front + field.name, "Vessel " + stage + ": " + field.name, std::string(field.units), value, true);
  }
};

void add_state(const std::string& front, const std::string& stage, const MooredState& state, Collector& all) {
  ShiftVisitor shifts{all, front + "vessel.", stage};
  visit_vessel_offset(state.vessel, shifts);
  for (const PeriodResult& period : state.vessel.natural_periods) {
    all.add(front + "vessel.natural_periods[" + period.mode + "].period",
            "Vessel " + stage + ": natural period of " + period.mode, "s", period.period);
  }
  for (const MooringLineResult& line : state.moorings) {
    const std::string name = front + "moorings[" + line.name + "].", text = line.name + " " + stage + ": ";
    all.add(name + "fairlead_tension", text + "tension at the fairlead", "N", line.fairlead_tension, true);
    all.add(name + "anchor_tension", text + "tension at the anchor", "N", line.anchor_tension);
    all.add(name + "length", text + "unstressed length", "m", line.length);
    all.add(name + "length_on_bed", text + "length on the seabed", "m", line.on_bed);
    all.add(name + "utilisation", text + "tension over the breaking load", "1", line.utilisation);
    all.add(name + "anchor_utilisation", text + "load over the holding power of the anchor", "1",
            line.anchor_utilisation);
  }
}

}  // namespace

std::vector<ResultValue> mooring_values(const MooringResults& results) {
  Collector all;
  add_state("static.", "at rest", results.rest, all);
  for (const MooredState& stage : results.stages) {
    add_state("operation.stages[" + stage.name + "].", "at stage " + stage.name, stage, all);
  }
  return all.take();
}

std::vector<ResultValue> moored_dynamic_values(const DynamicResults& results) {
  Collector all;
  if (results.vessel) {
    const VesselDynamics& v = *results.vessel;
    const std::array<std::pair<const char*, const MotionStatistics*>, 3> shifts = {
        {{"surge", &v.surge}, {"sway", &v.sway}, {"heave", &v.heave}}};
    const std::array<std::pair<const char*, const MotionStatistics*>, 3> turns = {
        {{"roll", &v.roll}, {"pitch", &v.pitch}, {"yaw", &v.yaw}}};
    const auto text = [](const char* name) { return std::string("Vessel: ") + name; };
    all.add("dynamic.vessel.offset.max", "Vessel: horizontal offset, largest", "m", v.offset.whole.max, true);
    all.add("dynamic.vessel.offset.most_probable_max",
            "Vessel: horizontal offset, most probable largest in three hours", "m", v.offset.most_probable_max);
    for (const auto& [name, m] : shifts) all.add_motion(std::string("dynamic.vessel.") + name, text(name), "m", *m);
    for (const auto& [name, m] : turns) all.add_motion(std::string("dynamic.vessel.") + name, text(name), "rad", *m);
  }
  for (const MooringLineDynamics& line : results.moorings) {
    const std::string name = "dynamic.moorings[" + line.name + "].";
    all.add_motion(name + "fairlead_tension", line.name + ": tension at the fairlead", "N", line.fairlead_tension);
    all.add(name + "anchor_tension.max", line.name + ": tension at the anchor, largest", "N",
            line.anchor_tension.whole.max);
    all.add(name + "utilisation", line.name + ": largest tension over the breaking load", "1", line.utilisation);
    all.add(name + "least_on_bed", line.name + ": minimum length on the seabed", "m", line.min_on_seabed);
  }
  return all.take();
}

}  // namespace overbend
