/// The representative mooring of BGL-1 and its hull held level: surge, sway and yaw alone.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "moorings/mooring_fixtures.h"
#include "moorings/planner.h"
#include "moorings/static_hull.h"

namespace overbend {

inline Description bgl1_barge() {
  Description d = reference_barge();
  d.vessel.hydrostatics = HydrostaticsDescription{1e14, 1e18, 1e18};
  const double ahead = 57.0, side = 15.0, up = 3.0, weight = barge_wire_submerged();
  // Port bow anticlockwise: bearings -25, -65, -115, -155, 155, 115, 65, 25 deg.
  for (const double bearing : {-25.0, -65.0, -115.0, -155.0, 155.0, 115.0, 65.0, 25.0}) {
    const Vec3 fairlead(std::abs(bearing) < 90.0 ? ahead : -ahead, bearing < 0.0 ? side : -side, up);
    d.moorings->lines.push_back(
        mooring_line("line", fairlead, 90.0 + bearing, 1000.0, 300e3,
                     {make_segment(std::nullopt, weight, weight, 4.04e10 * 0.064 * 0.064, 2594e3)}));
  }
  return d;
}

/// The barge of a description in its place.
struct MooredCase {
  MooringSpread spread;
  StaticHull hull;
};
inline MooredCase moored_case(const Description& d) {
  const StaticHull hull = make_static_hull(d);
  const SeabedSurface bed(Vec3(0.0, 0.0, -d.environment.water_depth), Vec3::UnitZ());
  SpreadOutcome outcome = build_spread(*d.moorings, bed, make_hull_place(hull, HullOffset::Zero()).R_WV);
  EXPECT_FALSE(outcome.error) << *outcome.error;
  return {std::move(outcome.spread), hull};
}

/// The barge with its pipe's pull taken up by the lines; `wished`: pulls of the lines as drawn.
struct BargeAtWork : MooredCase {
  Eigen::VectorXd wished;

  BargeAtWork() : MooredCase(moored_case(bgl1_barge())) {
    std::vector<CatenarySolution> drawn;
    hull_forces(spread, hull, HullOffset::Zero(), drawn);
    wished = horizontal_pulls(spread, drawn);
    hull.loads = {vessel_load("pipe", {0, 0, 0}, {-205.6e3, 0, 0})};
    plan_lengths(spread, hull, HullOffset::Zero(), wished);
  }
};

}  // namespace overbend
