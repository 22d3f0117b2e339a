#include "orcaflex/unit_system.h"

#include <span>

#include "base/text.h"

namespace overbend::orcaflex {
namespace {

struct NamedUnit {
  const char* name;
  double factor;  ///< In SI.
};

constexpr double kFoot = 0.3048, kPound = 0.45359237, kStandardGravity = 9.80665;
constexpr NamedUnit kLengths[] = {{"m", 1.0},    {"mm", 0.001},  {"cm", 0.01},   {"km", 1000.0},
                                  {"ft", kFoot}, {"in", 0.0254}, {"yd", 0.9144}, {"mile", 1609.344}};
constexpr NamedUnit kMasses[] = {{"te", 1000.0},
                                 {"t", 1000.0},
                                 {"kg", 1.0},
                                 {"g", 0.001},
                                 {"lb", kPound},
                                 {"kip", 1000.0 * kPound},
                                 {"ton", 2000.0 * kPound},
                                 {"slug", kPound* kStandardGravity / kFoot}};
constexpr NamedUnit kForces[] = {{"kN", 1000.0},
                                 {"N", 1.0},
                                 {"MN", 1e6},
                                 {"te", 1000.0 * kStandardGravity},
                                 {"kgf", kStandardGravity},
                                 {"lbf", kPound* kStandardGravity},
                                 {"kip", 1000.0 * kPound* kStandardGravity}};

double read_factor(const Object& general, const std::string& key, std::span<const NamedUnit> units) {
  const std::string given = general.text(key);
  std::vector<std::string> names;
  for (const NamedUnit& unit : units) {
    if (given == unit.name) return unit.factor;
    names.emplace_back(unit.name);
  }
  general.reject(key, given.empty() ? "nothing" : "'" + for_display(given) + "'", join_choices(names));
  return 1.0;
}

}  // namespace

UnitSystemOfFile read_units(const std::optional<Object>& general) {
  UnitSystemOfFile units;
  if (!general) return units;
  const std::string system = general->text("UnitsSystem", "SI");
  if (system == "US") {
    units.length = kFoot;
    units.mass = 1000.0 * kPound;
    units.force = 1000.0 * kPound * kStandardGravity;
  } else if (system == "User") {
    units.length = read_factor(*general, "LengthUnits", kLengths);
    units.mass = read_factor(*general, "MassUnits", kMasses);
    units.force = read_factor(*general, "ForceUnits", kForces);
    if (const std::string time = general->text("TimeUnits", "s"); time != "s") {
      general->reject("TimeUnits", "'" + for_display(time) + "'", "'s'");
    }
  } else if (system != "SI") {
    general->reject("UnitsSystem", "'" + for_display(system) + "'", "SI, US or User");
  }
  if (const std::optional<double> gravity = general->number("g")) units.gravity = *gravity * units.length;
  return units;
}

}  // namespace overbend::orcaflex
