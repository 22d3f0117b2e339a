/// Mooring lines of elements at the start of a run: as the catenaries of statics have them, pulled in over the bed.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dynamics/machines/mooring_tension.h"
#include "dynamics/run/simulation.h"
#include "model/pipe/line_types.h"
#include "support/moored_lay.h"

namespace overbend {
namespace {

LineTypeDescription soft_rope() {
  LineTypeDescription rope;
  rope.name = "rope";
  rope.diameter = 0.16;
  rope.weight_in_air = 180.0;
  rope.weight_submerged = 45.0;
  rope.axial_stiffness = 6e7;
  return rope;
}

LineTypeDescription in_water(LineTypeDescription type) {
  type.weight_submerged = submerged_weight(type, 1025.0 * kGravity);
  return type;
}

/// BGL-1 without a pipe in calm water, all eight lines of `type`, with what friction they have on the bed.
Description barge_on(const LineTypeDescription& type, double friction) {
  Description d = testing::coarse_example("moored-barge", 1.0, 0.0);
  d.environment.waves.front().type = WaveType::none;
  d.environment.current.clear();
  for (MooringLineDescription& line : d.moorings->lines) {
    for (LineSegmentDescription& segment : line.segments) {
      segment.type = type;
      segment.type.friction = friction;
    }
  }
  return d;
}

/// Studless chain of `length` from a bar of `diameter` before the anchor of every line.
void add_chain_end(Description& d, double length, double diameter, double friction) {
  for (MooringLineDescription& line : d.moorings->lines) {
    LineSegmentDescription end = line.segments.front();
    end.length = length;
    end.type = in_water(chain(diameter, ChainLink::studless));
    end.type.friction = friction;
    line.segments.push_back(end);
  }
}

void expect_statics_at_start(const Description& d, double share) {
  const testing::SolvedHull solved_hull(d);
  Simulation simulation(solved_hull.model, solved_hull.start(), 0.0, dynamic_options(solved_hull.model));
  ASSERT_FALSE(simulation.failure()) << simulation.failure()->what;
  Simulation& run = simulation;
  for (std::size_t i = 0; i < d.moorings->lines.size(); ++i) {
    const MooringLineResult& rest = solved_hull.rest.moorings->rest.moorings[i];
    const double tension = mooring_tension(*run.present().assembly, *run.present().state, i, LineEnd::last);
    const double anchor = mooring_tension(*run.present().assembly, *run.present().state, i, LineEnd::first);
    EXPECT_NEAR(tension, rest.fairlead_tension, share * rest.fairlead_tension) << rest.name;
    EXPECT_NEAR(anchor, rest.anchor_tension, 2.0 * share * rest.fairlead_tension) << rest.name;
  }
}

/// Friction that takes the whole tension before the anchor: what lies slack there is held by the bed and by nothing
/// else, also where a current would carry it off.
TEST(mooring_start, of_chain_start_with_the_tensions_of_statics_on_a_bed_that_holds_their_ends) {
  Description d = barge_on(in_water(chain(0.06, ChainLink::studless)), 1.0);
  expect_statics_at_start(d, 0.01);
  d.environment.current = {{0.0, 0.1, 0.5}, {d.environment.water_depth, 0.1, 0.5}};
  d.vessel.coupled->current = {};
  d.vessel.coupled->current.form = HullCurrentModel::none;
  expect_statics_at_start(d, 0.02);
}

/// Across a slope that friction holds them on they lie as in statics, not in a bow downhill.
TEST(mooring_start, on_a_slope_start_with_the_tensions_of_statics) {
  Description d = barge_on(in_water(chain(0.06, ChainLink::studless)), 0.25);
  d.environment.seabed.slope = 0.1;
  d.environment.seabed.slope_towards = 0.5 * std::numbers::pi;
  expect_statics_at_start(d, 0.01);
}

/// Points of the bed now stick and now slide, from one step of Newton's method to the next.
TEST(mooring_start, come_to_rest_in_a_current_whatever_the_friction_of_the_bed) {
  for (const double friction : {0.3, 0.6}) {
    for (const double speed : {0.3, 1.0}) {
      SCOPED_TRACE(::testing::Message() << "friction " << friction << ", current " << speed << " m/s");
      Description d = barge_on(in_water(wire_rope(0.064, RopeCore::wire)), friction);
      d.environment.current = {{0.0, speed, 0.5}, {d.environment.water_depth, speed, 0.5}};
      d.vessel.coupled->current = {};
      d.vessel.coupled->current.form = HullCurrentModel::none;
      const testing::SolvedHull solved_hull(d);
      Simulation simulation(solved_hull.model, solved_hull.start(), 0.0, dynamic_options(solved_hull.model));
      ASSERT_FALSE(simulation.failure()) << simulation.failure()->what;
      EXPECT_LT(simulation.present().state->bodies.at(0).acc.head<3>().norm(), 1e-6 * kGravity);
      if (speed < 0.5) expect_statics_at_start(d, 0.02);  // of less than a metre's bow
    }
  }
}

/// Lines of little tension, of which much lies: all at once they would be thrown about on the bed and reach equilibrium
/// elsewhere, from where the barge would have to go tens of metres.
TEST(mooring_start, of_little_tension_come_to_rest_in_a_current_where_statics_have_them) {
  for (const double tension : {100e3, 140e3}) {
    for (const double speed : {0.3, 0.51}) {
      SCOPED_TRACE(::testing::Message() << "tension " << tension << " N, current " << speed << " m/s");
      Description d = testing::coarse_example("moored-barge", 1.0, 0.0);
      d.environment.waves.front().type = WaveType::none;
      d.environment.current = {{0.0, speed, 0.0}, {d.environment.water_depth, 0.3, 0.0}};
      for (MooringLineDescription& line : d.moorings->lines) line.tension = tension;
      expect_statics_at_start(d, 0.06);  // which leave out the current on the lines
    }
  }
}

/// Chain of little friction on the bed, and wire of more that hangs: what lies has that of the chain.
TEST(mooring_start, rub_on_the_bed_by_the_friction_of_what_lies_there) {
  Description d = barge_on(in_water(wire_rope(0.076, RopeCore::wire)), 0.9);
  add_chain_end(d, 650.0, 0.06, 0.2);
  expect_statics_at_start(d, 0.01);
}

/// A rope that stretches by a hundredth, and chain from where it comes near the bed.
TEST(mooring_start, of_rope_and_chain_start_with_the_tensions_of_statics) {
  Description d = barge_on(in_water(chain(0.06, ChainLink::studless)), 1.0);
  LineTypeDescription rope = soft_rope();
  rope.friction = 0.6;
  for (MooringLineDescription& line : d.moorings->lines) {
    LineSegmentDescription chain_end = line.segments.front();
    chain_end.length = 700.0;
    line.segments.front().type = rope;
    line.segments.push_back(chain_end);
  }
  expect_statics_at_start(d, 0.02);
}

/// Rope of less than half the thickness of the chain that it lies before: it lies lower on the line's one bed, and the
/// bed holds it as it holds the chain.
TEST(mooring_start, of_thin_rope_and_thick_chain_on_the_bed_start_with_the_tensions_of_statics) {
  Description d = barge_on(in_water(wire_rope(0.064, RopeCore::wire)), 1.0);
  add_chain_end(d, 200.0, 0.076, 1.0);
  expect_statics_at_start(d, 0.02);
}

/// At the joint of rope and chain their stretch differs thirtyfold, and a buoy turns the line by its pull: neither may
/// reach into the neighbouring long elements.
TEST(mooring_start, of_taut_rope_between_chains_start_with_the_tensions_of_statics) {
  Description d = barge_on(in_water(chain(0.06, ChainLink::studlink)), 0.0);
  const LineTypeDescription rope = soft_rope();
  d.environment.water_depth = 1000.0;
  for (MooringLineDescription& line : d.moorings->lines) {
    line.tension = 8e5;
    const double ahead = line.anchor_distance.value();
    LineSegmentDescription end = line.segments.front();
    line.segments.front().length.reset();
    end.length = 100.0;
    line.segments.push_back(end);
    line.segments.push_back(end);
    line.segments[1].type = rope;
    line.segments[1].length = 0.9 * std::hypot(ahead, d.environment.water_depth);
  }
  expect_statics_at_start(d, 5e-4);
}

TEST(mooring_start, with_buoys_start_with_the_tensions_of_statics) {
  Description d = barge_on(in_water(wire_rope(0.076, RopeCore::wire)), 0.0);
  for (MooringLineDescription& line : d.moorings->lines) {
    LinePointDescription buoy;
    buoy.kind = PointKind::buoy;
    buoy.at = 300.0;
    buoy.net_force = 60e3;
    buoy.mass = 2000.0;
    buoy.volume = 8.0;
    line.points.push_back(buoy);
    line.tension.reset();
    line.segments.front().length = 1.004 * std::hypot(line.anchor_distance.value(), d.environment.water_depth);
  }
  expect_statics_at_start(d, 2e-3);
}

}  // namespace
}  // namespace overbend
