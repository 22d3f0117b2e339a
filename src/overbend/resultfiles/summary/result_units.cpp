#include "resultfiles/summary/result_units.h"

#include <map>
#include <type_traits>
#include <utility>

#include "resultfiles/summary/summary_fields.h"
#include "results/fields/body_values.h"
#include "results/fields/fatigue_fields.h"
#include "results/fields/lay_operation_fields.h"
#include "results/fields/line_values.h"
#include "results/fields/moored_fields.h"
#include "results/fields/mooring_fields.h"
#include "results/fields/stinger_dynamics_fields.h"
#include "results/operation_results.h"

namespace overbend {
namespace {

/// As base/units.h writes the unit of a dimension.
Json dimension(std::string_view unit) {
  static const std::map<std::string_view, const char*> kOther = {{"N m", "N*m"}, {"Pa", "N/m^2"}, {"1/m", "m-1"}};
  if (unit == kVaries) return nullptr;
  const auto other = kOther.find(unit);
  return other == kOther.end() ? std::string(unit) : std::string(other->second);
}

/// What is told of a field that holds a number.
enum class Told {
  dimension,  ///< Its unit as base/units.h writes it.
  unit,       ///< Its unit as results.h5 has it.
  description,
};

Json told_of(const ResultField& f, Told told) {
  if (told == Told::description) return std::string(f.description).append(f.aspect);
  if (told == Told::unit) return f.units == kVaries ? Json(nullptr) : Json(f.units);
  return dimension(f.units);
}

/// One of everything that may be there, whatever the results at hand.
struct UnitStyle : ValueStyle<Output::summary> {
  static constexpr bool kWhole = true;
  Told told = Told::dimension;

  static Json number(double) { return nullptr; }
  static Json text(const std::string&) { return nullptr; }
  template <class Integer>
  Json count(Integer) const {
    return told == Told::description ? Json(nullptr) : Json("1");
  }
  template <HasResultWords Enum>
  static Json word(Enum) {
    return nullptr;
  }
  template <class Make>
  static Json maybe(bool, Make make) {
    return make();
  }
  template <class Row, class Make>
  static Json rows(const std::vector<Row>&, Make json_of) {
    Row row{};
    if constexpr (std::is_same_v<Row, RowResult> || std::is_same_v<Row, SupportDynamics>) {
      row.rollers.resize(3);
      row.rollers[1].position = RollerPosition::port;
      row.rollers[2].position = RollerPosition::starboard;
    }
    return Json::array({json_of(row)});
  }
};

}  // namespace

/// Puts the units of what is visited into an object.
template <>
class JsonWriter<UnitStyle> {
 public:
  explicit JsonWriter(const UnitStyle& style = {}) : told_(style.told) {}

  void operator()(const ResultField& f, double) { put(f, told_of(f, told_)); }
  void operator()(const ResultField& f, const std::optional<double>&) { put(f, told_of(f, told_)); }
  void operator()(const ResultField& f, int) { put(f, told_of(f, told_)); }
  void operator()(const ResultField& f, std::int64_t) { put(f, told_of(f, told_)); }
  void operator()(const ResultField& f, std::uint64_t) { put(f, told_of(f, told_)); }
  void operator()(const ResultField& f, const Vec3&) {
    const std::optional<std::string_view> key = f.key(Output::summary);
    if (!key) return;
    std::string before(*key);
    if (before.ends_with(kComponents)) {
      before.pop_back();  // of "at/" the components stand in the object
    }
    if (!before.empty()) before += '/';
    for (const char* axis : {"x", "y", "z"}) (*this)[before + axis] = told_of(f, told_);
  }
  template <class Other>
  void operator()(const ResultField& f, const Other&) {
    put(f, nullptr);
  }
  void spread(const ResultField& f, const Spread&) {
    const std::optional<std::string_view> key = f.key(Output::summary);
    if (!key) return;
    const std::size_t star = key->find('*');
    for (const char* part : {"min", "max", "mean", "std"}) {
      std::string name(key->substr(0, star));
      name += star == std::string_view::npos ? "/" + std::string(part) : part + std::string(key->substr(star + 1));
      (*this)[name] = told_of(f, told_);
    }
  }
  template <class Visit>
  void part(bool, Visit visit_members) {
    visit_members(*this);
  }
  void or_null(std::string_view, bool) {}
  Json& operator[](std::string_view key) {
    Json* at = &object_;
    for (std::size_t end = key.find('/'); end != std::string_view::npos; end = key.find('/')) {
      at = &(*at)[std::string(key.substr(0, end))];
      key.remove_prefix(end + 1);
    }
    return (*at)[std::string(key)];
  }
  Json take() { return std::move(object_); }

 private:
  void put(const ResultField& f, Json unit) {
    if (const std::optional<std::string_view> key = f.key(Output::summary)) (*this)[*key] = std::move(unit);
  }

  Told told_;
  Json object_ = Json::object();
};

namespace {

/// What a vessel on mooring lines adds to the statics.
void add_mooring_units(const UnitStyle& style, Json& statics) {
  const VesselResult vessel;
  const MooringLineResult line;
  statics["vessel"] = object_of(style, [&](auto& one) { visit_vessel_offset(vessel, one); });
  statics["vessel"]["natural_periods"] = Json::array({object_of(style, [](auto& one) {
    one(ResultField{"period", "s", "Undamped natural period"}.summary(), 0.0);
  })});
  statics["thrust"] = object_of(style, [](auto& one) {
    one(ResultField{"surge", "N", "Thrust ahead"}.summary(), 0.0);
    one(ResultField{"sway", "N", "Thrust to port"}.summary(), 0.0);
    one(ResultField{"yaw", "N m", "Moment of the thrusters, bow to port"}.summary(), 0.0);
  });
  statics["moorings"] = Json::array({object_of(style, [&](auto& one) {
    visit_mooring_line(line, one);
    one(ResultField{"length_on_bed", "m", "Unstressed length on the bed"}.summary(), line.on_bed);
    visit_mooring_use(line, one);
  })});
}

/// What it adds to a run in time.
void add_mooring_units_in_time(const UnitStyle& style, Json& dynamic) {
  const VesselDynamics vessel;
  const ThrustDynamics thrust;
  const MooringLineDynamics line;
  dynamic["vessel"] = object_of(style, [&](auto& one) { visit_vessel_dynamics(vessel, one); });
  dynamic["thrust"] = Json::array({object_of(style, [&](auto& one) { visit_thrust_dynamics(thrust, one); })});
  Json mooring = object_of(style, [&](auto& one) { visit_mooring_dynamics(line, one); });
  const MooringEvent event;
  mooring["events"] = Json::array({object_of(style, [&](auto& one) { visit_mooring_event(event, one); })});
  dynamic["moorings"] = Json::array({std::move(mooring)});
}

/// What a hull with hydrodynamic coefficients adds to the statics of a run.
void add_hull_units(const UnitStyle& style, Json& statics) {
  const HullResults hull;
  const RadiationEntryResult entry;
  const RadiationGroupResult group;
  const ModeDampingResult mode;
  Json units = object_of(style, [&](auto& one) {
    visit_hull(hull, one);
    visit_steady_loads(hull, one);
  });
  units["radiation"] = Json::array({object_of(style, [&](auto& one) { visit_radiation_entry(entry, one); })});
  units["fit"] = Json::array({object_of(style, [&](auto& one) { visit_radiation_group(group, one); })});
  units["damping"] = Json::array({object_of(style, [&](auto& one) { visit_mode_damping(mode, one); })});
  statics["hull"] = std::move(units);
}

/// What fatigue and a stinger that turns on its hinges add to a run in time.
void add_fatigue_and_stinger_units(const UnitStyle& style, Json& dynamic) {
  const FatigueResults fatigue;
  const FatigueSpot spot;
  const StingerSectionDynamics section;
  dynamic["fatigue"] = object_of(style, [&](auto& one) { visit_fatigue(fatigue, one); });
  dynamic["fatigue"]["spots"] = Json::array({object_of(style, [&](auto& one) { visit_fatigue_spot(spot, one); })});
  dynamic["stinger"] = object_of(style, [&](auto& one) { visit_stinger_dynamics(section, one); });
  dynamic["stinger"]["sections"] = Json::array({dynamic["stinger"]});
}

/// What lines that stand by themselves add to the statics, and to a run in time.
void add_line_units(const UnitStyle& style, Json& statics) {
  const LineResult line;
  const LineEndResult end;
  Json& units = statics["lines"] = Json::array({object_of(style, [&](auto& one) { visit_line(line, one); })});
  for (const char* name : {"first", "second"}) {
    units[0][name] = object_of(style, [&](auto& one) { visit_line_end(end, one); });
  }
  const BodyResult body;
  statics["bodies"] = Json::array({object_of(style, [&](auto& one) { visit_body(body, one); })});
}

void add_line_units_in_time(const UnitStyle& style, Json& dynamic) {
  const LineDynamics line;
  dynamic["lines"] = Json::array({object_of(style, [&](auto& one) { visit_line_in_time(line, one); })});
  const BodyDynamics body;
  dynamic["bodies"] = Json::array({object_of(style, [&](auto& one) { visit_body_in_time(body, one); })});
}

Json static_summary_told(const UnitStyle& style) {
  const StaticResults any;
  Json told;
  told["checks"] = summary_checks(style, any.checks);
  told["static"] = static_part(style, any);
  add_mooring_units(style, told["static"]);
  add_line_units(style, told["static"]);
  return told;
}

Json dynamic_summary_told(const UnitStyle& style) {
  const StaticResults statics;
  DynamicResults any;
  any.supports.resize(1);
  Json told = static_summary_told(style);
  told["dynamic"] = dynamic_part(style, statics, any);
  add_mooring_units_in_time(style, told["dynamic"]);
  add_line_units_in_time(style, told["dynamic"]);
  add_fatigue_and_stinger_units(style, told["dynamic"]);
  add_hull_units(style, told["static"]);
  return told;
}

UnitStyle telling(Told told) {
  UnitStyle style;
  style.told = told;
  return style;
}

}  // namespace

const Json& summary_units() {
  static const Json kUnits = static_summary_told(telling(Told::dimension));
  return kUnits;
}

const Json& dynamic_summary_units() {
  static const Json kUnits = dynamic_summary_told(telling(Told::dimension));
  return kUnits;
}

const Json& stage_units() {
  static const Json kUnits = [] {
    const UnitStyle style = telling(Told::dimension);
    const StageFailure failure;
    Json units = object_of(style, [](auto& stage) {
      const StageResult any;
      visit_lay_stage(any.stage, stage);
      visit_stage_result(any, stage);
    });
    const Json of_failure = object_of(style, [&](auto& one) { visit_stage_failure(failure, one); });
    for (const auto& [key, unit] : of_failure.items()) units["failure." + key] = unit;
    return units;
  }();
  return kUnits;
}

const Json& stored_summary_units() {
  static const Json kUnits = dynamic_summary_told(telling(Told::unit));
  return kUnits;
}

const Json& summary_descriptions() {
  static const Json kDescriptions = dynamic_summary_told(telling(Told::description));
  return kDescriptions;
}

}  // namespace overbend
