#include "resultfiles/summary/lift_units.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/require.h"
#include "resultfiles/summary/lift_json.h"

namespace overbend {
namespace {

struct LiftNumber {
  std::string_view key;
  const char *unit, *stored, *description;
};

constexpr const char* kEast = "Place, east";
constexpr const char* kNorth = "Place, north";
constexpr const char* kUp = "Place, above the mean water level";

constexpr std::array kNumbers = {
    LiftNumber{"x", "m", "m", kEast},
    LiftNumber{"y", "m", "m", kNorth},
    LiftNumber{"z", "m", "m", kUp},
    LiftNumber{"dx", "m", "m", "Second end less first, east"},
    LiftNumber{"dy", "m", "m", "Second end less first, north"},
    LiftNumber{"dz", "m", "m", "Second end less first, up"},
    LiftNumber{"angle", "rad", "rad",
               "By which the direction turns from the first line to the second, sagging positive"},
    LiftNumber{"arc_length", "m", "m", "Unstressed length from the line's first end"},
    LiftNumber{"arc_length_from", "m", "m", "Where the bed begins to bear the line, from its first end"},
    LiftNumber{"arc_length_to", "m", "m", "Where the bed ceases to bear the line, from its first end"},
    LiftNumber{"inclination", "rad", "rad", "Of the axis going towards the second end, positive downwards"},
    LiftNumber{"tension", "N", "N", "Effective tension; of a davit that at its upper end"},
    LiftNumber{"horizontal_force", "N", "N", "With which the end is pulled outwards"},
    LiftNumber{"vertical_force", "N", "N", "With which the end is held up"},
    LiftNumber{"value", "N*m", "N m", "The largest such moment of the line"},
    LiftNumber{"largest_bending_stress", "N/m^2", "Pa", "Largest bending stress of the steel"},
    LiftNumber{"largest_von_mises", "N/m^2", "Pa", "Largest von Mises stress of the steel"},
    LiftNumber{"largest_tension", "N", "N", "Largest effective tension"},
    LiftNumber{"least_tension", "N", "N", "Least effective tension"},
    LiftNumber{"suspended_length", "m", "m", "Length that the bed does not bear"},
    LiftNumber{"water_crossings", "m", "m", "Unstressed lengths at which the axis crosses the surface"},
    LiftNumber{"length", "m", "m", "Unstressed length"},
    LiftNumber{"tension_upper", "N", "N", "Tension at the upper end"},
    LiftNumber{"tension_lower", "N", "N", "Tension at the lower end"},
    LiftNumber{"from_vertical_upper", "rad", "rad", "Angle from the vertical at the upper end"},
    LiftNumber{"from_vertical_lower", "rad", "rad", "Angle from the vertical at the lower end"},
    LiftNumber{"utilisation", "1", "1", "Tension at the upper end over the breaking load"},
    LiftNumber{"moment", "N*m", "N m", "Bending moment there, sagging positive"},
    LiftNumber{"tension_before", "N", "N", "Of the line there, towards its first end"},
    LiftNumber{"tension_after", "N", "N", "Of the line there, towards its second end"},
    LiftNumber{"shear", "N", "N", "Force of the second line on the first, square to the axis, up"},
    LiftNumber{"shear_before", "N", "N", "Of the line there, towards its first end"},
    LiftNumber{"shear_after", "N", "N", "Of the line there, towards its second end"},
    LiftNumber{"residual", "1", "1", "Largest unbalanced force over the scale of forces"},
};

constexpr std::array kForceOnPipe = {
    LiftNumber{"x", "N", "N", "Force on the line that the davit holds, east"},
    LiftNumber{"y", "N", "N", "Force on the line that the davit holds, north"},
    LiftNumber{"z", "N", "N", "Force on the line that the davit holds, up"},
};

/// A stage with one of everything that may be there.
LiftResults whole_stage() {
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
  const auto found = std::ranges::find(table, key, &LiftNumber::key);
  require(found != table.end(), "every number of a lift has a unit");
  return *found;
}

/// Puts what `told` says of a number in its place; texts become null.
void put_told(Json& json, const std::string& key, bool force, const char* const LiftNumber::*told) {
  if (json.is_structured()) {
    for (auto below = json.begin(); below != json.end(); ++below) {
      put_told(*below, json.is_object() ? below.key() : key, force || key == "force_on_pipe", told);
    }
  } else if (json.is_number()) {
    json = force ? row_of_key(kForceOnPipe, key).*told : row_of_key(kNumbers, key).*told;
  } else {
    json = nullptr;
  }
}

Json told_of_stage(const char* const LiftNumber::*told) {
  Json json = lift_json(whole_stage());
  put_told(json, "", false, told);
  return json;
}

}  // namespace

const Json& lift_stage_units() {
  static const Json kUnits = told_of_stage(&LiftNumber::unit);
  return kUnits;
}

const Json& stored_lift_stage_units() {
  static const Json kUnits = told_of_stage(&LiftNumber::stored);
  return kUnits;
}

const Json& lift_stage_descriptions() {
  static const Json kDescriptions = told_of_stage(&LiftNumber::description);
  return kDescriptions;
}

}  // namespace overbend
