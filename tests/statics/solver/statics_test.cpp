#include "statics/solver/statics.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/moored_lay.h"
#include "statics/recovery/recovery.h"
#include "study/run/static_analysis.h"
#include "support/lay_over_bottom_rollers.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

Description read(const std::string& file) {
  return read_model(OVERBEND_SOURCE_DIR + file).description.value();
}
Description bgl1() {
  return read("/examples/bgl1.yaml");
}
Description reference_bgl1() {
  return read("/validation/static_cases/BGL1-T250.yaml");
}

StaticResults solve_results(const Description& d) {
  const Model model = build_model(d);
  const StaticOutcome outcome = solve_statics(model);
  return recover_statics(model, outcome.solution.value());
}

StaticFailure find_failure(const Description& d) {
  return solve_statics(build_model(d)).failure.value();
}

double worst_reaction_difference(const StaticResults& a, const StaticResults& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.supports.size(); ++i) {
    worst = std::max(worst, std::abs(a.supports[i].reaction - b.supports[i].reaction));
  }
  return worst;
}

TEST(statics, newton_balances_every_node_and_the_whole_line) {
  const StaticResults r = solve_results(bgl1());
  EXPECT_LT(r.force_residual, 1e-9);
  EXPECT_LT(r.global_residual, 1e-9);  // loads summed by a second code, so this also checks the kernel's loads
  EXPECT_NEAR(r.top_tension, 250e3, 1.0);
}

TEST(statics, dynamic_relaxation_reaches_the_same_equilibrium) {
  Description d = reference_bgl1();
  d.mesh.overbend_element = 1.0;
  d.mesh.touchdown_element = 3.0;
  const StaticResults newton = solve_results(d);
  d.statics.method = StaticMethod::dynamic_relaxation;
  const StaticResults relaxed = solve_results(d);
  EXPECT_GT(relaxed.solve.relaxation_steps, 100);
  EXPECT_NEAR(relaxed.bottom_tension, newton.bottom_tension, 1.0);
  EXPECT_NEAR(relaxed.lay_back, newton.lay_back, 1e-4);
  EXPECT_LT(worst_reaction_difference(relaxed, newton),
            1.0);  // both end at 1e-9 of the weight: 0.4 mN; rollers are stiff
}

TEST(statics, port_and_starboard_are_mirror_images) {
  Description north = bgl1();
  Description south = north;
  for (CurrentPoint& row : south.environment.current) {
    row.towards += std::numbers::pi;
  }
  const StaticResults a = solve_results(north);
  const StaticResults b = solve_results(south);
  EXPECT_NEAR(a.touchdown.p_W.y(), -b.touchdown.p_W.y(), 1e-6);
  EXPECT_NEAR(a.bottom_tension, b.bottom_tension, 1e-2);
  for (std::size_t i = 0; i < a.supports.size(); ++i) {
    for (std::size_t row = 0; row < a.supports[i].rows.size(); ++row) {
      const auto& ra = a.supports[i].rows[row].rollers;
      const auto& rb = b.supports[i].rows[row].rollers;
      EXPECT_NEAR(ra[0].reaction, rb[0].reaction, 1.0);
      EXPECT_NEAR(ra[1].reaction, rb[2].reaction, 1.0);
      EXPECT_NEAR(ra[2].reaction, rb[1].reaction, 1.0);
    }
  }
}

TEST(statics, the_heading_of_the_barge_changes_nothing_but_the_direction) {
  Description d = reference_bgl1();
  const StaticResults east = solve_results(d);
  d.vessel.heading = 0.7;
  const StaticResults turned = solve_results(d);
  EXPECT_NEAR(turned.lay_back, east.lay_back, 1e-6);
  EXPECT_NEAR(turned.bottom_tension, east.bottom_tension, 1e-3);
  EXPECT_NEAR(turned.overbend->bending_moment.value, east.overbend->bending_moment.value, 1.0);
}

TEST(statics, a_finer_mesh_moves_the_results_less_than_the_reference_tolerances) {
  Description d = bgl1();
  const StaticResults rule = solve_results(d);
  d.mesh.overbend_element = 0.2;
  d.mesh.touchdown_element = 0.4;
  d.mesh.max_element_length = 1.5;
  const StaticResults fine = solve_results(d);
  EXPECT_NEAR(rule.bottom_tension, fine.bottom_tension, 1e-4 * fine.bottom_tension);
  EXPECT_NEAR(rule.lay_back, fine.lay_back, 0.02);
  EXPECT_NEAR(rule.sagbend.bending_moment.value, fine.sagbend.bending_moment.value,
              1e-3 * fine.sagbend.bending_moment.value);
  EXPECT_NEAR(rule.overbend->bending_moment.value, fine.overbend->bending_moment.value,
              5e-5 * fine.overbend->bending_moment.value);
  EXPECT_LT(worst_reaction_difference(rule, fine), 20.0);
}

TEST(statics, where_nodes_lie_over_the_supports_does_not_matter) {
  Description d = bgl1();
  d.mesh.overbend_element = 0.15;
  const StaticResults fine = solve_results(d);
  for (const double length : {0.37, 0.61, 1.0}) {
    d.mesh.overbend_element = length;
    const StaticResults coarse = solve_results(d);
    EXPECT_NEAR(coarse.overbend->bending_moment.value, fine.overbend->bending_moment.value,
                5e-5 * fine.overbend->bending_moment.value)
        << length;
    EXPECT_LT(worst_reaction_difference(coarse, fine), 50.0) << length;
  }
}

TEST(statics, a_start_from_the_neighbour_gives_what_a_start_from_nothing_gives) {
  Description d = bgl1();
  const Model first = build_model(d);
  StaticSolution solution = solve_statics(first).solution.value();
  for (const double tension : {255e3, 265e3, 280e3}) {
    d.tensioner.tension = tension;
    const Model model = build_model(d);
    solution = solve_statics(model, &solution).solution.value();
    const StaticResults warm = recover_statics(model, solution);
    const StaticResults cold = solve_results(d);
    EXPECT_NEAR(warm.bottom_tension, cold.bottom_tension, 1e-4 * cold.bottom_tension);  // the meshes differ
    EXPECT_NEAR(warm.lay_back, cold.lay_back, 0.02);
    EXPECT_LT(worst_reaction_difference(warm, cold), 500.0);
  }
}

TEST(statics, solving_twice_gives_the_same_bits) {
  const StaticResults a = solve_results(bgl1());
  const StaticResults b = solve_results(bgl1());
  EXPECT_EQ(a.bottom_tension, b.bottom_tension);
  EXPECT_EQ(a.overbend->von_mises.value, b.overbend->von_mises.value);
}

TEST(statics, length_and_anchor_give_back_the_tension_that_needs_them) {
  Description d = reference_bgl1();
  const StaticResults given = solve_results(d);
  d.tensioner.tension.reset();
  d.pipe.length = given.total_length;
  d.pipe.anchor = given.stations.front().astern;
  const StaticResults found = solve_results(d);
  // The length fixes the tension through the stretch of the laid pipe: 1e-9 m of rounding in 580 m is worth 5e-3 N, the
  // mesh more.
  EXPECT_NEAR(found.top_tension, 250e3, 250.0);
  EXPECT_NEAR(found.lay_back, given.lay_back, 0.5);
}

TEST(statics, steel_that_yields_bends_alike_whether_its_tension_is_given_or_follows) {
  Description d = reference_bgl1();
  d.tensioner.tension = 600e3;  // takes a tenth of the plastic moment
  d.pipe.section.steel.yield_stress = 240e6;
  d.pipe.section.steel.material.law = MaterialLaw::bilinear;
  Model pulled = build_model(d);
  const StaticResults given = recover_statics(pulled, *solve_lay(pulled).solution);
  d.tensioner.tension.reset();
  d.pipe.length = given.total_length;
  d.pipe.anchor = given.stations.front().astern;
  Model anchored = build_model(d);
  const StaticResults found = recover_statics(anchored, *solve_lay(anchored).solution);
  EXPECT_NEAR(found.top_tension, 600e3, 600.0);
  EXPECT_NEAR(found.overbend->bending_moment.value, given.overbend->bending_moment.value, 1e3);
  EXPECT_NEAR(found.overbend->strain.value, given.overbend->strain.value, 0.02 * given.overbend->strain.value);
}

TEST(statics, the_suspended_weight_is_what_the_tension_loses_on_the_way_down) {
  const StaticResults r = solve_results(reference_bgl1());
  const double air = 2255.9358 * 5.222, water = 368.4936 * (89.0 - 0.2445);
  const double top_bending = 0.5 * std::pow(r.stations.back().bending_moment, 2) / r.sections[0].EI;
  // N + EI kappa^2 / 2 + hanging weight is constant along a frictionless rod; the bed adds its small work.
  EXPECT_NEAR(r.bottom_tension, 250e3 + top_bending - air - water, 40.0);
}

TEST(statics, a_slope_deepens_the_touchdown) {
  Description d = reference_bgl1();
  d.environment.seabed.slope = 1.0 * std::numbers::pi / 180.0;
  d.environment.seabed.slope_towards = 1.5 * std::numbers::pi;  // astern of a barge heading east
  d.environment.seabed.friction_axial = 0.5;
  const StaticResults r = solve_results(d);
  EXPECT_NEAR(r.touchdown.p_W.z(), -89.0 - r.lay_back * std::tan(std::numbers::pi / 180.0) + 0.2445, 0.01);
  EXPECT_LT(r.global_residual, 1e-9);
}

TEST(statics, thicker_pipe_at_the_tensioner_bends_less_there) {
  Description d = reference_bgl1();
  SegmentDescription thick{"thick", 60.0, d.pipe.section};
  thick.section.steel.wall_thickness *= 2.0;
  d.pipe.segments.push_back(thick);
  const StaticResults r = solve_results(d);
  EXPECT_LT(r.force_residual, 1e-9);
  EXPECT_LT(r.global_residual, 1e-9);
  EXPECT_GT(r.sections[1].EI, 1.8 * r.sections[0].EI);
}

TEST(statics, where_the_wall_grows_thicker_the_thin_side_has_its_full_strain_on_every_mesh) {
  Description d = bgl1();
  SegmentDescription thin{"thin", 40.0, d.pipe.section}, thick{"thick", 12.0, d.pipe.section};
  thick.section.steel.wall_thickness = 0.020;  // on a roller: the moment is largest here
  d.pipe.segments = {thin, thick};
  for (const double length : {0.1, 0.5, 1.2}) {
    d.mesh.overbend_element = length;
    const StaticResults r = solve_results(d);
    for (const double change : {40.0, 52.0}) {
      const Station *at_node = nullptr, *softest = nullptr;
      for (const Station& station : r.stations) {
        if (std::abs(station.s - (r.total_length - change)) > 2e-3) continue;
        if (softest == nullptr || station.bending_stress > softest->bending_stress) softest = &station;
        if (std::abs(station.s - (r.total_length - change)) < 1e-6) at_node = &station;
      }
      ASSERT_TRUE(at_node != nullptr && softest != nullptr) << change;
      const double by_hand = at_node->bending_moment * 0.2032 / r.sections[0].second_moment;
      EXPECT_NEAR(softest->bending_stress, by_hand, 1e-3 * by_hand) << change << " " << length;
    }
  }
}

// In series: the same moment bends the softer joint more, by the ratio of the stiffnesses.
TEST(statics, strain_gathers_at_bare_field_joints) {
  Description d = reference_bgl1();
  d.pipe.section.joint = JointDescription{12.0, 0.6, 10.065e3};
  d.pipe.section.joint->coated_stiffness = 1.4;
  const StaticResults r = solve_results(d);
  EXPECT_LT(r.global_residual, 1e-9);
  const auto sample = [&](double from_tensioner) {
    const double s = r.total_length - from_tensioner;
    return *std::min_element(r.stations.begin(), r.stations.end(),
                             [&](const Station& a, const Station& b) { return std::abs(a.s - s) < std::abs(b.s - s); });
  };
  int joints = 0;
  for (double middle = 6.0; middle < 60.0; middle += 12.0) {
    const Station joint = sample(middle + 0.1), coated = sample(middle + 1.2);
    if (joint.bending_moment < 100e3) continue;
    ++joints;
    const double ratio = (joint.curvature / joint.bending_moment) / (coated.curvature / coated.bending_moment);
    EXPECT_NEAR(ratio, 1.4, 1e-9) << middle;
    EXPECT_NEAR(joint.bending_stress, 207e9 * joint.curvature * 0.2032, 1.0);
    EXPECT_NEAR(coated.bending_stress, 207e9 * coated.curvature * 0.2032, 1.0);
  }
  EXPECT_GE(joints, 2);
}

// Boxes of one row that the pipe does not touch may have no station over them; between two meshes moments then differed
// by 6 %, now by what lines between stations leave out.
TEST(statics, what_the_pipe_bears_over_a_box_does_not_depend_on_where_stations_lie) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/validation/bed_cases/BP24-sleeper.yaml").description.value();
  const StaticResults whole = solve_results(d);
  d.pipe.segments = {SegmentDescription{"same", 100.0, d.pipe.section}};  // which puts nodes elsewhere
  const StaticResults parted = solve_results(d);
  for (std::size_t i = 0; i < whole.supports.size(); ++i) {
    const SupportResult &a = whole.supports[i], &b = parted.supports[i];
    EXPECT_GT(a.effective_tension, 0.9 * whole.bottom_tension) << a.name;
    EXPECT_NEAR(a.effective_tension, b.effective_tension, 1e-3 * a.effective_tension) << a.name;
    EXPECT_NEAR(a.bending_moment, b.bending_moment, 5e-3 * whole.overbend->bending_moment.value) << a.name;
  }
}

TEST(statics, too_little_tension_is_rejected_with_the_least_that_would_do) {
  Description d = reference_bgl1();
  d.tensioner.tension = 40e3;
  const StaticFailure f = find_failure(d);
  EXPECT_NE(f.what.find("too low"), std::string::npos);
  EXPECT_NE(f.why.find("44.5 kN"), std::string::npos);  // 2.2559 x 5.222 + 0.36849 x 88.756 kN
}

TEST(statics, a_pipe_that_a_current_drives_off_its_rollers_is_said_to_have_left_them) {
  for (const double factor : {1.3, 1.5}) {  // the example's current just lets it climb the last side roller
    Description d = bgl1();
    for (CurrentPoint& point : d.environment.current) {
      point.speed *= factor;
    }
    const Model model = build_model(d);
    const StaticOutcome outcome = solve_statics(model);
    if (outcome.failure) {
      EXPECT_NE(outcome.failure->why.find("the pipe missed '"), std::string::npos) << outcome.failure->why;
      continue;
    }
    const std::vector<std::string> warnings = messages(recover_statics(model, *outcome.solution).findings);
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
      return warning.find("the pipe has left '") != std::string::npos && warning.find("to port") != std::string::npos;
    })) << factor;
  }
}

TEST(statics, a_pipe_that_nothing_holds_on_its_rollers_is_said_to_run_off_them) {
  for (const double factor : {1.0, 2.0}) {  // the second leaves it in equilibrium next to all supports
    Description d = bgl1();
    for (RollerKindDescription& kind : d.rollers) kind.sides.reset();
    for (CurrentPoint& point : d.environment.current) point.speed *= factor;
    const StaticFailure f = find_failure(d);
    EXPECT_NE(f.what.find("the pipe runs off its rollers"), std::string::npos) << f.what;
    EXPECT_NE(f.why.find("that box has no side rollers to hold it"), std::string::npos) << f.why;
  }
}

// Below the boxes, as next to them. The tip clearance is how far it lies above the roller
// then, which is negative, not how far from its end.
TEST(statics, a_pipe_below_the_rollers_it_ran_off_is_reported_to_have_left_them) {
  const auto warned = [](const StaticResults& r, const std::string& message) {
    return std::ranges::any_of(messages(r.findings),
                               [&](const std::string& w) { return w.find(message) != std::string::npos; });
  };
  const auto solved = [](double current) {
    Model model = build_model(testing::lay_over_bottom_rollers(current));
    return checked_statics(model, {solve_statics(model).solution.value(), {}, {}});
  };
  const auto tip_check = [](const StaticResults& r) {
    return std::ranges::find(r.checks.rows, std::string("tip_clearance"), &CheckRow::id)->status;
  };
  const StaticResults on = solved(0.2), under = solved(0.3), far = solved(0.5);
  EXPECT_FALSE(warned(on, "the pipe has left '"));
  EXPECT_EQ(on.stinger_tip_clearance.value(), on.supports.back().separation);
  // Which boxes it left on its way, and to which side of those that it hangs under, is a matter of rounding.
  for (const StaticResults* r : {&under, &far}) {
    EXPECT_TRUE(warned(*r, "the pipe has left '"));
    EXPECT_LT(r->stinger_tip_clearance.value(), -0.3);
    EXPECT_EQ(tip_check(*r), CheckStatus::exceeded);
  }
}

/// Least clear distance from a roller of the places of all stations [m].
double min_of_stations(const StaticResults& r, const RollerResult& roller) {
  const Vec3 center = roller.p_W - roller.radius * roller.normal_W;
  double min_value = 1e9;
  for (const Station& station : r.stations) {
    const Vec3 from = station.p_W - center;
    const double along = std::clamp(from.dot(roller.axis_W), -0.5 * roller.face, 0.5 * roller.face);
    min_value =
        std::min(min_value, (from - along * roller.axis_W).norm() - roller.radius - 0.5 * r.pipe_outer_diameter);
  }
  return min_value;
}

TEST(statics, a_roller_that_carries_has_its_penetration_as_separation_however_steep_its_box) {
  Description d = read("/examples/bgl1-as-printed.yaml");
  d.environment.current.clear();
  for (BoxDescription& box : d.supports.boxes) box.rows = 4;
  const StaticResults r = solve_results(d);
  int carrying = 0, clear = 0;
  for (const SupportResult& box : r.supports) {
    for (const RowResult& row : box.rows) {
      for (const RollerResult& roller : row.rollers) {
        if (roller.reaction > 0.0) {
          ++carrying;
          EXPECT_LT(roller.separation, 0.0) << box.name;
          EXPECT_GE(roller.separation, -r.max_penetration * (1.0 + 1e-9)) << box.name;
        } else {
          ++clear;
          EXPECT_GE(roller.separation, 0.0) << box.name;
          EXPECT_LE(roller.separation, min_of_stations(r, roller) + 1e-6) << box.name;  // no place is closer
        }
      }
    }
  }
  EXPECT_GE(carrying, 6);
  EXPECT_GT(clear, 20);
}

bool warns_of_tension(const StaticResults& r) {
  return std::ranges::any_of(messages(r.findings), [](const std::string& warning) {
    return warning.find("the tension at the tensioner is") != std::string::npos;
  });
}

TEST(statics, a_tension_that_the_recovered_forces_miss_is_warned_of) {
  Description d = read("/examples/first-model.yaml");
  EXPECT_FALSE(warns_of_tension(solve_results(d)));
  d.supports.boxes[0].z = 10.0;  // the pipe is bent to thousands of MPa next to the tensioner
  const StaticResults r = solve_results(d);
  EXPECT_GT(std::abs(r.top_tension - 300e3), 300.0);
  EXPECT_TRUE(warns_of_tension(r));
}

TEST(statics, a_tension_that_the_forces_miss_by_far_is_rejected) {
  Description d = bgl1();
  for (BoxDescription& box : d.supports.boxes) {
    box.z *= 10.0;
  }
  EXPECT_NE(find_failure(d).what.find("set tension is not reached"), std::string::npos);
}

TEST(statics, a_floating_pipe_is_rejected) {
  Description d = reference_bgl1();
  d.pipe.section.coatings.pop_back();
  d.pipe.section.coatings.push_back({"foam", 0.1, 1e3});
  EXPECT_NE(find_failure(d).what.find("floats"), std::string::npos);
}

TEST(statics, a_line_too_short_to_reach_the_seabed_is_rejected) {
  Description d = reference_bgl1();
  d.pipe.length = 300.0;
  EXPECT_NE(find_failure(d).what.find("does not reach"), std::string::npos);
}

TEST(statics, supports_far_below_the_pipe_are_rejected) {
  Description d = reference_bgl1();
  for (BoxDescription& box : d.supports.boxes) {
    box.z -= 30.0;
  }
  EXPECT_NE(find_failure(d).what.find("lifts off every support"), std::string::npos);
}

}  // namespace
TEST(statics, a_tension_beyond_the_yield_load_of_yielding_steel_is_rejected_at_once) {
  Description d = reference_bgl1();
  d.pipe.section.steel.material.law = MaterialLaw::bilinear;
  const double area = 3.14159265358979 * (0.4064 - 0.011125) * 0.011125, yield_load = 414e6 * area;
  d.tensioner.tension = 1.01 * yield_load;
  const StaticOutcome outcome = solve_statics(build_model(d));
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->what, "the tension exceeds the yield load of the pipe");
  EXPECT_NE(outcome.failure->why.find(fmt::format("{:.6g} kN (yield stress", 1e-3 * yield_load)), std::string::npos)
      << outcome.failure->why;
}

TEST(statics, a_pipe_that_folds_where_it_yields_is_distinguished_from_one_without_an_equilibrium) {
  Description d = reference_bgl1();
  d.pipe.section.steel.yield_stress = 60e6;  // the stinger bends it to five times the curvature of first yield
  d.pipe.section.steel.material.law = MaterialLaw::bilinear;
  d.pipe.section.steel.material.hardening_modulus = 1e6;
  const StaticOutcome outcome = solve_statics(build_model(d));
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->what, "no equilibrium found: the pipe yields");
  EXPECT_NE(outcome.failure->why.find("times the curvature of first yield"), std::string::npos) << outcome.failure->why;
}

}  // namespace overbend
