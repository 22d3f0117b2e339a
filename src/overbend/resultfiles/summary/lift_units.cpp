#include "resultfiles/summary/lift_units.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/ranges.h"
#include "base/require.h"
#include "resultfiles/summary/lift_json.h"

namespace overbend {
namespace {

struct LiftNumber {
  std::string_view key;
  const char *unit, *stored, *description;
};

constexpr const char* kEast = "Position, east";
constexpr const char* kNorth = "Position, north";
constexpr const char* kUp = "Position, above the mean water level";

constexpr std::array kNumbers = {
    LiftNumber{"x", "m", "m", kEast},
    LiftNumber{"y", "m", "m", kNorth},
    LiftNumber{"z", "m", "m", kUp},
    LiftNumber{"dx", "m", "m", "Second end minus first, east"},
    LiftNumber{"dy", "m", "m", "Second end minus first, north"},
    LiftNumber{"dz", "m", "m", "Second end minus first, up"},
    LiftNumber{"angle", "rad", "rad", "Change of direction from the first line to the second, positive for sagging"},
    LiftNumber{"arc_length", "m", "m", "Unstressed length from the line's first end"},
    LiftNumber{"arc_length_from", "m", "m", "Start of the seabed contact, from the line's first end"},
    LiftNumber{"arc_length_to", "m", "m", "End of the seabed contact, from the line's first end"},
    LiftNumber{"inclination", "rad", "rad", "Inclination of the axis towards the second end, positive downwards"},
    LiftNumber{"tension", "N", "N", "Effective tension; for a davit cable that at its upper end"},
    LiftNumber{"horizontal_force", "N", "N", "Outward horizontal force on the end"},
    LiftNumber{"vertical_force", "N", "N", "Upward vertical force on the end"},
    LiftNumber{"value", "N*m", "N m", "Maximum of this moment along the line"},
    LiftNumber{"largest_bending_stress", "N/m^2", "Pa", "Largest bending stress of the steel"},
    LiftNumber{"largest_von_mises", "N/m^2", "Pa", "Largest von Mises stress of the steel"},
    LiftNumber{"largest_tension", "N", "N", "Largest effective tension"},
    LiftNumber{"least_tension", "N", "N", "Minimum effective tension"},
    LiftNumber{"suspended_length", "m", "m", "Length without seabed contact"},
    LiftNumber{"water_crossings", "m", "m", "Unstressed lengths at which the axis crosses the water surface"},
    LiftNumber{"length", "m", "m", "Unstressed length"},
    LiftNumber{"tension_upper", "N", "N", "Tension at the upper end"},
    LiftNumber{"tension_lower", "N", "N", "Tension at the lower end"},
    LiftNumber{"from_vertical_upper", "rad", "rad", "Angle from the vertical at the upper end"},
    LiftNumber{"from_vertical_lower", "rad", "rad", "Angle from the vertical at the lower end"},
    LiftNumber{"utilisation", "1", "1", "Tension at the upper end over the breaking load"},
    LiftNumber{"moment", "N*m", "N m", "Bending moment there, sagging positive"},
    LiftNumber{"tension_before", "N", "N", "In the line, on the side of its first end"},
    LiftNumber{"tension_after", "N", "N", "In the line, on the side of its second end"},
    LiftNumber{"shear", "N", "N", "Force of the second line on the first, normal to the axis, up"},
    LiftNumber{"shear_before", "N", "N", "In the line, on the side of its first end"},
    LiftNumber{"shear_after", "N", "N", "In the line, on the side of its second end"},
    LiftNumber{"residual", "1", "1", "Largest unbalanced force over the scale of forces"},
};

constexpr std::array kForceOnPipe = {
    LiftNumber{"x", "N", "N", "Force on the line that the davit cable holds, east"},
    LiftNumber{"y", "N", "N", "Force on the line that the davit cable holds, north"},
    LiftNumber{"z", "N", "N", "Force on the line that the davit cable holds, up"},
};

/// Returns a stage with one of everything that may exist.
LiftResults make_complete_stage() {
  LiftResults lift;
  LiftedLine& line = lift.lines.emplace_back();
  line.name = "*";
  line.on_bed.emplace_back();
  line.lift_off.emplace();
  line.water_crossings = {0.0};
  LiftedWire& wire = lift.davits.emplace_back();
  wire.name = "*";
  wire.utilisation = 0.0;
  lift.gap.emplace();
  lift.join.emplace();
  return lift;
}

template <class Table>
const LiftNumber& row_of_key(const Table& table, std::string_view key) {
  const auto found = ranges::find(table, key, &LiftNumber::key);
  require(found != table.end(), "every number of a lift has a unit");
  return *found;
}

/// Sets a member to the unit or description of its number; texts become null.
void put_property(Json& json, const std::string& key, bool force, const char* const LiftNumber::*property) {
  if (json.is_structured()) {
    for (auto below = json.begin(); below != json.end(); ++below) {
      put_property(*below, json.is_object() ? below.key() : key, force || key == "force_on_pipe", property);
    }
  } else if (json.is_number()) {
    json = force ? row_of_key(kForceOnPipe, key).*property : row_of_key(kNumbers, key).*property;
  } else {
    json = nullptr;
  }
}

Json stage_properties(const char* const LiftNumber::*property) {
  Json json = lift_json(make_complete_stage());
  put_property(json, "", false, property);
  return json;
}

}  // namespace

const Json& lift_stage_units() {
  static const Json kUnits = stage_properties(&LiftNumber::unit);
  return kUnits;
}

const Json& stored_lift_stage_units() {
  static const Json kUnits = stage_properties(&LiftNumber::stored);
  return kUnits;
}

const Json& lift_stage_descriptions() {
  static const Json kDescriptions = stage_properties(&LiftNumber::description);
  return kDescriptions;
}

}  // namespace overbend
