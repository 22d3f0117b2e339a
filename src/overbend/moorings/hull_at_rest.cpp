#include "moorings/hull_at_rest.h"

#include "model/model.h"
#include "model/vessel/station.h"

namespace overbend {

HullAtRest hull_at_rest(const Description& description) {
  const VesselDescription& vessel = description.vessel;
  HullAtRest hull;
  hull.axes_WD = vessel_axes(vessel.heading, 0.0, 0.0);
  hull.heel = vessel.heel;
  hull.pitch = -vessel.trim;
  hull.length = vessel.length;
  hull.loads = vessel.loads;
  if (vessel.hydrostatics) {
    const HydrostaticsDescription& water = *vessel.hydrostatics;
    hull.restoring = Vec3(water.heave, water.roll, water.pitch).asDiagonal();
  } else if (vessel.coupled && vessel.coupled->data) {
    hull.restoring = vessel.coupled->data->hydrostatic_stiffness.block<3, 3>(2, 2);
    hull.restoring_point_V = vessel.coupled->data->origin_V;
  }
  if (is_positioned(description)) {
    const Vec3 point = vessel.coupled ? vessel.coupled->centre_of_gravity : Vec3::Zero();
    hull.station = {point, Vec3::Zero(), *description.station_keeping};
  }
  return hull;
}

RestOutcome trim_ballast(const MooringSpread& spread, HullAtRest& hull, const HullOffset& at) {
  const FreeModes horizontal = {true, true, false, false, false, true};
  RestOutcome rest = find_rest(spread, hull, at, horizontal);
  if (rest.fault) return rest;
  hull.steady.segment<3>(2) -= rest.forces.total.segment<3>(2);
  return find_rest(spread, hull, rest.offset);
}

}  // namespace overbend
