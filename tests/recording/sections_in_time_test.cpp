/// Pipe of several sections, and what is built into it, in whole dynamic analyses of BGL-1 on a coarse mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "checks/check_station.h"
#include "recording/node_recovery.h"
#include "recording/run_dynamics.h"
#include "statics/equations/static_system.h"
#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

using testing::EmptySink;
using testing::MemorySink;
using testing::TimedLay;
using testing::workable;

/// Two metres of thick wall over the stinger.
Description with_arrestor() {
  Description d = workable();
  SegmentDescription pipe{"pipe", 60.0, d.pipe.section}, arrestor{"arrestor", 2.0, d.pipe.section};
  arrestor.section.steel.wall_thickness = 0.038;
  d.pipe.segments = {pipe, arrestor};
  return d;
}

TEST(moving_sections, the_recovery_in_time_agrees_with_that_of_statics) {
  for (const Description& d : {workable(), with_arrestor()}) {
    const TimedLay c(d);
    MemorySink sink;
    const DynamicResults r = c.results(sink);
    ASSERT_TRUE(c.statics.overbend);
    const double moment = c.statics.overbend->bending_moment.value;
    int compared = 0;
    for (std::size_t i = 0; i < r.station_s.size(); ++i) {
      for (const Station& station : c.statics.stations) {
        if (std::abs(station.s - r.station_s[i]) > 1e-9) continue;
        ++compared;
        if (station.s < 20.0) continue;  // what statics holds at its far end goes on into the laid pipe
        EXPECT_NEAR(r.static_tension[i], station.effective_tension, 1e-6 * c.statics.top_tension) << station.s;
        // The moment under a roller inside an element stands at the nearer node.
        EXPECT_GE(r.static_moment[i], station.bending_moment - 1e-6 * moment) << station.s;
      }
    }
    EXPECT_EQ(compared, static_cast<int>(r.station_s.size()));
    EXPECT_NEAR(*std::max_element(r.static_moment.begin(), r.static_moment.end()), moment, 1e-6 * moment);
    for (std::size_t i = 0; i < r.supports.size(); ++i) {
      EXPECT_NEAR(r.supports[i].static_reaction, c.statics.supports[i].reaction, 1.0);  // [N], where they are 50 kN
    }
  }
}

TEST(moving_sections, tension_passes_a_change_of_section_without_a_ripple) {
  const TimedLay c(with_arrestor());
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  const std::vector<double>& max_value = r.effective_tension.max;
  const double arrestor = r.station_s.back() - 61.0;
  for (std::size_t i = 1; i + 1 < max_value.size(); ++i) {
    if (std::abs(r.station_s[i] - arrestor) < 10.0) {
      EXPECT_NEAR(max_value[i], 0.5 * (max_value[i - 1] + max_value[i + 1]), 0.02 * max_value[i]) << r.station_s[i];
    }
  }
}

TEST(moving_sections, at_a_change_of_section_stresses_are_those_of_the_softer_side) {
  const TimedLay c(with_arrestor());
  MemorySink sink;
  const DynamicResults r = c.results(sink);
  const Section& pipe = c.model.sections.front();
  int ends = 0;
  for (std::size_t i = 0; i < r.station_s.size(); ++i) {
    const double from_top = r.station_s.back() - r.station_s[i];
    if (std::abs(from_top - 60.0) > 1e-6 && std::abs(from_top - 62.0) > 1e-6) continue;
    ++ends;
    const double by_hand = r.bending_moment.max[i] * 0.5 * pipe.steel_diameter / pipe.second_moment;
    EXPECT_NEAR(r.bending_stress.max[i], by_hand, 1e-9 * by_hand) << from_top;
  }
  EXPECT_EQ(ends, 2);
}

TEST(moving_sections, a_built_in_structure_is_in_no_maximum_and_the_pipe_at_its_ends_is) {
  Description d = workable();
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::fixed;
  StructureDescription tee;
  tee.name = "tee";
  tee.at = 150.0;
  tee.length = 6.0;
  tee.weight_in_air = 60e3;
  tee.weight_submerged = 40e3;
  tee.bending_stiffness = 5e8;  // nine times the pipe's
  d.pipe.structures = {tee};
  const TimedLay c(d);
  EmptySink sink;
  const DynamicResults run = c.results(sink);
  const RegionResult& rest = c.statics.sagbend;
  EXPECT_GT(c.statics.structures.at(0).bending_moment, 1.02 * rest.bending_moment.value);
  EXPECT_NEAR(run.sagbend.bending_moment.over_time.max, rest.bending_moment.value, 2e-3 * rest.bending_moment.value);
  EXPECT_NEAR(run.sagbend.von_mises.over_time.max, rest.von_mises.value, 2e-3 * rest.von_mises.value);
  const auto stress = [](const CheckTable& table) {
    return std::ranges::find_if(table.rows,
                                [](const CheckRow& row) {
                                  return row.id == "dnv_equivalent_stress" && row.region == CheckRegion::sagbend;
                                })
        ->utilisation;
  };
  EXPECT_NEAR(stress(run.checks), stress(c.statics.checks), 2e-3 * stress(c.statics.checks));
}

TEST(moving_sections, the_checks_at_a_change_of_section_are_of_the_side_whose_stresses_are_reported) {
  const TimedLay c(with_arrestor());
  EmptySink sink;
  const DynamicResults run = c.results(sink);
  const CheckStations all = dynamic_stations(c.model, c.statics, run);
  int ends = 0;
  for (const CheckStation& check_station : all.stations) {
    if (std::abs(check_station.from_top - 60.0) > 1e-6 && std::abs(check_station.from_top - 62.0) > 1e-6) continue;
    ++ends;
    EXPECT_EQ(all.section_for(check_station).wall.thickness, c.model.sections.front().wall_thickness)
        << check_station.from_top;
  }
  EXPECT_EQ(ends, 2);
}

TEST(moving_sections, where_grades_of_the_same_wall_meet_stresses_are_held_against_the_lower) {
  for (const double grade : {360e6, 450e6}) {
    Description d = with_arrestor();
    d.pipe.segments[1].section.steel = d.pipe.section.steel;
    d.pipe.segments[1].section.steel.yield_stress = grade;
    const TimedLay c(d);
    const StaticSystem system = system_with_history(c.model, c.start.mesh, {});
    const NodeRecovery recovery(c.model, system.line());
    int ends = 0;
    for (std::size_t node = 0; node < c.start.mesh.s.size(); ++node) {
      const double from_top = c.start.mesh.total_length() - c.start.mesh.s[node];
      if (std::abs(from_top - 60.0) > 1e-6 && std::abs(from_top - 62.0) > 1e-6) continue;
      ++ends;
      const std::size_t section = static_cast<std::size_t>(recovery.sections()[node]);
      EXPECT_EQ(c.model.sections[section].yield_stress, std::min(grade, 414e6)) << from_top;
    }
    EXPECT_EQ(ends, 2);
  }
}

}  // namespace
}  // namespace overbend
