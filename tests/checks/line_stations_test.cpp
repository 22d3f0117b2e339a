#include "checks/line_stations.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mechanics/stress.h"
#include "modelfile/reading/yaml_reader.h"
#include "study/run/static_analysis.h"

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
std::vector<LineDynamics> run_at_rest(const Lifted& lift, double factor) {
  std::vector<LineDynamics> run;
  for (const LineResult& line : lift.results.lines) {
    LineDynamics& at_rest = run.emplace_back();
    at_rest.name = line.name;
    at_rest.max_tension = line.max_tension;
    for (const LineNodeResult& node : line.nodes) {
      at_rest.min_tension_at_nodes.push_back(node.tension);
      at_rest.max_tension_at_nodes.push_back(node.tension);
      const auto& nodes = lift.results.lift->lines[0].nodes;
      const auto sample = std::ranges::min_element(
          nodes, {}, [&](const LiftedNode& lifted_node) { return std::abs(lifted_node.location.arc_length - node.s); });
      at_rest.moment_at_nodes.push_back(factor * std::hypot(sample->sagging, sample->sideways));
    }
  }
  return run;
}

TEST(line_stations, of_a_run_in_which_nothing_moves_are_those_at_rest) {
  const Lifted lift = lifted();
  const CheckStations rest = line_stations(lift.model, *lift.results.lift).at(0);
  const CheckStations run = line_stations_in_time(lift.model, lift.results, run_at_rest(lift, 1.0)).at(0);
  ASSERT_EQ(rest.stations.size(), run.stations.size());
  for (std::size_t i = 0; i < rest.stations.size(); ++i) {
    // both sides of what hangs there, though a run keeps the tension of one; rounding of the moments is left
    EXPECT_NEAR(run.stations[i].max_von_mises.value, rest.stations[i].max_von_mises.value, 1.0);
    EXPECT_NEAR(run.stations[i].max_tension.value, rest.stations[i].max_tension.value, 1e-3);
    EXPECT_NEAR(run.stations[i].load.value, rest.stations[i].load.value, 1e-6);
  }
}

// The formulas of the laid pipe at twice the moment.
TEST(line_stations, of_a_run_with_larger_moments_have_their_stress) {
  const Lifted lift = lifted();
  const CheckStations rest = line_stations(lift.model, *lift.results.lift).at(0);
  const CheckStations run = line_stations_in_time(lift.model, lift.results, run_at_rest(lift, 2.0)).at(0);
  const Section pipe = derive_section("", *lift.model.description.lines[0].segments[0].section,
                                      lift.model.description.environment.water_weight_density);
  const auto max_value = std::ranges::max_element(rest.stations, {}, &CheckStation::moment);
  const CheckStation& check_station = run.stations[static_cast<std::size_t>(max_value - rest.stations.begin())];
  SectionLoads loads;
  loads.effective_tension = max_value->force;
  loads.bending_moment = 2.0 * max_value->moment;
  loads.curvature = loads.bending_moment / pipe.EI;
  loads.external_pressure = max_value->external_pressure;
  EXPECT_NEAR(check_station.max_von_mises.value, section_stress(pipe, loads).von_mises,
              2e-3 * check_station.max_von_mises.value);
  EXPECT_GT(check_station.load.value, 1.5 * max_value->load.value)
      << "by the square of the moment or so, with the larger factor";
}

}  // namespace
}  // namespace overbend
