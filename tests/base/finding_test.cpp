#include "base/finding.h"

#include <gtest/gtest.h>

#include <set>

#include "base/findings_page.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

Finding off_rollers(const std::string& box, double distance) {
  return Finding{FindingCode::pipe_off_rollers, "the pipe has left '" + box + "'"}
      .on(box)
      .at_place(41.5)
      .at_time(3.25)
      .with("distance", distance, "m");
}

TEST(finding, codes_have_names_of_their_own_a_meaning_and_a_remedy) {
  std::set<std::string_view> names;
  for (const FindingKind& finding_kind : finding_kinds()) {
    EXPECT_TRUE(names.insert(finding_kind.name).second) << finding_kind.name;
    EXPECT_EQ(finding_kind.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos)
        << finding_kind.name;
    EXPECT_TRUE(finding_kind.meaning.ends_with('.')) << finding_kind.name;
    EXPECT_TRUE(finding_kind.remedy.ends_with('.')) << finding_kind.name;
    EXPECT_EQ(find_finding_code(finding_kind.name), finding_kind.code);
  }
  EXPECT_FALSE(find_finding_code("something else").has_value());
}

TEST(findings_page, the_committed_page_is_current) {
  EXPECT_EQ(testing::file_text(std::string(OVERBEND_SOURCE_DIR) + "/docs/guide/findings.md"), findings_page())
      << "run: build/release/overbend schema --findings > docs/guide/findings.md";
}

TEST(finding, is_read_as_it_was_written) {
  Finding finding = off_rollers("stinger 8", 0.57);
  finding.accepted = true;
  EXPECT_EQ(read_finding(finding_json(finding)), finding);
  EXPECT_EQ(read_finding(finding_json({FindingCode::free_spans, "one"})), (Finding{FindingCode::free_spans, "one"}));
  EXPECT_EQ(finding_json(finding)["severity"], "caution");  // accepted
}

TEST(finding, of_a_code_that_this_version_does_not_know_keeps_its_message) {
  const Finding read = read_finding(Json{{"code", "from-the-future"}, {"message", "new"}});
  EXPECT_EQ(read.code, FindingCode::unknown);
  EXPECT_EQ(read.message, "new");
}

TEST(finding, of_six_boxes_the_first_comes_before_compression_and_the_others_after_it) {
  const Findings sorted = sorted_by_severity({{FindingCode::unused_input, "unused"},
                                              off_rollers("stinger 7", 0.1),
                                              off_rollers("stinger 6", 0.2),
                                              {FindingCode::free_spans, "span"},
                                              {FindingCode::compression, "compression"}});
  EXPECT_EQ(messages(sorted), (std::vector<std::string>{"the pipe has left 'stinger 7'", "compression",
                                                        "the pipe has left 'stinger 6'", "span", "unused"}));
  EXPECT_EQ(severity_counts(sorted), "3 serious, 1 caution, 1 note");
}

TEST(finding, that_is_accepted_by_name_is_no_longer_serious) {
  Findings findings = {off_rollers("stinger 7", 0.1), {FindingCode::compression, "compression"}};
  accept(findings, {"pipe-off-rollers"});
  EXPECT_EQ(messages(serious_findings(findings)), std::vector<std::string>{"compression"});
  accept(findings, {});
  EXPECT_EQ(count(findings, FindingSeverity::serious), 2U);
}

TEST(finding, of_several_runs_is_one_where_code_and_object_are_with_the_range_of_its_numbers) {
  const std::vector<SharedFinding> shared = shared_findings(
      {{off_rollers("stinger 8", 0.2)}, {off_rollers("stinger 8", 0.9), off_rollers("stinger 7", 0.1)}});
  ASSERT_EQ(shared.size(), 2U);
  EXPECT_EQ(shared[0].runs, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(shared[0].text(), "the pipe has left 'stinger 8' (over the runs: distance 0.2 to 0.9 m)");
  EXPECT_EQ(shared[1].runs, std::vector<std::size_t>{1});
  EXPECT_EQ(shared[1].text(), "the pipe has left 'stinger 7'");
}

TEST(finding, merged_lists_have_each_once) {
  const Findings all = merge({off_rollers("a", 0.1)}, {off_rollers("a", 0.1), off_rollers("b", 0.1)});
  EXPECT_EQ(all.size(), 2U);
}

}  // namespace
}  // namespace overbend
