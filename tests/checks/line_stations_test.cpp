#include "checks/line_stations.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mechanics/stress.h"
#include "modelfile/reading/yaml_reader.h"
#include "study/run/static_run.h"

namespace overbend {
namespace {

struct Lifted {
  Model model;
  StaticResults results;
};

Lifted lifted() {
  const Description d =
      read_model(std::string(OVERBEND_SOURCE_DIR) + "/validation/lift_cases/DL12-three.yaml").description.value();
  Lifted out{build_model(d), {}};
  out.results = run_statics(out.model).results.value();
  return out;
}

/// A run in which nothing moves, and its moments are so many times those at rest.
std::vector<LineDynamics> still_run(const Lifted& lift, double factor) {
  std::vector<LineDynamics> run;
  for (const LineResult& line : lift.results.lines) {
    LineDynamics& still = run.emplace_back();
    still.name = line.name;
    still.largest_tension = line.largest_tension;
    for (const LineNodeResult& node : line.nodes) {
      still.least_at_nodes.push_back(node.tension);
      still.largest_at_nodes.push_back(node.tension);
      const auto& nodes = lift.results.lift->lines[0].nodes;
      const auto at = std::ranges::min_element(
          nodes, {}, [&](const LiftedNode& one) { return std::abs(one.at.arc_length - node.s); });
      still.moment_at_nodes.push_back(factor * std::hypot(at->sagging, at->sideways));
    }
  }
  return run;
}

TEST(line_stations, of_a_run_in_which_nothing_moves_are_those_at_rest) {
  const Lifted lift = lifted();
  const CheckStations rest = line_stations(lift.model, *lift.results.lift).at(0);
  const CheckStations run = line_stations_in_time(lift.model, lift.results, still_run(lift, 1.0)).at(0);
  ASSERT_EQ(rest.stations.size(), run.stations.size());
  for (std::size_t i = 0; i < rest.stations.size(); ++i) {
    // both sides of what hangs there, though a run keeps the tension of one; rounding of the moments is left
    EXPECT_NEAR(run.stations[i].largest_von_mises.value, rest.stations[i].largest_von_mises.value, 1.0);
    EXPECT_NEAR(run.stations[i].largest_tension.value, rest.stations[i].largest_tension.value, 1e-3);
    EXPECT_NEAR(run.stations[i].load.value, rest.stations[i].load.value, 1e-6);
  }
}

// The formulas of the laid pipe at twice the moment.
TEST(line_stations, of_a_run_with_larger_moments_have_their_stress) {
  const Lifted lift = lifted();
  const CheckStations rest = line_stations(lift.model, *lift.results.lift).at(0);
  const CheckStations run = line_stations_in_time(lift.model, lift.results, still_run(lift, 2.0)).at(0);
  const Section pipe = derive_section("", *lift.model.description.lines[0].segments[0].section,
                                      lift.model.description.environment.water_weight_density);
  const auto most = std::ranges::max_element(rest.stations, {}, &CheckStation::moment);
  const CheckStation& there = run.stations[static_cast<std::size_t>(most - rest.stations.begin())];
  SectionLoads loads;
  loads.effective_tension = most->force;
  loads.bending_moment = 2.0 * most->moment;
  loads.curvature = loads.bending_moment / pipe.EI;
  loads.external_pressure = most->external_pressure;
  EXPECT_NEAR(there.largest_von_mises.value, section_stress(pipe, loads).von_mises,
              2e-3 * there.largest_von_mises.value);
  EXPECT_GT(there.load.value, 1.5 * most->load.value) << "by the square of the moment or so, with the larger factor";
}

}  // namespace
}  // namespace overbend
