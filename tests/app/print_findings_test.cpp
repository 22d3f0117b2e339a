#include "app/print_findings.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(finding_lines, have_their_severity_and_code_and_the_serious_ones_come_first) {
  EXPECT_EQ(finding_lines({{FindingCode::unused_input, "lay.yaml:12: supports: no box uses this type of roller"},
                           {FindingCode::compression, "compression: -3 kN"}}),
            "  serious: compression: -3 kN [compression]\n"
            "  note: lay.yaml:12: supports: no box uses this type of roller [unused-input]\n");
}

TEST(finding_lines, of_several_runs_say_how_many_have_each) {
  const Finding low = Finding{FindingCode::compression, "falls to -3 kN"}.on("pipe").with("tension", -3e3, "N");
  const Finding lower = Finding{FindingCode::compression, "falls to -9 kN"}.on("pipe").with("tension", -9e3, "N");
  EXPECT_EQ(shared_finding_lines({{low}, {}, {lower}}, "seeds"),
            "  serious (2 of 3 seeds): falls to -9 kN (over the runs: tension -9 to -3 kN) [compression]\n");
}

}  // namespace
}  // namespace overbend
