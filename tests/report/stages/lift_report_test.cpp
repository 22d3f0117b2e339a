// The page of a lift: side view with all lines, and the same page from stored results.
#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "report/page_text.h"
#include "report/stages/operation_report.h"
#include "resultfiles/stages/operation_reader.h"
#include "resultfiles/stages/operation_writer.h"
#include "study/stages/lift.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::count;

const Description& described() {
  static const Description kLift =
      read_model(OVERBEND_SOURCE_DIR "/validation/lift_cases/TI12-closed.yaml").description.value();
  return kLift;
}

const OperationResults& solved() {
  static const OperationResults kResults = solve_lift(described(), {});
  return kResults;
}

std::string side_view(const OperationResults& results) {
  const std::string page = operation_report_html(results, described().source_text);
  const std::size_t from = page.find("<figure id=\"lift-shape\">");
  return from == std::string::npos ? "" : page.substr(from, page.find("</figure>", from) - from);
}

// Two pipes and four wires at every stage, a circle for each wire and for the weld, water and bed.
TEST(lift_report, draws_all_lines_of_every_stage_with_water_and_bed) {
  const std::string figure = side_view(solved());
  const std::size_t stages = solved().stages.size();
  std::size_t welds = 0;
  for (const StageResult& stage : solved().stages) welds += stage.lay->lift->join ? 1 : 0;
  EXPECT_EQ(count(figure, "class=\"curve\""), 2 * stages);
  EXPECT_EQ(count(figure, "class=\"curve thin\""), 4 * stages);
  EXPECT_EQ(count(figure, "class=\"mark\""), 4 * stages + welds);
  EXPECT_EQ(count(figure, "class=\"water\""), 1u);
  EXPECT_EQ(count(figure, "class=\"ground\""), 1u);
  EXPECT_EQ(count(figure, "nan"), 0u);
}

TEST(lift_report, draws_the_same_from_stored_results) {
  const testing::TemporaryFolder folder;
  write_operation_files(solved(), described(), folder.path());
  EXPECT_EQ(side_view(read_operation_results(folder.path() / "results.h5").results), side_view(solved()));
}

// One verdict for each stage, with the check that decides and the line it is of.
TEST(lift_report, has_the_verdict_of_every_stage_and_names_the_lines_of_its_checks) {
  const std::string page = testing::visible(operation_report_html(solved(), described().source_text));
  EXPECT_NE(page.find("Verdict"), std::string::npos);
  EXPECT_NE(page.find("line &quot;pipe A&quot;"), std::string::npos);
  EXPECT_EQ(page.find("from the tensioner"), std::string::npos);
}

}  // namespace
}  // namespace overbend
