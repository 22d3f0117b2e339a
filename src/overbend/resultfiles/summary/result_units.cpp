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

/// Returns the unit of a dimension as in base/units.h.
Json dimension(std::string_view unit) {
  static const std::map<std::string_view, const char*> kOther = {{"N m", "N*m"}, {"Pa", "N/m^2"}, {"1/m", "m-1"}};
  if (unit == kVaries) return nullptr;
  const auto converted = kOther.find(unit);
  return converted == kOther.end() ? std::string(unit) : std::string(converted->second);
}

/// Property of a numerical field that is written in place of its value.
enum class FieldProperty {
  dimension,  ///< Its unit as in base/units.h.
  unit,       ///< Its unit as in results.h5.
  description,
};

Json field_property(const ResultField& f, FieldProperty property) {
  if (property == FieldProperty::description) return std::string(f.description).append(f.aspect);
  if (property == FieldProperty::unit) return f.units == kVaries ? Json(nullptr) : Json(f.units);
  return dimension(f.units);
}

/// Writes one of everything that may exist, independent of the results.
struct UnitStyle : ValueStyle<Output::summary> {
  static constexpr bool kWhole = true;
  FieldProperty property = FieldProperty::dimension;

  static Json number(double) { return nullptr; }
  static Json text(const std::string&) { return nullptr; }
  template <class Integer>
  Json count(Integer) const {
    return property == FieldProperty::description ? Json(nullptr) : Json("1");
  }
  template <HasResultEnumNames Enum>
  static Json word(Enum) {
    return nullptr;
  }
  template <class Make>
  static Json maybe(bool, Make make) {
    return make();
  }
  template <class Row, class Make>
  static Json rows(const std::vector<Row>&, Make make_json) {
    Row row{};
    if constexpr (std::is_same_v<Row, RowResult> || std::is_same_v<Row, SupportDynamics>) {
      row.rollers.resize(3);
      row.rollers[1].position = RollerPosition::port;
      row.rollers[2].position = RollerPosition::starboard;
    }
    return Json::array({make_json(row)});
  }
};

}  // namespace

/// Writes the units of visited fields into an object.
template <>
class JsonWriter<UnitStyle> {
 public:
  explicit JsonWriter(const UnitStyle& style = {}) : property_(style.property) {}

  void operator()(const ResultField& f, double) { put(f, field_property(f, property_)); }
  void operator()(const ResultField& f, const std::optional<double>&) { put(f, field_property(f, property_)); }
  void operator()(const ResultField& f, int) { put(f, field_property(f, property_)); }
  void operator()(const ResultField& f, std::int64_t) { put(f, field_property(f, property_)); }
  void operator()(const ResultField& f, std::uint64_t) { put(f, field_property(f, property_)); }
  void operator()(const ResultField& f, const Vec3&) {
    const std::optional<std::string_view> key = f.key(Output::summary);
    if (!key) return;
    std::string before(*key);
    if (before.ends_with(kComponents)) {
      before.pop_back();  // for "at/" the components are members of the object
    }
    if (!before.empty()) before += '/';
    for (const char* axis : {"x", "y", "z"}) (*this)[before + axis] = field_property(f, property_);
  }
  template <class Other>
  void operator()(const ResultField& f, const Other&) {
    put(f, nullptr);
  }
  void spread(const ResultField& f, const SummaryStatistics&) {
    const std::optional<std::string_view> key = f.key(Output::summary);
    if (!key) return;
    const std::size_t star = key->find('*');
    for (const char* part : {"min", "max", "mean", "std"}) {
      std::string name(key->substr(0, star));
      name += star == std::string_view::npos ? "/" + std::string(part) : part + std::string(key->substr(star + 1));
      (*this)[name] = field_property(f, property_);
    }
  }
  template <class Visit>
  void part(bool, Visit visit_members) {
    visit_members(*this);
  }
  void or_null(std::string_view, bool) {}
  Json& operator[](std::string_view key) {
    Json* node = &object_;
    for (std::size_t end = key.find('/'); end != std::string_view::npos; end = key.find('/')) {
      node = &(*node)[std::string(key.substr(0, end))];
      key.remove_prefix(end + 1);
    }
    return (*node)[std::string(key)];
  }
  Json take() { return std::move(object_); }

 private:
  void put(const ResultField& f, Json unit) {
    if (const std::optional<std::string_view> key = f.key(Output::summary)) (*this)[*key] = std::move(unit);
  }

  FieldProperty property_;
  Json object_ = Json::object();
};

namespace {

/// Adds the static part of a vessel on mooring lines.
void add_mooring_units(const UnitStyle& style, Json& statics) {
  const VesselResult vessel;
  const MooringLineResult line;
  statics["vessel"] = make_object(style, [&](auto& visitor) { visit_vessel_offset(vessel, visitor); });
  statics["vessel"]["natural_periods"] = Json::array({make_object(style, [](auto& visitor) {
    visitor(ResultField{"period", "s", "Undamped natural period"}.summary(), 0.0);
  })});
  statics["thrust"] = make_object(style, [](auto& visitor) {
    visitor(ResultField{"surge", "N", "Thrust ahead"}.summary(), 0.0);
    visitor(ResultField{"sway", "N", "Thrust to port"}.summary(), 0.0);
    visitor(ResultField{"yaw", "N m", "Moment of the thrusters, bow to port"}.summary(), 0.0);
  });
  statics["moorings"] = Json::array({make_object(style, [&](auto& visitor) {
    visit_mooring_line(line, visitor);
    visitor(ResultField{"length_on_bed", "m", "Unstressed length on the seabed"}.summary(), line.on_bed);
    visit_mooring_use(line, visitor);
  })});
}

/// Adds the dynamic part of a vessel on mooring lines.
void add_mooring_units_in_time(const UnitStyle& style, Json& dynamic) {
  const VesselDynamics vessel;
  const ThrustDynamics thrust;
  const MooringLineDynamics line;
  dynamic["vessel"] = make_object(style, [&](auto& visitor) { visit_vessel_dynamics(vessel, visitor); });
  dynamic["thrust"] = Json::array({make_object(style, [&](auto& visitor) { visit_thrust_dynamics(thrust, visitor); })});
  Json mooring = make_object(style, [&](auto& visitor) { visit_mooring_dynamics(line, visitor); });
  const MooringEvent event;
  mooring["events"] = Json::array({make_object(style, [&](auto& visitor) { visit_mooring_event(event, visitor); })});
  dynamic["moorings"] = Json::array({std::move(mooring)});
}

/// Adds the static part of a hull with hydrodynamic coefficients.
void add_hull_units(const UnitStyle& style, Json& statics) {
  const HullResults hull;
  const RadiationEntryResult entry;
  const RadiationGroupResult group;
  const ModeDampingResult mode;
  Json units = make_object(style, [&](auto& visitor) {
    visit_hull(hull, visitor);
    visit_steady_loads(hull, visitor);
  });
  units["radiation"] = Json::array({make_object(style, [&](auto& visitor) { visit_radiation_entry(entry, visitor); })});
  units["fit"] = Json::array({make_object(style, [&](auto& visitor) { visit_radiation_group(group, visitor); })});
  units["damping"] = Json::array({make_object(style, [&](auto& visitor) { visit_mode_damping(mode, visitor); })});
  statics["hull"] = std::move(units);
}

/// Adds the dynamic part of fatigue and of a stinger on hinges.
void add_fatigue_and_stinger_units(const UnitStyle& style, Json& dynamic) {
  const FatigueResults fatigue;
  const FatigueSpot spot;
  const StingerSectionDynamics section;
  dynamic["fatigue"] = make_object(style, [&](auto& visitor) { visit_fatigue(fatigue, visitor); });
  dynamic["fatigue"]["spots"] =
      Json::array({make_object(style, [&](auto& visitor) { visit_fatigue_spot(spot, visitor); })});
  dynamic["stinger"] = make_object(style, [&](auto& visitor) { visit_stinger_dynamics(section, visitor); });
  dynamic["stinger"]["sections"] = Json::array({dynamic["stinger"]});
}

/// Adds the static part of stand-alone lines; the dynamic part follows.
void add_line_units(const UnitStyle& style, Json& statics) {
  const LineResult line;
  const LineEndResult end;
  Json& units = statics["lines"] = Json::array({make_object(style, [&](auto& visitor) { visit_line(line, visitor); })});
  for (const char* name : {"first", "second"}) {
    units[0][name] = make_object(style, [&](auto& visitor) { visit_line_end(end, visitor); });
  }
  const BodyResult body;
  statics["bodies"] = Json::array({make_object(style, [&](auto& visitor) { visit_body(body, visitor); })});
}

void add_line_units_in_time(const UnitStyle& style, Json& dynamic) {
  const LineDynamics line;
  dynamic["lines"] = Json::array({make_object(style, [&](auto& visitor) { visit_line_in_time(line, visitor); })});
  const BodyDynamics body;
  dynamic["bodies"] = Json::array({make_object(style, [&](auto& visitor) { visit_body_in_time(body, visitor); })});
}

Json static_summary_properties(const UnitStyle& style) {
  const StaticResults any;
  Json json;
  json["checks"] = summary_checks(style, any.checks);
  json["static"] = static_part(style, any);
  add_mooring_units(style, json["static"]);
  add_line_units(style, json["static"]);
  return json;
}

Json dynamic_summary_properties(const UnitStyle& style) {
  const StaticResults statics;
  DynamicResults any;
  any.supports.resize(1);
  Json json = static_summary_properties(style);
  json["dynamic"] = dynamic_part(style, statics, any);
  add_mooring_units_in_time(style, json["dynamic"]);
  add_line_units_in_time(style, json["dynamic"]);
  add_fatigue_and_stinger_units(style, json["dynamic"]);
  add_hull_units(style, json["static"]);
  return json;
}

UnitStyle make_unit_style(FieldProperty property) {
  UnitStyle style;
  style.property = property;
  return style;
}

}  // namespace

const Json& summary_units() {
  static const Json kUnits = static_summary_properties(make_unit_style(FieldProperty::dimension));
  return kUnits;
}

const Json& dynamic_summary_units() {
  static const Json kUnits = dynamic_summary_properties(make_unit_style(FieldProperty::dimension));
  return kUnits;
}

const Json& stage_units() {
  static const Json kUnits = [] {
    const UnitStyle style = make_unit_style(FieldProperty::dimension);
    const StageFailure failure;
    Json units = make_object(style, [](auto& stage) {
      const StageResult any;
      visit_lay_stage(any.stage, stage);
      visit_stage_result(any, stage);
    });
    const Json of_failure = make_object(style, [&](auto& visitor) { visit_stage_failure(failure, visitor); });
    for (const auto& [key, unit] : of_failure.items()) units["failure." + key] = unit;
    return units;
  }();
  return kUnits;
}

const Json& stored_summary_units() {
  static const Json kUnits = dynamic_summary_properties(make_unit_style(FieldProperty::unit));
  return kUnits;
}

const Json& summary_descriptions() {
  static const Json kDescriptions = dynamic_summary_properties(make_unit_style(FieldProperty::description));
  return kDescriptions;
}

}  // namespace overbend
