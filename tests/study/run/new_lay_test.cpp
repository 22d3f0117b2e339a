// The choices of `overbend new` must be a lay that passes its own checks, not only a file that reads.
#include "study/run/new_lay.h"

#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

#include "app/new_questions.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/statics.h"
#include "study/run/static_analysis.h"

namespace overbend {
namespace {

NewOptions make_options(const char* pipe, const char* depth, const char* lay) {
  NewOptions options;
  options.pipe = pipe;
  options.depth = depth;
  options.lay = lay;
  return options;
}

/// Checks that the text of a model exceeds, as `static --strict` finds them; "no solution" where there is none.
std::vector<std::string> exceeded_by(const std::string& text) {
  const ModelReading reading = read_model_text(text, "new.yaml");
  if (!reading.description) return {"not a model"};
  const Model model = build_model(*reading.description);
  const StaticOutcome outcome = solve_statics(model);
  if (!outcome.solution) return {"no solution: " + outcome.failure->what};
  std::vector<std::string> names;
  for (const CheckRow& row : checked_statics(model, {outcome.solution, {}, {}}).checks.rows) {
    if (row.governing && row.status == CheckStatus::exceeded) names.push_back(row.name);
  }
  return names;
}

class NewLayGrid : public ::testing::TestWithParam<const char*> {};

TEST_P(NewLayGrid, passes_its_own_checks_or_says_why_none_does) {
  int rejected = 0;
  for (const char* depth : {"30 m", "100 m", "300 m", "700 m", "1200 m", "2000 m"}) {
    for (const char* lay : {"s", "j"}) {
      const std::string which = std::string(GetParam()) + " in, " + depth + ", " + lay + "-lay";
      const auto chosen = choose_lay(make_options(GetParam(), depth, lay));
      if (const auto* why = std::get_if<std::string>(&chosen)) {
        ++rejected;
        const bool tower = why->find("no tower is inclined") != std::string::npos;
        EXPECT_TRUE(tower || why->find("no wall of API 5L") != std::string::npos) << which << ": " << *why;
        EXPECT_TRUE(!tower || *lay == 'j') << which;
        continue;
      }
      const NewLay& made = std::get<NewLay>(chosen);
      EXPECT_EQ(made.model.note, "") << which;
      EXPECT_EQ(made.model.concrete, 0.0) << which;  // none was asked for
      EXPECT_EQ(exceeded_by(made.text), std::vector<std::string>{}) << which;
    }
  }
  EXPECT_LE(rejected, 4) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(new_lay, NewLayGrid, ::testing::Values("6", "10", "16", "24", "36", "48"));

TEST(new_lay, the_tower_stands_as_the_pipe_is_suspended_from_it) {
  for (const char* depth : {"100 m", "1200 m"}) {
    const NewLay made = std::get<NewLay>(choose_lay(make_options("16", depth, "j")));
    const Model model = build_model(read_model_text(made.text, "new.yaml").description.value());
    const StaticResults r = checked_statics(model, {solve_statics(model).solution, {}, {}});
    const double tower = model.description.tensioner.incline;
    EXPECT_NEAR(r.stations.back().inclination, tower, 0.001) << depth;
    EXPECT_GT(tower, 0.25 * std::numbers::pi) << depth;
  }
}

TEST(new_lay, a_tower_leans_no_further_than_towers_do) {
  const std::string why = std::get<std::string>(choose_lay(make_options("48", "50 m", "j")));
  EXPECT_NE(why.find("no tower is inclined"), std::string::npos) << why;
  EXPECT_EQ(why.rfind("--lay: ", 0), 0U) << why;
}

TEST(new_lay, what_was_said_is_kept_and_the_check_that_it_exceeds_is_noted) {
  NewOptions options = make_options("16", "1500 m", "s");
  options.wall = "15.9 mm";
  const NewLay made = std::get<NewLay>(choose_lay(options));
  EXPECT_DOUBLE_EQ(made.model.wall, 0.0159);
  EXPECT_NE(made.model.note.find("is exceeded"), std::string::npos) << made.model.note;
  EXPECT_NE(made.text.find("# Note: " + made.model.note), std::string::npos);
  EXPECT_NE(exceeded_by(made.text), std::vector<std::string>{});
}

TEST(new_lay, what_no_wall_can_carry_is_rejected_with_the_reason) {
  const std::string why = std::get<std::string>(choose_lay(make_options("48", "3500 m", "j")));
  EXPECT_NE(why.find("no wall of API 5L"), std::string::npos) << why;
}

TEST(new_questions, empty_answers_take_what_is_offered) {
  NewOptions options;
  std::istringstream in("\n120 m\n\n 40 mm \n");  // ends early: the rest is chosen
  std::ostringstream out;
  ask_new_options(options, in, out);
  EXPECT_EQ(options.pipe, kDefaultPipe);
  EXPECT_EQ(options.depth, "120 m");
  EXPECT_EQ(options.wall, "");
  EXPECT_EQ(options.concrete, "40 mm");
  EXPECT_EQ(options.tension, "");
  EXPECT_NE(out.str().find("[16]: "), std::string::npos);
}

TEST(new_questions, what_was_said_is_not_asked_again) {
  NewOptions options = make_options("24", "300 m", "s");
  std::istringstream in;
  std::ostringstream out;
  ask_new_options(options, in, out);
  EXPECT_EQ(options.pipe, "24");
  EXPECT_EQ(out.str().find("pipe size"), std::string::npos);
  EXPECT_EQ(out.str().find("depth"), std::string::npos);
}

}  // namespace
}  // namespace overbend
