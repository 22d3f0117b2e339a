#include "resultfiles/static/sensitivity_files.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "report/static/sensitivity_section.h"
#include "resultfiles/static/results_reader.h"
#include "resultfiles/static/results_writer.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

/// One result by two inputs, of which the second closes a contact half way down its tolerance.
SensitivityResults two_inputs() {
  SensitivityResults s;
  s.inputs = {{"tensioner.tension", "tensioner.tension", "Set tension.", "N", "kN", 250e3, 2.5e3, true, {}},
              {"supports.stinger.boxes[2].z",
               "supports.stinger.boxes[stinger 3].z",
               "Height.",
               "m",
               "m",
               -8.0,
               0.01,
               false,
               {"stinger 4"}}};
  s.results = {{"static.bottom_tension", "Horizontal tension at touchdown", "N", 205e3, true}};
  s.derivatives = {{1.0, {}, false, 0.0, 0.0}, {4e4, "stinger 4", true, -8.005, 1e5}};
  s.without_effect = {"vessel.length"};
  s.assumptions = {{AssumptionRank::setting, "mesh held"}};
  s.wall_time = 0.5;
  return s;
}

TEST(sensitivity_files, an_effect_takes_the_derivative_beyond_the_contact_that_changes) {
  const SensitivityResults s = two_inputs();
  EXPECT_DOUBLE_EQ(s.effect(0, 0, 1.0), 2.5e3);
  EXPECT_DOUBLE_EQ(s.effect(0, 1, 1.0), 4e4 * 0.01);
  EXPECT_NEAR(s.effect(0, 1, -1.0), -(4e4 * 0.005 + 1e5 * 0.005), 1e-6);
  EXPECT_EQ(s.most_influential_inputs(0, 5), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(s.most_influential_inputs(0, 1), (std::vector<std::size_t>{0}));
}

TEST(sensitivity_files, results_h5_gives_back_what_was_written) {
  const testing::TemporaryFolder folder;
  const testing::SolvedCase& lay = testing::solved_case("BGL1-T250");
  const SensitivityResults s = two_inputs();
  write_static_files(lay.results, lay.description, folder.path(), &s);
  const auto back = read_static_results(folder / "results.h5").sensitivities.value();
  EXPECT_EQ(back.inputs.at(1).name, s.inputs[1].name);
  EXPECT_EQ(back.inputs.at(0).own_tolerance, true);
  EXPECT_EQ(back.at(0, 1).value, 4e4);
  EXPECT_EQ(back.at(0, 1).support, "stinger 4");
  EXPECT_EQ(back.at(0, 1).beyond, 1e5);
  EXPECT_EQ(back.without_effect, s.without_effect);
  EXPECT_EQ(sensitivity_section(back).json(), sensitivity_section(s).json());
  EXPECT_NE(testing::file_text(folder / "summary.json").find("\"sensitivities\""), std::string::npos);
  EXPECT_NE(testing::file_text(folder / "sensitivities.csv")
                .find("static.bottom_tension,supports.stinger.boxes[stinger 3].z,40000,N / (m),0.01,"),
            std::string::npos);
}

TEST(sensitivity_files, an_analysis_without_them_says_nothing_of_them) {
  const testing::TemporaryFolder folder;
  const testing::SolvedCase& lay = testing::solved_case("BGL1-T250");
  write_static_files(lay.results, lay.description, folder.path());
  EXPECT_FALSE(read_static_results(folder / "results.h5").sensitivities);
  EXPECT_EQ(testing::file_text(folder / "summary.json").find("\"sensitivities\""), std::string::npos);
}

TEST(sensitivity_section, marks_what_holds_on_one_side_only_and_names_the_box) {
  const Json section = sensitivity_section(two_inputs()).json().front();
  EXPECT_EQ(section["heading"], "Sensitivity analysis");
  const Json& data = section["body"][1]["data"];
  EXPECT_EQ(data["bars"].size(), 2U);
  ASSERT_EQ(data["notes"].size(), 1U);
  EXPECT_NE(data["notes"][0].get<std::string>().find("4 closes at -8.005 m; beyond, the derivative is 2.5 times that"),
            std::string::npos);
  const auto marked = [](const Json& bar) { return bar["high_label"].get<std::string>().ends_with(" *"); };
  EXPECT_EQ(std::ranges::count_if(data["bars"], marked), 1);
}

}  // namespace
}  // namespace overbend
