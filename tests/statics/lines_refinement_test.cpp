/// Forces and stiffness of a line of equal elements against the elastic catenary, finer and finer.
#include <gtest/gtest.h>

#include "mechanics/element_constants.h"
#include "moorings/catenary.h"
#include "support/line_cases.h"

namespace overbend {
namespace {

constexpr double kLength = 1007.339, kUp = 92.0;

Description wire(double across, double depth) {
  Description d = testing::water_alone(1025.0, depth);
  const LineTypeDescription type = testing::cable_type(16.3418, 0.0512, 165.48e6, 2e3, 1025.0);
  d.lines = {testing::free_line(type, kLength, Vec3(0.0, 0.0, -100.0), Vec3(across, 0.0, kUp - 100.0))};
  return d;
}

struct Pull {
  double horizontal, vertical;  ///< [N]
};

/// At rest on equal elements.
Pull pull(double across, double depth, int elements) {
  const Model model = build_model(wire(across, depth));
  LinesSetup setup = lines_setup(model);
  const LineTypeDescription& type = model.description.lines[0].segments[0].type;
  Line& line = setup.system.lines[0];
  line.mesh = {};
  for (int i = 0; i <= elements; ++i) line.mesh.s.push_back(kLength * i / elements);
  line.mesh.length.assign(static_cast<std::size_t>(elements), kLength / elements);
  line.mesh.section.assign(static_cast<std::size_t>(elements), 0);
  line.elements = make_elements_by_kind(line.mesh.length, line.mesh.section, {cable_constants(model, type)});
  const CableParts parts{model.description.lines[0].segments, {}};
  setup.start[0] =
      make_cable_shape(model, parts, Vec3(0.0, 0.0, -100.0), Vec3(across, 0.0, kUp - 100.0)).shape(line.mesh);
  Assembly assembly(setup.system);
  SystemState state = make_initial_state(setup, 0.0);
  EXPECT_TRUE(solve_lines_one_by_one(assembly, state).converged());
  const std::array<double, 6>& force = assembly.line(0).end_force(LineEnd::last);
  return {force[0], force[2]};
}

Pull exact(double across, bool bed) {
  const LineTypeDescription type = testing::cable_type(16.3418, 0.0512, 165.48e6, 2e3, 1025.0);
  const CatenarySite site{kUp - 100.0, -100.0, bed, -100.0, 0.0};
  const CatenarySolution catenary_solution =
      solve_catenary(catenary_line({{"", kLength, type}}, {}, 0.0, kGravity), site, across);
  return {catenary_solution.pull, catenary_solution.sink};
}

// Over half a metre either way: by less the stiffness of equal elements swings by a percent, as touchdown goes from one
// of their integration points to the next. From 40 elements on the bed's stiffness alone is left.
TEST(lines_refinement, on_the_bed_forces_and_stiffness_of_twenty_elements_are_those_of_the_catenary) {
  const Pull reference = exact(1000.0, true);
  ASSERT_NEAR(1e-3 * reference.horizontal, 287.17, 0.1);  // of 139.6 N/m
  constexpr double kHalf = 0.5;
  const double stiffness =
      (exact(1000.0 + kHalf, true).horizontal - exact(1000.0 - kHalf, true).horizontal) / (2.0 * kHalf);
  ASSERT_NEAR(1e-3 * stiffness, 45.95, 0.5);
  struct Row {
    int elements;
    double force, stiffness;  ///< Tolerances [-].
  };
  for (const Row& row : {Row{10, 1e-3, 1e-2}, Row{20, 5e-4, 1e-3}, Row{40, 2e-4, 2e-4}}) {
    const Pull end_pull = pull(1000.0, 100.0, row.elements);
    EXPECT_NEAR(end_pull.horizontal / reference.horizontal, 1.0, row.force) << row.elements;
    EXPECT_NEAR(end_pull.vertical / reference.vertical, 1.0, row.force) << row.elements;
    const double found =
        (pull(1000.0 + kHalf, 100.0, row.elements).horizontal - pull(1000.0 - kHalf, 100.0, row.elements).horizontal) /
        (2.0 * kHalf);
    EXPECT_NEAR(found / stiffness, 1.0, row.stiffness) << row.elements;
  }
}

TEST(lines_refinement, a_suspended_line_converges_with_the_fourth_order_of_its_elements) {
  const Pull reference = exact(900.0, false);
  const auto error = [&](int elements) {
    return std::abs(pull(900.0, 1000.0, elements).horizontal - reference.horizontal);
  };
  const double coarse = error(4), fine = error(8);
  EXPECT_LT(fine, 1e-5 * reference.horizontal);
  EXPECT_GT(coarse / fine, 12.0);  // 2^4 but for the bending stiffness at the ends
}

}  // namespace
}  // namespace overbend
