#include "study/stages/lay_operation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/json.h"
#include "model/lay_stage.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/initial_shape/stage_shape.h"
#include "statics/moored/moored_lay.h"
#include "statics/recovery/recovery.h"

namespace overbend {
namespace {

Description read(const std::string& file) {
  return read_model(OVERBEND_SOURCE_DIR + file).description.value();
}

Json expected_stages(const std::string& name) {
  return read_json_file(std::string(OVERBEND_SOURCE_DIR) + "/validation/operation_cases/" + name +
                        ".expected.json")["operation"]["stages"];
}

void expect_head(const HeadResult& head, const Json& wanted) {
  EXPECT_NEAR(head.astern, wanted["x"].get<double>(), 0.02);
  EXPECT_NEAR(head.p_W.z(), wanted["z"].get<double>(), 0.02);
  EXPECT_NEAR(head.inclination, wanted["inclination"].get<double>(), 0.02 * kDegree);
  EXPECT_NEAR(head.cable_inclination, wanted["cable_inclination"].get<double>(), 0.02 * kDegree);
  EXPECT_NEAR(head.tension, wanted["tension"].get<double>(), 1e-3 * head.tension);
}

void expect_reactions(const StaticResults& lay, const Json& wanted) {
  for (std::size_t i = 0; i < lay.supports.size(); ++i) {
    const double reaction = wanted[i]["reaction"].get<double>();
    EXPECT_NEAR(lay.supports[i].reaction, reaction, std::max(500.0, 0.01 * reaction)) << lay.supports[i].name;
  }
}

void expect_stage(const StageResult& stage, const Json& wanted) {
  ASSERT_TRUE(stage.lay.has_value()) << stage.failure->what;
  const StaticResults& lay = *stage.lay;
  EXPECT_NEAR(lay.top_tension, wanted["tension"].get<double>(), 1.0);
  EXPECT_NEAR(lay.bottom_tension, wanted["bottom_tension"].get<double>(), 1e-3 * lay.bottom_tension);
  EXPECT_NEAR(lay.lay_back, wanted["lay_back"].get<double>(), 0.05);
  EXPECT_NEAR(lay.suspended_length, wanted["suspended_length"].get<double>(), 0.05);
  expect_head(*lay.head, wanted["head"]);
  const double moment = wanted.contains("sagbend") ? wanted["sagbend"].value("max_bending_moment", 0.0) : 0.0;
  if (moment > 2e4) {  // of pipe that hangs; a head that only just rests on the bed has one of its own
    EXPECT_NEAR(lay.sagbend.bending_moment.value, moment, 0.003 * moment);
  }
  if (wanted.contains("overbend") && lay.overbend) {
    const double over = wanted["overbend"]["max_bending_moment"].get<double>();
    EXPECT_NEAR(lay.overbend->bending_moment.value, over, 0.005 * over);
  }
  if (wanted.contains("departure_angle")) {
    EXPECT_NEAR(lay.departure_angle, wanted["departure_angle"].get<double>(), 0.05 * kDegree);
  }
  if (wanted.contains("supports")) expect_reactions(lay, wanted["supports"]);
  if (lay.far_anchor) {
    EXPECT_NEAR(lay.far_anchor->distance, wanted["anchor"]["distance"].get<double>(), 0.02);
    EXPECT_NEAR(std::abs(lay.far_anchor->uplift), wanted["anchor"]["uplift"].get<double>(), 1.0);
  }
}

/// Answers of a collocation of the elastica with frictionless rigid rollers, in the files next to the models.
void expect_reference(const std::string& name) {
  const OperationResults found = solve_operation(read("/validation/operation_cases/" + name + ".yaml"));
  const Json wanted = expected_stages(name);
  ASSERT_EQ(found.stages.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    SCOPED_TRACE(name + ", " + found.stages[i].stage.name);
    expect_stage(found.stages[i], wanted[i]);
  }
}

TEST(lay_operation, abandonment_by_j_lay_has_the_stages_of_the_reference) {
  expect_reference("AR12-J");
}

TEST(lay_operation, abandonment_over_rollers_has_the_stages_of_the_reference) {
  expect_reference("AR16-S");
}

TEST(lay_operation, start_up_by_j_lay_has_the_stages_of_the_reference) {
  expect_reference("SU10-J");
}

TEST(lay_operation, start_up_over_rollers_has_the_stages_of_the_reference) {
  expect_reference("SU16");
}

TEST(lay_operation, start_up_with_its_anchor_in_place_finds_the_tension) {
  Description d = read("/validation/operation_cases/SU10-J.yaml");
  const Json wanted = expected_stages("SU10-J");
  d.operation.lay.stages.resize(1);
  d.operation.lay.stages[0].tension.reset();
  d.tensioner.tension.reset();
  d.operation.lay.anchor->distance = wanted[0]["anchor"]["distance"].get<double>();
  const OperationResults found = solve_operation(d);
  ASSERT_TRUE(found.stages[0].lay.has_value()) << found.stages[0].failure->why;
  EXPECT_NEAR(found.stages[0].lay->top_tension, wanted[0]["tension"].get<double>(), 50.0);
}

TEST(lay_operation, a_cable_clear_of_the_bed_pulls_its_anchor_up_by_the_weight_that_the_top_does_not_carry) {
  Description d = read("/validation/operation_cases/SU10-J.yaml");
  d.operation.lay.stages.resize(1);
  d.operation.lay.cable->length = 200.0;
  const OperationResults found = solve_operation(d);
  ASSERT_TRUE(found.stages[0].lay.has_value()) << found.stages[0].failure->why;
  const StaticResults& lay = *found.stages[0].lay;
  EXPECT_LT(lay.sum_seabed.norm(), 1.0);
  const Vec3 suspended_load = lay.sum_weight + lay.sum_buoyancy + lay.sum_current;
  EXPECT_NEAR(lay.far_anchor->uplift, lay.top_reaction.z() + suspended_load.z(), 1.0);
  EXPECT_GT(lay.far_anchor->uplift, 10e3);
}

/// Stages of the S-lay of the references, at even steps.
Description stages_of_lay(double from, double to, int steps) {
  Description d = read("/validation/operation_cases/AR16-S.yaml");
  d.operation.lay.stages.clear();
  d.operation.lay.program = StageProgram{};
  d.operation.lay.program->from = from;
  d.operation.lay.program->to = to;
  d.operation.lay.program->steps = steps;
  return d;
}

TEST(lay_operation, every_stage_balances_as_a_whole) {
  Description d = stages_of_lay(20.0, 380.0, 12);
  d.operation.lay.program->values = {300e3, 200e3, 120e3};
  for (const StageResult& stage : solve_operation(d).stages) {
    SCOPED_TRACE(stage.stage.name);
    ASSERT_TRUE(stage.lay.has_value()) << stage.failure->why;
    EXPECT_LT(stage.lay->global_residual, 1e-8);
    EXPECT_NEAR(stage.lay->top_tension, *stage.stage.tension, 1.0);
  }
}

TEST(lay_operation, elements_of_another_length_give_the_same_stage) {
  Description d = read("/validation/operation_cases/AR16-S.yaml");
  d.operation.lay.stages.resize(2);
  const OperationResults coarse = solve_operation(d);
  d.mesh.overbend_element = 0.25;
  const OperationResults fine = solve_operation(d);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((coarse.stages[i].lay->head->p_W - fine.stages[i].lay->head->p_W).norm(), 0.01);
    EXPECT_NEAR(coarse.stages[i].lay->sagbend.bending_moment.value, fine.stages[i].lay->sagbend.bending_moment.value,
                100.0);
  }
}

// On a bed without friction the tension is the same all along the laid line.
TEST(lay_operation, where_the_tension_is_least_does_not_depend_on_rounding) {
  const auto min_of_stages = [](double turned) {
    Description d = read("/examples/bgl1-start-up.yaml");
    d.vessel.heading += turned;
    for (CurrentPoint& point : d.environment.current) point.towards += turned;
    std::vector<double> places;
    for (const StageResult& stage : solve_operation(d).stages) {
      if (stage.lay) places.push_back(stage.lay->total_length - stage.lay->min_effective_tension.s);
    }
    return places;
  };
  const std::vector<double> north = min_of_stages(0.0), turned = min_of_stages(0.65);
  ASSERT_GE(north.size(), 4U);
  ASSERT_EQ(turned.size(), north.size());
  for (std::size_t i = 0; i < north.size(); ++i) EXPECT_NEAR(turned[i], north[i], 1e-3) << i;
}

// Pipe on a bed without friction pulls on nothing: the shape does not depend on the length of the cable.
TEST(lay_operation, a_cable_longer_than_any_lay_still_ends_in_pipe_on_the_bed) {
  Description d = read("/validation/operation_cases/AR12-J.yaml");
  LayStageDescription stage = d.operation.lay.stages.back();
  stage.cable_out = 1200.0;
  d.operation.lay.stages = {stage};
  stage.cable_out = 2000.0;
  d.operation.lay.stages.push_back(stage);
  const OperationResults found = solve_operation(d);
  ASSERT_TRUE(found.stages[1].lay.has_value()) << found.stages[1].failure->why;
  const StaticResults &near = *found.stages[0].lay, &far = *found.stages[1].lay;
  EXPECT_GT(far.total_length, 2000.0 + d.operation.lay.head->length + 30.0);
  EXPECT_EQ(far.stations.front().kind, SectionKind::pipe);
  EXPECT_NEAR(far.head->p_W.z(), near.head->p_W.z(), 0.01);
  EXPECT_NEAR(far.lay_back, near.lay_back, 0.05);
  EXPECT_NEAR(far.bottom_tension, near.bottom_tension, 1e-3 * near.bottom_tension);
  EXPECT_FALSE(far.checks.rows.empty());
}

TEST(lay_operation, a_stage_below_its_weight_says_which_tension_would_do_and_leaves_the_others_standing) {
  Description d = stages_of_lay(60.0, 160.0, 1);
  d.operation.lay.program->values = {20e3, 250e3};
  const OperationResults found = solve_operation(d);
  ASSERT_TRUE(found.stages[0].failure.has_value());
  EXPECT_FALSE(found.stages[0].failure->why.empty());
  ASSERT_TRUE(found.stages[0].failure->min_tension.has_value());
  ASSERT_TRUE(found.stages[1].lay.has_value());
  d.operation.lay.program->values[0] = *found.stages[0].failure->min_tension;
  EXPECT_TRUE(solve_operation(d).stages[0].lay.has_value());
}

TEST(lay_operation, a_given_bottom_tension_is_held) {
  Description d = stages_of_lay(60.0, 360.0, 3);
  d.operation.lay.program->tension = StageTension::bottom;
  d.operation.lay.program->bottom_tension = 130e3;
  for (const StageResult& stage : solve_operation(d).stages) {
    ASSERT_TRUE(stage.lay.has_value());
    EXPECT_NEAR(stage.lay->bottom_tension, 130e3, 5.0);
  }
}

TEST(lay_operation, sought_tensions_keep_their_limit_and_little_less_would_not) {
  Description d = stages_of_lay(60.0, 180.0, 3);
  d.operation.lay.program->tension = StageTension::seek;
  d.operation.lay.program->limits.sagbend_stress = 150e6;
  const OperationResults found = solve_operation(d);
  for (const StageResult& stage : found.stages) {
    ASSERT_TRUE(stage.lay.has_value()) << stage.failure->why;
    EXPECT_LE(stage.lay->sagbend.von_mises.value, 150e6);
  }
  const auto hardest =
      std::max_element(found.stages.begin(), found.stages.end(), [](const StageResult& a, const StageResult& b) {
        return a.lay->sagbend.von_mises.value < b.lay->sagbend.von_mises.value;
      });
  EXPECT_GT(hardest->lay->sagbend.von_mises.value, 0.99 * 150e6);  // the others are raised towards its tension
  EXPECT_EQ(hardest->governing, "sagbend stress");
}

TEST(lay_operation, a_limit_that_no_tension_keeps_is_named) {
  Description d = stages_of_lay(60.0, 120.0, 1);
  d.operation.lay.program->tension = StageTension::seek;
  d.operation.lay.program->tension_to = 400e3;
  d.operation.lay.program->limits.roller_load = 1e3;
  const OperationResults found = solve_operation(d);
  ASSERT_TRUE(found.stages[0].failure.has_value());
  EXPECT_NE(found.stages[0].failure->why.find("roller load"), std::string::npos);
}

TEST(lay_operation, the_barge_moves_by_the_cable_that_it_pays_out_once_all_lies_on_the_bed) {
  Description d = stages_of_lay(400.0, 430.0, 1);
  d.operation.lay.program->values = {120e3};
  const OperationResults found = solve_operation(d);
  ASSERT_TRUE(found.stages[1].lay.has_value());
  EXPECT_NEAR(found.stages[1].barge_ahead, 30.0, 0.03);  // and its stretch
}

TEST(lay_operation, the_barge_moves_over_a_slope_by_the_level_part_of_what_it_lays) {
  Description d = stages_of_lay(400.0, 430.0, 1);
  d.operation.lay.program->values = {120e3};
  d.environment.seabed.slope = 12.0 * kDegree;
  d.environment.seabed.slope_towards = d.vessel.heading;
  const OperationResults found = solve_operation(d);
  ASSERT_TRUE(found.stages[1].lay.has_value()) << found.stages[1].failure->why;
  EXPECT_NEAR(found.stages[1].barge_ahead, 30.0 * std::cos(12.0 * kDegree), 0.03);
}

TEST(lay_operation, a_bed_that_falls_by_its_profile_gives_the_stage_of_a_slope) {
  constexpr double kFall = 8.0 * kDegree;
  Description plane = read("/validation/operation_cases/AR12-J.yaml");
  plane.operation.lay.stages.resize(1);
  plane.operation.lay.stages[0].cable_out = 250.0;
  plane.operation.lay.stages[0].tension = 416e3;
  Description shaped = plane;
  plane.environment.seabed.slope = kFall;
  plane.environment.seabed.slope_towards = plane.vessel.heading + 180.0 * kDegree;
  for (double x = -200.0; x <= 3000.0; x += 100.0) {
    shaped.environment.seabed.profile.push_back({x, shaped.environment.water_depth + std::tan(kFall) * x});
  }
  // A first guess that lands at the depth under the vessel, 68 m above this bed, left the laid pipe standing in loops.
  const Model model = build_model(make_stage_description(shaped, lay_stages(shaped).front()));
  const LayPlane bed = lay_plane(model, model.mean_pose);
  const LayShape guess = stage_shape(model, bed, 416e3);
  const auto lands = std::lower_bound(guess.length.begin(), guess.length.end(), guess.touchdown) - guess.length.begin();
  const auto sample = static_cast<std::size_t>(lands);
  EXPECT_NEAR(guess.z[sample], bed.bed(guess.distance[sample]), 5.0);
  const OperationResults on_plane = solve_operation(plane), on_profile = solve_operation(shaped);
  ASSERT_TRUE(on_plane.stages[0].lay.has_value());
  ASSERT_TRUE(on_profile.stages[0].lay.has_value());
  const StaticResults &wanted = *on_plane.stages[0].lay, &found = *on_profile.stages[0].lay;
  EXPECT_GT(found.min_effective_tension.value, 0.0);
  EXPECT_NEAR(found.bottom_tension, wanted.bottom_tension, 1e-3 * wanted.bottom_tension);
  EXPECT_NEAR(found.lay_back, wanted.lay_back, 0.2);
}

TEST(lay_operation, recovery_has_the_stages_of_abandonment_in_reverse) {
  Description d = read("/validation/operation_cases/AR12-J.yaml");
  const OperationResults down = solve_operation(d);
  d.operation.type = OperationType::recovery;
  const OperationResults up = solve_operation(d);
  ASSERT_EQ(up.stages.size(), down.stages.size());
  EXPECT_NEAR(up.stages.front().lay->lay_back, down.stages.back().lay->lay_back, 1e-3);
  EXPECT_NEAR(up.stages.back().barge_ahead, -down.stages.back().barge_ahead, 1e-2);
}

TEST(lay_operation, pipe_that_yielded_over_the_stinger_is_still_bent_when_its_head_is_in_the_sea) {
  Description d = read("/examples/bgl1-as-printed-steel.yaml");
  Description cable = read("/validation/operation_cases/AR16-S.yaml");
  const Model model = build_model(d);
  ASSERT_TRUE(model.sections.front().bending.has_value());
  d.operation = cable.operation;
  d.operation.lay.stages.resize(1);
  d.operation.lay.stages[0].cable_out = 130.0;
  d.operation.lay.stages[0].tension = 250e3;
  const OperationResults found = solve_operation(d);
  ASSERT_TRUE(found.stages[0].lay.has_value()) << found.stages[0].failure->why;
  Model as_laid = build_model(d);
  const ModelEquilibrium lay = solve_lay(as_laid);
  const double before = recover_statics(as_laid, *lay.solution).residual_curvature;
  EXPECT_GT(before, 1e-4);
  EXPECT_NEAR(found.stages[0].lay->residual_curvature, before, 0.05 * before);
}

TEST(lay_operation, a_stage_that_does_not_stand_from_the_one_before_is_solved_from_nothing) {
  Description d = read("/examples/floating_stinger.yaml");
  d.vessel.trim = 1.0 * kDegree;
  StingerSectionDescription& stinger = d.supports.sections.front();
  stinger.limits = {-20.0 * kDegree, 20.0 * kDegree};
  stinger.springs.push_back({"tower", {-3.0, 6.096}, {20.0, -9.0}, 72.966e3, 177.929e3});
  LayStageDescription light, heavy;  // under them the pipe lies on its side rollers in different ways
  light.tank_weight = 90e3;
  light.tank_ballast = 0.1;
  heavy.tank_ballast = 0.5;
  d.operation.lay.stages = {light, heavy};
  const OperationResults found = solve_operation(d);
  ASSERT_TRUE(found.stages[1].lay.has_value()) << found.stages[1].failure->why;
  d.operation.lay.stages = {heavy};
  const OperationResults alone = solve_operation(d);
  EXPECT_NEAR(found.stages[1].lay->stinger[0].angle, alone.stages[0].lay->stinger[0].angle, 1e-5);
}

TEST(lay_operation, field_joints_and_segments_go_with_the_pipe_when_the_barge_moves) {
  Description d = read("/examples/bgl1.yaml");
  d.pipe.segments.push_back({"arrestor", 3.0, d.pipe.section});
  d.operation.type = OperationType::move;
  LayStageDescription stage;
  stage.ahead = 5.0;
  const Model moved = build_model(make_stage_description(d, stage));
  EXPECT_DOUBLE_EQ(moved.spans.front().from, 5.0);
  EXPECT_DOUBLE_EQ(moved.spans.front().to, 8.0);
}

}  // namespace
}  // namespace overbend
