#include "moorings/static_hull.h"

#include "model/model.h"
#include "model/vessel/mooring_queries.h"

namespace overbend {

StaticHull make_static_hull(const Description& description) {
  const VesselDescription& vessel = description.vessel;
  StaticHull hull;
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

HullEquilibrium trim_ballast(const MooringSpread& spread, StaticHull& hull, const HullOffset& start) {
  const FreeModes horizontal = {true, true, false, false, false, true};
  HullEquilibrium rest = find_hull_equilibrium(spread, hull, start, horizontal);
  if (rest.error) return rest;
  hull.steady.segment<3>(2) -= rest.forces.total.segment<3>(2);
  return find_hull_equilibrium(spread, hull, rest.offset);
}

}  // namespace overbend
