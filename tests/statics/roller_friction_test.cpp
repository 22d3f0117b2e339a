#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/recovery.h"
#include "statics/recovery/roller_friction_limits.h"
#include "statics/solver/statics.h"

namespace overbend {
namespace {

constexpr double kRadius = 150.0, kSpacing = 1.0, kFriction = 0.2;

/// A soft pipe that runs level out of the tensioner and over a close row of rollers on a circle.
Description soft_pipe_over_rollers(RollerFriction friction) {
  std::string boxes;
  for (double x = 2.0; x < 56.0; x += kSpacing) {
    const double z = std::sqrt(kRadius * kRadius - x * x) - kRadius;
    boxes += fmt::format("      - {{x: {:.6f} m, z: {:.6f} m, length: 0.1 m}}\n", x - 60.0, z + 16.75);
  }
  const std::string text = fmt::format(
      "overbend: 1\nenvironment:\n  water_depth: 150 m\n  water_weight_density: 10.05 kN/m^3\n"
      "  seabed: {{stiffness: 100 kN/m^2, friction: 0}}\n"
      "pipe:\n  steel: {{outside_diameter: 0.4064 m, wall_thickness: 0.011125 m, youngs_modulus: 6 GPa, "
      "poissons_ratio: 0.3, yield_stress: 414 MPa, weight_density: 77 kN/m^3}}\n"
      "  coatings: [{{name: concrete, thickness: 40 mm, weight_density: 22 kN/m^3}}]\n"
      "vessel: {{heading: 90 deg, stern_shoe: {{x: -60 m, z: 0 m}}, motion: fixed}}\n"
      "tensioner: {{x: -60 m, z: 17 m, tension: 300 kN}}\n"
      "rollers:\n  close: {{bottom: {{radius: 0.01 m, face: 4 m}}, stiffness: 1e5 kN/m, friction: {{axial: {}, "
      "lateral: {}}}}}\n"
      "supports:\n  stinger:\n    roller: close\n    rows: 1\n    boxes:\n{}",
      kFriction, 0.1 * kFriction, boxes);
  Description d = read_model_text(text, "rollers.yaml").description.value();
  d.statics.roller_friction = friction;
  return d;
}

struct Laid {
  Model model;
  StaticOutcome outcome;
  StaticResults results;
};

Laid laid(const Description& description) {
  Laid lay{build_model(description), {}, {}};
  lay.outcome = solve_statics(lay.model);
  EXPECT_TRUE(lay.outcome.solution) << (lay.outcome.failure ? lay.outcome.failure->why : "");
  if (lay.outcome.solution) lay.results = recover_statics(lay.model, *lay.outcome.solution);
  return lay;
}

constexpr double kFirst = 2.5, kLast = 39.5;  ///< From the tensioner: all rollers between carry [m].

/// Tension of a heavy string on a circle, from the first roller to `kLast`: going astern by ds it dips by ds/R, loses
/// w sin(dip) and gains `mu` (T/R + w cos(dip)), the law of the capstan with weight.
double tension_of_string(const Laid& lay, double mu) {
  const double w = lay.model.sections[0].weight_in_air, h = (kLast - kFirst) / 4000.0;
  double tension = lay.results.top_tension;
  for (int i = 0; i < 4000; ++i) {
    const double dip = (kFirst + (i + 0.5) * h) / kRadius;
    const double half = tension + 0.5 * h * (mu * (tension / kRadius + w * std::cos(dip)) - w * std::sin(dip));
    tension += h * (mu * (half / kRadius + w * std::cos(dip)) - w * std::sin(dip));
  }
  return tension;
}

/// Halfway between two rollers.
double found_tension(const Laid& lay) {
  double tension = 0.0;
  for (const Station& station : lay.results.stations) {
    if (lay.results.total_length - station.s >= kLast) tension = station.effective_tension;
  }
  return tension;
}

TEST(roller_friction, of_many_rollers_is_that_of_a_capstan_with_weight) {
  for (const auto& [friction, sign] :
       {std::pair{RollerFriction::lay, 1.0}, {RollerFriction::haul, -1.0}, {RollerFriction::none, 0.0}}) {
    const Laid lay = laid(soft_pipe_over_rollers(friction));
    ASSERT_TRUE(lay.outcome.solution);
    const double expected = tension_of_string(lay, sign * kFriction);
    EXPECT_NEAR(found_tension(lay), expected, 0.004 * expected) << sign;
    EXPECT_LT(lay.results.force_residual, 1e-8);
    EXPECT_LT(lay.results.global_residual, 1e-8);
  }
}

TEST(roller_friction, holds_the_pipe_back_as_it_is_paid_out_and_lets_it_go_as_it_is_hauled_in) {
  const double lay = laid(soft_pipe_over_rollers(RollerFriction::lay)).results.bottom_tension;
  const double none = laid(soft_pipe_over_rollers(RollerFriction::none)).results.bottom_tension;
  const double haul = laid(soft_pipe_over_rollers(RollerFriction::haul)).results.bottom_tension;
  EXPECT_GT(lay, 1.01 * none);
  EXPECT_LT(haul, 0.99 * none);
}

TEST(roller_friction, limits_lie_either_side_of_the_answer_without_friction) {
  const Laid lay = laid(soft_pipe_over_rollers(RollerFriction::none));
  ASSERT_TRUE(lay.outcome.solution);
  StaticResults results = lay.results;
  find_roller_friction_limits(lay.model, *lay.outcome.solution, results);
  const auto of = [&](const std::string& name) {
    const auto found = std::ranges::find(results.roller_friction, name, &RollerFrictionCase::name);
    EXPECT_NE(found, results.roller_friction.end()) << name;
    return found == results.roller_friction.end() ? RollerFrictionCase{} : *found;
  };
  EXPECT_NEAR(of("frictionless").lay_back, results.lay_back, 1e-6);
  EXPECT_GT(of("lay").bottom_tension, results.bottom_tension);
  EXPECT_LT(of("haul").bottom_tension, results.bottom_tension);
  EXPECT_GT(of("port").tip_side, 0.05);
  EXPECT_NEAR(of("port").tip_side, -of("starboard").tip_side, 1e-6);
  EXPECT_NEAR(of("lay").bottom_tension, laid(soft_pipe_over_rollers(RollerFriction::lay)).results.bottom_tension, 10.0);
}

TEST(roller_friction, a_limit_reports_how_far_the_pipe_runs_off_any_roller_of_the_last_box_that_bears_it) {
  StaticResults results;
  SupportResult& tip = results.supports.emplace_back();
  tip.stinger = true;
  tip.rows.resize(2);
  tip.rows[1].s = -1.0;  // the pipe does not cross it
  tip.rows[0].rollers.resize(3);
  tip.rows[0].rollers[1].off_end = 0.093;
  tip.rows[0].rollers[1].reaction = 5e3;
  tip.rows[0].rollers[2].off_end = 0.5;  // next to the pipe, no load
  EXPECT_EQ(friction_case("lay", results).off_roller, 0.093);
}

}  // namespace
}  // namespace overbend
