// The page of a lift: side view with all lines, and the same page from stored results.
#include <gtest/gtest.h>

#include <map>

#include "modelfile/reading/yaml_reader.h"
#include "report/page_text.h"
#include "report/stages/operation_report.h"
#include "resultfiles/stages/operation_reader.h"
#include "resultfiles/stages/operation_writer.h"
#include "study/stages/lift.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

const Description& described() {
  static const Description kLift =
      read_model(OVERBEND_SOURCE_DIR "/validation/lift_cases/TI12-closed.yaml").description.value();
  return kLift;
}

const OperationResults& solved() {
  static const OperationResults kResults = solve_lift(described(), {});
  return kResults;
}

/// Content of its first figure.
Json side_view(const OperationResults& results) {
  const Document document = operation_report_document(results, described().source_text);
  for (const Json& block : testing::section_body(document, "stages")) {
    if (block["kind"] == "figure") return block["data"];
  }
  return nullptr;
}

// Two pipes and four wires at every stage, a circle for each wire and for the weld, water and bed.
TEST(lift_report, draws_all_lines_of_every_stage_with_water_and_bed) {
  const Json figure = side_view(solved());
  const std::size_t stages = solved().stages.size();
  std::size_t welds = 0;
  for (const StageResult& stage : solved().stages) welds += stage.lay->lift->join ? 1 : 0;
  std::map<std::string, std::size_t> looks;
  for (const Json& curve : figure["curves"]) ++looks[curve["look"]];
  EXPECT_EQ(looks["line"], 2 * stages);
  EXPECT_EQ(looks["thin"], 4 * stages);
  EXPECT_EQ(looks["marks"], 4 * stages + welds);
  EXPECT_EQ(figure["water"].size(), 1u);
  EXPECT_EQ(figure["ground"].size(), 1u);
  EXPECT_EQ(json_text(figure).find("null"), std::string::npos);
}

TEST(lift_report, draws_the_same_from_stored_results) {
  const testing::TemporaryFolder folder;
  write_operation_files(solved(), described(), folder.path());
  EXPECT_EQ(side_view(read_operation_results(folder.path() / "results.h5").results), side_view(solved()));
}

// One verdict for each stage, with the check that decides and the line it is of.
TEST(lift_report, has_the_verdict_of_every_stage_and_names_the_lines_of_its_checks) {
  const Document document = operation_report_document(solved(), described().source_text);
  const std::string page = testing::section_text(document, "stage-checks");
  EXPECT_NE(page.find("Verdict"), std::string::npos);
  EXPECT_NE(page.find("line \"pipe A\""), std::string::npos);
  EXPECT_EQ(testing::shown_text(document).find("from the tensioner"), std::string::npos);
}

}  // namespace
}  // namespace overbend
