#include "study/campaign/study_findings.h"

#include <gtest/gtest.h>

#include "app/program.h"
#include "app/small_lay.h"
#include "modelfile/study_file/study_reader.h"
#include "runstore/staged_folder.h"
#include "study/campaign/study_execution.h"

namespace overbend {
namespace {

using testing::Scratch;

constexpr const char* kAiry = "waves: {type: airy, height: 1 m, period: 7 s, from: 60 deg}";

/// The small lay in a sea, and a study of it.
struct Tried {
  Scratch scratch;
  std::optional<CaseBase> base;
  std::optional<StudyCases> cases;

  Tried(const std::string& text, const std::string& waves) {
    scratch.write("lay.yaml", testing::with(testing::kSmallLay, testing::kWaves, waves));
    scratch.write("sea.csv", "frequency_hz,density_m2_hz\n0.1,0\n0.15,1\n0.3,0\n");
    StudyReading reading =
        read_study_text("overbend_study: 1\nbase: lay.yaml\nanalysis: dynamic\n" + text, scratch.file("study.yaml"));
    for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
    base.emplace(std::move(reading.base.value()), std::move(reading.study.value()));
    cases.emplace(base->study());
  }
  std::vector<std::string> remarks() const { return messages(study_findings(*base, *cases)); }
};

TEST(study_findings, a_wave_height_that_the_sea_of_a_file_does_not_use_is_reported_for_the_study) {
  const std::string heights = "axes: [{key: environment.waves.hs, values: [1 m, 2 m, 3 m]}]\n";
  const std::string of_file = "waves: {type: user, spectrum_file: sea.csv, from: 60 deg}";
  const Tried tried(heights, of_file);
  ASSERT_EQ(tried.remarks().size(), 1U);
  EXPECT_EQ(tried.remarks()[0], "environment.waves.hs: has no effect for waves of type user and is not used");
  const std::string of_one_shape = "waves: {type: jonswap, hs: 1 m, tp: 7 s, gamma: 2, from: 60 deg}";
  EXPECT_TRUE(Tried(heights, of_one_shape).remarks().empty());
}

TEST(study_findings, of_a_key_that_some_cases_use_nothing_is_reported) {
  const Tried tried(
      "axes:\n"
      "  - {key: environment.waves.type, values: [jonswap, pierson_moskowitz]}\n"
      "  - {key: environment.waves.gamma, values: ['2', '3']}\n",
      testing::kWaves);
  EXPECT_TRUE(tried.remarks().empty());
}

TEST(study_findings, seeds_of_a_regular_wave_are_reported_as_one_sea) {
  const std::string seeds = "axes: [{key: tensioner.tension, values: [290 kN, 300 kN]}]\nseeds: 3\n";
  const Tried regular(seeds, kAiry);
  ASSERT_EQ(regular.remarks().size(), 1U);
  EXPECT_EQ(regular.remarks()[0], "the sea is not random: all seeds give the same results");
  EXPECT_TRUE(Tried(seeds, testing::kWaves).remarks().empty());
}

TEST(study_findings, stand_in_the_folder_of_the_study_and_in_its_results) {
  const Tried tried("axes: [{key: environment.waves.hs, values: [1 m, 2 m]}]\n", kAiry);
  const std::filesystem::path folder = tried.scratch.file("out");
  open_study(*tried.base, *tried.cases, folder);
  EXPECT_EQ(messages(read_study(folder).findings), tried.remarks());
  EXPECT_EQ(tried.remarks().size(), 1U);
}

TEST(study_findings, a_peak_enhancement_that_follows_the_height_is_reported_for_the_study) {
  const std::string heights = "axes: [{key: environment.waves.hs, values: [0.5 m, 4 m]}]\n";
  const std::string by_rule = "waves: {type: jonswap, hs: 1 m, tp: 7 s, from: 60 deg}";
  const std::string given = "waves: {type: jonswap, hs: 1 m, tp: 7 s, gamma: 2, from: 60 deg}";
  const std::vector<std::string> remarks = Tried(heights, by_rule).remarks();
  ASSERT_EQ(remarks.size(), 1U);
  // exp(5.75 - 1.15 Tp / sqrt(Hs)) between 1 and 5
  EXPECT_NE(remarks[0].find("from 1 to 5 in this study"), std::string::npos) << remarks[0];
  EXPECT_NE(remarks[0].find("environment.waves.gamma"), std::string::npos);
  EXPECT_TRUE(Tried(heights, given).remarks().empty());
}

}  // namespace
}  // namespace overbend
