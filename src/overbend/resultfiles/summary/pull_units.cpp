#include "resultfiles/summary/pull_units.h"

namespace overbend {

Json pull_stage_units(const Json& lay) {
  Json units = lay;
  const Json pull = {
      {"pipe_out", "m"},
      {"wire_out", "m"},
      {"tension", {{"tensioner", "N"}, {"touchdown", "N"}, {"pipe_end", "N"}, {"head", "N"}, {"winch", "N"}}},
      {"wire_largest_tension", "N"},
      {"wire_utilisation", "1"},
      {"least_tension", "N"},
      {"departure_angle", "rad"},
      {"departure_angle_last_roller", "rad"},
      {"touchdown", {{"x", "m"}, {"arc_length", "m"}}},
      {"head", {{"wire_inclination", "rad"}}},
      {"overbend", {{"moment", "N*m"}, {"stress", "N/m^2"}, {"x", "m"}, {"arc_length", "m"}}},
      {"sagbend", {{"moment", "N*m"}, {"stress", "N/m^2"}, {"x", "m"}, {"arc_length", "m"}}},
      {"lift_off", {{"x", "m"}, {"z", "m"}, {"arc_length_before_winch", "m"}}},
      {"winch", {{"inclination", "rad"}}},
  };
  units.merge_patch(pull);
  return units;
}

}  // namespace overbend
