/// Lines that bear no compression, where they fall slack and snap tight, against a chain of lumped masses.
#include <gtest/gtest.h>

#include "mechanics/slack_law.h"
#include "model/pipe/line_types.h"
#include "support/line_cases.h"
#include "support/lumped_chain.h"

namespace overbend {
namespace {

/// A chain from the bed to an end that heaves by more than it can follow.
Description snapping(double element) {
  const testing::LumpedChain chain;
  Description d = testing::water_alone(chain.density, chain.depth);
  d.environment.seabed.stiffness = 100e3;
  d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = chain.friction;
  const double area = (chain.mass * kGravity - chain.weight) / (chain.density * kGravity);
  LineTypeDescription type =
      testing::cable_type(chain.mass, std::sqrt(4.0 / std::numbers::pi * area), chain.EA, 0.0, chain.density);
  type.diameter = type.drag_diameter = chain.diameter;
  type.drag_normal = chain.drag;
  d.lines = {testing::free_line(type, chain.length, chain.anchor, chain.top)};
  d.lines[0].second.amplitude = Vec3(0.0, 0.0, chain.amplitude);
  d.lines[0].second.period = chain.period;
  d.lines[0].element = element;
  d.dynamics.emplace();
  d.dynamics->duration = 24.0;
  d.dynamics->build_up = chain.build_up;
  return d;
}

LineHistory history(const Description& d) {
  return testing::run_lines(d, dynamic_options(build_model(d)))[0];
}

/// Time of the internal damping of a line of this length and speed of sound [s].
double damping_time(const testing::LumpedChain& chain) {
  return 4.0 / std::numbers::pi * kSlackDamping * chain.length * std::sqrt(chain.mass / chain.EA);
}

TEST(chain_that_snaps, pulls_as_lumped_masses_that_only_pull_do_with_elements_of_any_length) {
  testing::LumpedChain lumped;
  lumped.links = 40;
  lumped.damping = damping_time(lumped);
  const std::vector<double> peaks = testing::LumpedChainRun(lumped).peaks(24.0);
  const double max_value = *std::ranges::max_element(peaks);
  for (const double element : {7.5, 5.0}) {
    const LineHistory line = history(snapping(element));
    EXPECT_NEAR(line.max_last_tension, max_value, 0.05 * max_value) << element;
    EXPECT_GT(line.min_last_tension, -1e-4 * max_value) << element;
    EXPECT_GT(*std::ranges::min_element(line.min_tension), -1e-4 * max_value) << element;
  }
}

}  // namespace
}  // namespace overbend
