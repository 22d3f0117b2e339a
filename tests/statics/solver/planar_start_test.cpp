#include "statics/solver/planar_start.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/current_effect.h"

namespace overbend {
namespace {

Model bgl1_in_current() {
  return build_model(read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value());
}

Vec3 node_place(const StaticSolution& solution, int node) {
  return Vec3(solution.state.q.data() + 6 * node);
}

}  // namespace

TEST(flat_start, lies_in_the_plane_of_the_route_with_every_chord_as_long_and_as_high) {
  const Model model = bgl1_in_current();
  const StaticSolution lay = solve_statics(model).solution.value();
  const StaticSolution flat = flattened_lay(model, lay);
  const LayPlane plane = lay_plane(model, model.mean_pose);
  double aside = 0.0;
  for (int node = 0; node + 1 < lay.mesh.nodes(); ++node) {
    const Vec3 before = node_place(lay, node + 1) - node_place(lay, node);
    const Vec3 after = node_place(flat, node + 1) - node_place(flat, node);
    EXPECT_NEAR(after.norm(), before.norm(), 1e-10);
    EXPECT_NEAR(after.z(), before.z(), 1e-10);
    EXPECT_NEAR((node_place(flat, node) - plane.tensioner_W).dot(plane.port_W), 0.0, 1e-9);
    aside = std::max(aside, std::abs((node_place(lay, node) - plane.tensioner_W).dot(plane.port_W)));
  }
  EXPECT_GT(aside, 0.1);  // the current has pushed it
}

TEST(flat_start, leads_to_the_lay_in_still_water_that_is_found_from_nothing) {
  const Model model = bgl1_in_current();
  const Model at_rest = without_current(model);
  const StaticOutcome neighbour = solve_still_water_lay(at_rest, solve_statics(model).solution.value());
  const StaticOutcome alone = solve_statics(at_rest);
  EXPECT_EQ(neighbour.solution->report.method, "newton, from the last solution");
  ASSERT_EQ(neighbour.solution->state.q.size(), alone.solution->state.q.size());
  for (std::size_t i = 0; i < alone.solution->state.q.size(); ++i) {
    EXPECT_NEAR(neighbour.solution->state.q[i], alone.solution->state.q[i], 1e-7);
  }
}

}  // namespace overbend
