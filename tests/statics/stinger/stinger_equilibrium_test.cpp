#include "statics/stinger/stinger_equilibrium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/json.h"
#include "model/lay_stage.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/moored_lay.h"
#include "statics/recovery/recovery.h"

namespace overbend {
namespace {

const std::string kFolder = std::string(OVERBEND_SOURCE_DIR) + "/validation/operation_cases/";

Description read(const std::string& name) {
  return read_model(kFolder + name + ".yaml").description.value();
}

Json expected(const std::string& name) {
  return read_json_file(kFolder + name + ".expected.json");
}

/// Results of a lay that has an equilibrium.
StaticResults solve_rest(const Description& description) {
  Model model = build_model(description);
  const ModelEquilibrium outcome = solve_lay(model);
  if (outcome.failure) {
    ADD_FAILURE() << outcome.failure->what << ": " << outcome.failure->why;
    return {};
  }
  return recover_state(model, *outcome.solution);
}

bool warned(const StaticResults& lay, const std::string& message) {
  return std::ranges::any_of(messages(lay.findings),
                             [&](const std::string& w) { return w.find(message) != std::string::npos; });
}

void expect_stinger(const StaticResults& lay, const Json& wanted) {
  ASSERT_EQ(lay.stinger.size(), 1U);
  const StingerSectionResult& stinger = lay.stinger[0];
  const Json& w = wanted["stinger"];
  EXPECT_NEAR(stinger.angle, w["angle"].get<double>(), 1e-4);
  const double force = w["hinge_force"]["magnitude"].get<double>();
  EXPECT_NEAR(stinger.hinge_force, force, std::max(0.005 * force, 500.0));
  EXPECT_NEAR(stinger.hinge_longitudinal, w["hinge_force"]["longitudinal"].get<double>(), 500.0);
  EXPECT_NEAR(stinger.hinge_vertical, w["hinge_force"]["vertical"].get<double>(), std::max(0.005 * force, 500.0));
  EXPECT_NEAR(stinger.roller_moment, w["roller_moment"].get<double>(), 0.005 * std::abs(stinger.roller_moment));
  EXPECT_NEAR(stinger.stop_moment, w["stop_moment"].get<double>(), 5e3);
  EXPECT_EQ(stinger.at_stop, w["at_stop"].get<bool>());
  const std::size_t tanks = w.contains("tanks") ? w["tanks"].size() : 0;
  ASSERT_EQ(stinger.tanks.size(), tanks);
  for (std::size_t i = 0; i < tanks; ++i) {
    EXPECT_NEAR(stinger.tanks[i].buoyancy, w["tanks"][i]["buoyancy"].get<double>(), 300.0);
    EXPECT_NEAR(stinger.tanks[i].at_x, w["tanks"][i]["at_x"].get<double>(), 0.01);
    EXPECT_NEAR(stinger.tanks[i].at_z, w["tanks"][i]["at_z"].get<double>(), 0.01);
  }
  EXPECT_NEAR(lay.bottom_tension, wanted["bottom_tension"].get<double>(), 1e-3 * lay.bottom_tension);
  EXPECT_NEAR(lay.lay_back, wanted["lay_back"].get<double>(), 0.1);
}

/// Restoring of the reference, by turning its stinger [N m/rad].
double restoring(const Json& accuracy) {
  return -1e3 * accuracy["restoring_kNm_per_deg"].get<double>() / kDegree;
}

TEST(stinger_rest, with_constant_buoyancy_is_that_of_the_reference) {
  const Json wanted = expected("HS16-float");
  const StaticResults lay = solve_rest(read("HS16-float"));
  expect_stinger(lay, wanted["static"]);
  const double stiffness = restoring(wanted["accuracy"]);
  EXPECT_NEAR(lay.stinger[0].stiffness, stiffness, 0.02 * stiffness);
  EXPECT_GT(lay.stinger[0].natural_period, 0.0);
}

TEST(stinger_rest, at_its_stop_is_that_of_the_reference) {
  const StaticResults lay = solve_rest(read("HS16-stop"));
  expect_stinger(lay, expected("HS16-stop")["static"]);
  EXPECT_TRUE(warned(lay, "lower stop"));
}

TEST(stinger_rest, on_tanks_is_that_of_the_reference) {
  const Json wanted = expected("HS16-tanks");
  const StaticResults lay = solve_rest(read("HS16-tanks"));
  expect_stinger(lay, wanted["static"]);
  const double stiffness = restoring(wanted["accuracy"]);
  EXPECT_NEAR(lay.stinger[0].stiffness, stiffness, 0.02 * stiffness);
}

TEST(stinger_rest, follows_the_ballast_through_the_stages_of_the_reference) {
  const Description d = read("HS16-ballast");
  const Json wanted = expected("HS16-ballast")["operation"]["stages"];
  const std::vector<LayStageDescription> stages = lay_stages(d);
  ASSERT_EQ(stages.size(), wanted.size());
  std::optional<StaticSolution> last;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    SCOPED_TRACE(stages[i].name);
    Model model = build_model(make_stage_description(d, stages[i]));
    ModelEquilibrium outcome = solve_lay(model, last ? &*last : nullptr);
    ASSERT_TRUE(outcome.solution) << outcome.failure->why;
    expect_stinger(recover_state(model, *outcome.solution), wanted[i]);
    last = std::move(outcome.solution);
  }
}

/// All that holds the stinger: its hinge takes what weight, buoyancy and rollers leave, and no moment.
TEST(stinger_rest, leaves_no_moment_about_the_hinge) {
  Model model = build_model(read("HS16-float"));
  const ModelEquilibrium outcome = solve_lay(model);
  ASSERT_TRUE(outcome.solution);
  StaticSystem system = system_with_history(model, outcome.solution->mesh, {});
  system.evaluate(outcome.solution->state, false);
  EXPECT_NEAR(hinge_moments(model, pipe_on_sections(system))[0], 0.0, 10.0);
}

TEST(stinger_rest, does_not_depend_on_where_the_search_begins) {
  const Description d = read("HS16-tanks");
  Model from_drawn = build_model(d), from_there = build_model(d);
  ModelEquilibrium first = solve_lay(from_drawn);
  ASSERT_TRUE(first.solution);
  const double angle = first.solution->stinger.angles[0];
  StaticSolution start = std::move(*first.solution);
  start.stinger.angles[0] = angle + 0.03;
  start.stinger.stiffness.clear();
  const ModelEquilibrium second = solve_lay(from_there, &start);
  ASSERT_TRUE(second.solution);
  EXPECT_NEAR(second.solution->stinger.angles[0], angle, 1e-6);
}

TEST(stinger_rest, is_held_by_the_ship_where_an_angle_is_given) {
  Description d = read("HS16-float");
  const StaticResults floating = solve_rest(d);
  d.supports.sections[0].angle = floating.stinger[0].angle;
  const StaticResults held = solve_rest(d);
  EXPECT_FALSE(held.stinger[0].floats);
  EXPECT_NEAR(held.stinger[0].stop_moment, 0.0, 100.0);
  EXPECT_NEAR(held.lay_back, floating.lay_back, 0.01);  // on another mesh
  d.supports.sections[0].angle = floating.stinger[0].angle + 0.01;
  EXPECT_GT(solve_rest(d).stinger[0].stop_moment, 1e4);  // it would float up
}

TEST(stinger_rest, with_hinge_friction_has_the_range_in_which_the_moment_stays_below_it) {
  Description d = read("HS16-float");
  d.supports.sections[0].hinge_friction = 100e3;
  const StaticResults lay = solve_rest(d);
  const StingerSectionResult stinger = lay.stinger[0];
  EXPECT_LT(stinger.angle_up, stinger.angle);
  EXPECT_GT(stinger.angle_down, stinger.angle);
  d.supports.sections[0].angle = stinger.angle_down;
  EXPECT_NEAR(solve_rest(d).stinger[0].stop_moment, 100e3, 500.0);
  d.supports.sections[0].angle = stinger.angle_up;
  EXPECT_NEAR(solve_rest(d).stinger[0].stop_moment, -100e3, 500.0);
}

/// The same stinger in two sections, with no moment left about either hinge.
TEST(stinger_rest, of_two_sections_balances_both) {
  Description d = read("HS16-float");
  StingerSectionDescription& first = d.supports.sections[0];
  StingerSectionDescription second = first;
  second.hinge = {20.5, -11.0};
  first.body->weight = 800e3;
  first.body->at = {10.0, -6.0};
  first.body->buoyancy = 860e3;
  first.body->buoyancy_at = StingerPoint{10.5, -6.0};
  second.body->weight = 700e3;
  second.body->at = {28.0, -15.0};
  second.body->buoyancy = 740e3;
  second.body->buoyancy_at = StingerPoint{28.5, -14.5};
  d.supports.sections.push_back(second);
  for (BoxDescription& box : d.supports.boxes) box.section = box.x > 20.5 ? 1 : 0;
  Model model = build_model(d);
  const ModelEquilibrium outcome = solve_lay(model);
  ASSERT_TRUE(outcome.solution) << outcome.failure->why;
  StaticSystem system = system_with_history(model, outcome.solution->mesh, {});
  system.evaluate(outcome.solution->state, false);
  for (const double moment : hinge_moments(model, pipe_on_sections(system))) EXPECT_NEAR(moment, 0.0, 50.0);
  const StaticResults lay = recover_state(model, *outcome.solution);
  ASSERT_EQ(lay.stinger.size(), 2U);
  for (const StingerSectionResult& section : lay.stinger) EXPECT_GT(section.stiffness, 0.0);
}

TEST(stinger_rest, says_that_a_heavy_stinger_is_suspended_freely) {
  Description d = read("HS16-float");
  d.supports.sections[0].body->buoyancy = 1100e3;
  std::erase_if(d.supports.boxes, [](const BoxDescription& b) { return b.x > 0.0 && b.x < 10.0; });
  const StaticResults lay = solve_rest(d);
  ASSERT_EQ(lay.stinger.size(), 1U);
  EXPECT_TRUE(warned(lay, "hangs free"));
  // tan(angle) of W a - B b as drawn about the hinge: (18 W - 20 B) cos - 7.5 (W - B) sin = 0.
  const double weight = 1500e3, buoyancy = 1100e3;
  EXPECT_NEAR(lay.stinger[0].angle, std::atan2(18.0 * weight - 20.0 * buoyancy, 7.5 * (weight - buoyancy)), 1e-6);
}

/// Top-heavy: pressed by the pipe against its upper stop, or fallen on the lower one.
TEST(stinger_rest, reports_another_equilibrium_without_the_pipe) {
  Description d = read("HS16-float");
  StingerSectionDescription& section = d.supports.sections[0];
  section.body->at = {18.0, 0.0};
  section.body->buoyancy_at = StingerPoint{20.0, -5.0};
  section.limits = StingerLimits{-12.0 * kDegree, 40.0 * kDegree};
  std::erase_if(d.supports.boxes, [](const BoxDescription& b) { return b.x > 0.0 && b.x < 10.0; });
  EXPECT_TRUE(warned(solve_rest(d), "another equilibrium near an angle of 40.0 deg"));
  section.limits->down = 10.0 * kDegree;  // the stop comes before it falls
  EXPECT_FALSE(warned(solve_rest(d), "another equilibrium"));
}

TEST(stinger_rest, is_rejected_where_nothing_balances) {
  Description d = read("HS16-float");
  d.supports.sections[0].body->buoyancy = 0.0;
  d.supports.sections[0].body->at = {18.0, 0.0};  // plumb below the hinge it hangs further down than is looked
  Model model = build_model(d);
  const ModelEquilibrium outcome = solve_lay(model);
  ASSERT_TRUE(outcome.failure);
  EXPECT_NE(outcome.failure->what.find("stinger"), std::string::npos) << outcome.failure->what;
}

}  // namespace
}  // namespace overbend
