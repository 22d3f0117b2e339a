// Structures in the line against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "statics/recovery/recovery.h"
#include "statics/solver/statics.h"
#include "support/fixtures.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

/// A bar of steel, hung from the water line: its bending length is a hundredth of its sagbend, so that catenaries hold.
Description suspended_bar() {
  Description d = testing::plain_description();
  d.environment.water_depth = 400.0;
  d.pipe.section = {};
  d.pipe.section.steel = {0.06, 0.029, 207e9, 0.3, 414e6, std::nullopt, 77e3, {}};
  d.vessel.stern_shoe_z = 0.0;
  d.tensioner.x = 0.0;
  d.tensioner.z = 0.0;
  d.tensioner.guide = Guide::pinned;
  d.tensioner.tension = 100e3;
  return d;
}

StructureDescription structure(double position, double length, const Section& pipe) {
  StructureDescription s;
  s.name = "tee";
  s.at = position;
  s.length = length;
  s.weight_in_air = pipe.weight_in_air * length;
  s.weight_submerged = pipe.weight_submerged * length;
  return s;
}

StaticResults solved(const Description& description) {
  const Model model = build_model(description);
  const StaticOutcome outcome = solve_statics(model);
  return recover_statics(model, outcome.solution.value());
}

Section pipe_section(const Description& d) {
  return build_model(d).sections.front();
}

/// Height between the ends of a catenary piece of horizontal tension H whose vertical force grows from `low` to `high`.
double rise(double H, double w, double low, double high) {
  return (std::hypot(H, high) - std::hypot(H, low)) / w;
}

/// Horizontal tension of a catenary of weight w under the tension T at its top, `height` above touchdown, with a point
/// weight P at the length `at` below the top.
double pull_with_weight(double T, double w, double P, double position, double height) {
  double low = 0.0, high = T;
  for (int i = 0; i < 200; ++i) {
    const double H = 0.5 * (low + high);
    const double top = std::sqrt(T * T - H * H);  // vertical force
    const double above = top - w * position;      // at the weight, on its upper side
    const double h = rise(H, w, above, top) + rise(H, w, 0.0, above - P);
    (h > height ? low : high) = H;  // more pull, less height
  }
  return 0.5 * (low + high);
}

}  // namespace

TEST(structures_at_rest, weight_of_the_line_is_that_of_pipe_and_structure) {
  Description d = suspended_bar();
  const StaticResults plain = solved(d);
  const Section pipe = pipe_section(d);
  d.pipe.length = plain.total_length;
  StructureDescription tee = structure(150.0, 4.0, pipe);
  tee.weight_in_air += 12e3;
  tee.weight_submerged += 9e3;
  d.pipe.structures = {tee};
  const StaticResults heavy = solved(d);
  EXPECT_NEAR(-heavy.sum_weight.z(), pipe.weight_in_air * plain.total_length + 12e3, 1e-6 * plain.total_weight);
  EXPECT_NEAR(heavy.sum_buoyancy.z(), (pipe.weight_in_air - pipe.weight_submerged) * plain.total_length + 3e3,
              1e-3 * 12e3);  // the topmost metre is at the water line
  EXPECT_LT(heavy.global_residual, 1e-7);
}

TEST(structures_at_rest, point_weight_in_a_suspended_line_is_that_of_two_catenaries) {
  Description d = suspended_bar();
  const Section pipe = pipe_section(d);
  constexpr double kLength = 1.0, kAt = 200.0, kExtra = 8e3;
  StructureDescription tee = structure(kAt, kLength, pipe);
  tee.weight_in_air += kExtra;
  tee.weight_submerged += kExtra;
  d.pipe.structures = {tee};
  const StaticResults results = solved(d);
  const double height = results.stations.back().p_W.z() - results.touchdown.p_W.z();
  const double pull = pull_with_weight(*d.tensioner.tension, pipe.weight_submerged, kExtra, kAt, height);
  EXPECT_NEAR(results.bottom_tension, pull, 2e-3 * pull);
  const StructureResult& found = results.structures.at(0);
  const double top = std::sqrt(*d.tensioner.tension * *d.tensioner.tension - pull * pull);
  const double depth = rise(pull, pipe.weight_submerged, top - pipe.weight_submerged * kAt, top);
  EXPECT_NEAR(-found.p_W.z(), depth, 0.3);  // of 180 m; the bar stretches by 0.03 % and bends
  EXPECT_NEAR(found.from_top, kAt, 1e-9);
  // Without it the pull is another: the weight has to be seen.
  EXPECT_GT(std::abs(pull_with_weight(*d.tensioner.tension, pipe.weight_submerged, 0.0, kAt, height) - pull),
            0.05 * pull);
}

// A rigid piece of length 2a in a line of curvature k0 leaves the turn 2 a k0 to the pipe on its two sides, over the
// bending length sqrt(EI/T) each: curvature there k0 (1 + a / sqrt(EI/T)).
TEST(structures_at_rest, pipe_next_to_a_stiff_structure_bends_more_by_the_beam_under_tension) {
  Description d = suspended_bar();
  d.tensioner.tension = 90e3;
  const Section pipe = pipe_section(d);
  const StaticResults plain = solved(d);
  const double position = plain.length_top_to_touchdown - 45.0;
  const double s = plain.total_length - position;
  const auto station =
      std::min_element(plain.stations.begin(), plain.stations.end(),
                       [&](const Station& a, const Station& b) { return std::abs(a.s - s) < std::abs(b.s - s); });
  constexpr double kHalf = 1.5;
  StructureDescription stiff = structure(position, 2.0 * kHalf, pipe);
  stiff.bending_stiffness = 1e3 * pipe.EI;
  d.pipe.structures = {stiff};
  const StaticResults results = solved(d);
  const StructureResult& found = results.structures.at(0);
  const double bending_length = std::sqrt(pipe.EI / station->effective_tension);
  const double curvature = station->curvature * (1.0 + kHalf / bending_length);
  const double strain = station->strain + 0.5 * pipe.steel_diameter * (curvature - station->curvature);
  EXPECT_NEAR(0.5 * (found.upper.strain + found.lower.strain), strain, 0.03 * strain);
  EXPECT_NEAR(0.5 * (found.upper.bending_moment + found.lower.bending_moment), pipe.EI * curvature,
              0.03 * pipe.EI * curvature);
  // Extremes are those of the pipe: what is built in has no strain of a pipe.
  EXPECT_GE(results.sagbend.strain.value, std::max(found.upper.strain, found.lower.strain) - 1e-12);
}

TEST(structures_at_rest, weight_above_a_roller_goes_into_that_roller) {
  Description d = read_model(testing::case_file("S16-T300")).description.value();
  const StaticResults plain = solved(d);
  const Section pipe = pipe_section(d);
  const SupportResult& box = plain.supports.at(1);
  StructureDescription weight = structure(plain.total_length - box.rows.at(0).s, 0.4, pipe);
  weight.weight_in_air += 20e3;
  d.pipe.structures = {weight};
  const StaticResults heavy = solved(d);
  const SupportResult& loaded = heavy.supports.at(1);
  const double inclination = heavy.structures.at(0).inclination;
  EXPECT_NEAR(loaded.reaction - box.reaction, 20e3 * std::cos(inclination), 0.02 * 20e3);
  EXPECT_EQ(heavy.structures.at(0).support, box.name);
  EXPECT_NEAR(heavy.structures.at(0).reaction, loaded.reaction, 1e-6 * loaded.reaction);
  EXPECT_NEAR((heavy.sum_rollers + heavy.top_reaction - plain.sum_rollers - plain.top_reaction).z(), 20e3, 0.02 * 20e3);
}

TEST(structures_at_rest, a_stiff_structure_in_the_tensioner_leaves_its_tension_as_set) {
  Description d = read_model(testing::case_file("S16-T300")).description.value();
  const double bottom = solved(d).bottom_tension;
  const Section pipe = pipe_section(d);
  for (const double position : {2.4, 3.0, 4.0, 6.0}) {
    StructureDescription stiff = structure(position, 4.5, pipe);
    stiff.axial_stiffness = 3.0 * pipe.EA;
    d.pipe.structures = {stiff};
    const StaticResults r = solved(d);
    EXPECT_NEAR(r.top_tension, *d.tensioner.tension, 1e-4 * r.top_tension) << position;
    EXPECT_NEAR(r.bottom_tension, bottom, 2e-3 * bottom) << position;  // it weighs what the pipe does
  }
}

TEST(structures_at_rest, of_the_pipes_own_properties_changes_nothing) {
  Description d = read_model(testing::case_file("S16-T300")).description.value();
  const StaticResults plain = solved(d);
  d.pipe.structures = {structure(70.0, 3.0, pipe_section(d))};
  const StaticResults same = solved(d);
  EXPECT_NEAR(same.lay_back, plain.lay_back, 5e-3);
  EXPECT_NEAR(same.bottom_tension, plain.bottom_tension, 1e-4 * plain.bottom_tension);
  EXPECT_NEAR(same.overbend->bending_moment.value, plain.overbend->bending_moment.value,
              2e-3 * plain.overbend->bending_moment.value);
}

}  // namespace overbend
