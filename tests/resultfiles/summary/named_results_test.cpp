#include "resultfiles/summary/named_results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "resultfiles/summary/study_outputs.h"
#include "resultfiles/summary/summary_json.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::solved_case;

TEST(named_results, are_the_numbers_of_the_summary) {
  const StaticResults& r = solved_case("BGL1-T250").results;
  const Json summary = static_summary_json(r);
  EXPECT_EQ(named_result(summary, "static.sagbend.max_bending_stress"), r.sagbend.bending_stress.value);
  EXPECT_EQ(named_result(summary, "static.touchdown.z"), r.touchdown.p_W.z());
  EXPECT_EQ(named_result(summary, "static.stinger_tip_clearance"), r.stinger_tip_clearance);
  EXPECT_EQ(named_result(summary, "static.top_inclination"), r.stations.back().inclination);
  EXPECT_EQ(named_result(summary, "checks.worst.utilisation"), find_governing_check(r.checks)->utilisation);
}

TEST(named_results, find_items_of_lists_by_index_and_by_name) {
  const StaticResults& r = solved_case("BGL1-T250").results;
  const Json summary = static_summary_json(r);
  EXPECT_EQ(named_result(summary, "static.supports[3].separation"), r.supports[3].separation);
  EXPECT_EQ(named_result(summary, "static.supports[" + r.supports[5].name + "].reaction"), r.supports[5].reaction);
  EXPECT_EQ(named_result(summary, "static.supports[0].rows[0].bottom.reaction"),
            r.supports[0].rows[0].rollers[0].reaction);
  EXPECT_FALSE(named_result(summary, "static.supports[nobody].reaction"));
  EXPECT_FALSE(named_result(summary, "static.supports[99].reaction"));
}

TEST(named_results, gather_what_a_pattern_matches) {
  const StaticResults& r = solved_case("BGL1-T250").results;
  const Json summary = static_summary_json(r);
  const std::vector<double> all = named_values(summary, "static.supports[*].reaction");
  ASSERT_EQ(all.size(), r.supports.size());
  EXPECT_FALSE(named_result(summary, "static.supports[*].reaction"));  // several numbers are no number
  EXPECT_EQ(named_result(summary, "max(static.supports[*].reaction)"), *std::max_element(all.begin(), all.end()));
  EXPECT_EQ(named_result(summary, "min(static.supports[*].reaction)"), *std::min_element(all.begin(), all.end()));
  const double mean = named_result(summary, "mean(static.supports[*].reaction)").value();
  double squares = 0.0;
  for (const double value : all) squares += value * value;
  const double count = static_cast<double>(all.size());
  EXPECT_NEAR(named_result(summary, "spread(static.supports[*].reaction)").value(),
              std::sqrt(squares / count - mean * mean), 1e-9 * mean);
}

TEST(named_results, of_a_stage_are_those_of_a_lay_and_its_own) {
  const auto unit = [](const std::string& name) {
    const auto output = study_output(StudyAnalysis::operation, name, {});
    return output ? output->unit : "";
  };
  EXPECT_EQ(unit("operation.stages[2].head.z"), "m");
  EXPECT_EQ(unit("operation.stages[half way].barge_ahead"), "m");
  EXPECT_EQ(unit("max(operation.stages[*].tension)"), "N");
  EXPECT_EQ(unit("operation.stages[2].governing"), "");
  EXPECT_FALSE(study_output(StudyAnalysis::statics, "operation.stages[2].tension", {}));
}

TEST(named_results, have_the_unit_of_their_dimension) {
  EXPECT_EQ(result_unit("static.sagbend.max_bending_stress"), "N/m^2");
  EXPECT_EQ(result_unit("static.overbend.max_bending_moment"), "N*m");
  EXPECT_EQ(result_unit("spread(static.supports[*].reaction)"), "N");
  EXPECT_EQ(result_unit("static.supports[stinger 7].rows[0].bottom.reaction"), "N");
  EXPECT_EQ(result_unit("static.touchdown.z"), "m");
  EXPECT_EQ(result_unit("static.head.z"), "m");
  EXPECT_EQ(result_unit("static.stinger.tip_roller.z"), "m");
  EXPECT_EQ(result_unit("static.stinger.sections[outer].angle"), "rad");
  EXPECT_EQ(result_unit("static.departure_angle"), "rad");
  EXPECT_EQ(result_unit("static.moorings[line 1].fairlead_tension"), "N");
  EXPECT_EQ(result_unit("static.vessel.surge"), "m");
  EXPECT_EQ(result_unit("checks.worst.utilisation"), "1");
  EXPECT_FALSE(result_unit("static.sagbend.max_bending"));
  EXPECT_FALSE(result_unit("static.supports.reaction"));
  EXPECT_FALSE(result_unit("checks.worst.demand"));  // a strain, a moment or a stress, as the check has it
}

TEST(named_results, of_stages_of_a_lift_have_units) {
  EXPECT_EQ(result_unit("operation.stages[welded].lines[pipe].first_end.z"), "m");
  EXPECT_EQ(result_unit("operation.stages[2].lines.east pipe.first_end.inclination"), "rad");
  EXPECT_EQ(result_unit("max(operation.stages[*].lines[*].largest_bending_moment.value)"), "N*m");
  EXPECT_EQ(result_unit("operation.stages[2].lines[*].largest_bending_stress"), "N/m^2");
  EXPECT_EQ(result_unit("operation.stages[2].davits.davit 1.tension_upper"), "N");
  EXPECT_EQ(result_unit("operation.stages[2].davits[davit 1].force_on_pipe.x"), "N");
  EXPECT_EQ(result_unit("operation.stages[2].davits[davit 1].attachment.x"), "m");
  EXPECT_EQ(result_unit("operation.stages[2].gap.angle"), "rad");
  EXPECT_EQ(result_unit("operation.stages[2].join.moment"), "N*m");
  EXPECT_EQ(result_unit("operation.stages[2].checks.worst.utilisation"), "1");
  EXPECT_FALSE(result_unit("operation.stages[2].lines[pipe].first_end.heading"));
  EXPECT_FALSE(result_unit("operation.stages[2].lines[pipe].name"));
}

TEST(named_results, of_stages_of_a_pull_have_units) {
  EXPECT_EQ(result_unit("operation.stages[2].tension.winch"), "N");
  EXPECT_EQ(result_unit("operation.stages[2].wire_utilisation"), "1");
  EXPECT_EQ(result_unit("operation.stages[2].sagbend.moment"), "N*m");
  EXPECT_EQ(result_unit("operation.stages[2].sagbend.max_von_mises"), "N/m^2");
  EXPECT_EQ(result_unit("max(operation.stages[*].winch.inclination)"), "rad");
  EXPECT_FALSE(result_unit("operation.stages[2].tension.bow"));
}

TEST(named_results, choose_lines_and_davits_by_name_or_pattern) {
  const Json davits = {
      {"davit 1", {{"tension", 3.0}}}, {"davit 10", {{"tension", 5.0}}}, {"sling", {{"tension", 9.0}}}};
  const Json summary = {{"operation", {{"stages", Json::array({{{"name", "up"}, {"davits", davits}}})}}}};
  EXPECT_EQ(named_result(summary, "operation.stages[up].davits.davit 1.tension"), 3.0);
  EXPECT_EQ(named_result(summary, "operation.stages[0].davits[davit 10].tension"), 5.0);
  EXPECT_EQ(named_result(summary, "max(operation.stages[0].davits[davit *].tension)"), 5.0);
  EXPECT_EQ(named_values(summary, "operation.stages[*].davits[*].tension").size(), 3U);
  EXPECT_FALSE(named_result(summary, "operation.stages[0].davits[davit 2].tension"));
}

TEST(named_results, every_number_of_a_summary_has_a_unit_or_depends_on_its_row) {
  const std::vector<std::string> paths = result_paths();
  EXPECT_GT(paths.size(), 80U);
  for (const char* path : {"static.supports[].reaction", "static.stinger_tip_clearance", "checks.list[].utilisation"}) {
    EXPECT_NE(std::find(paths.begin(), paths.end(), path), paths.end()) << path;
  }
}

}  // namespace
}  // namespace overbend
