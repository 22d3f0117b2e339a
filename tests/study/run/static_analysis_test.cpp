#include "study/run/static_analysis.h"

#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "results/verdict.h"

namespace overbend {
namespace {

TEST(static_run, judges_a_hull_alone_by_its_lines_and_anchors) {
  Model model = build_model(read_model(OVERBEND_SOURCE_DIR "/examples/moored-barge.yaml").description.value());
  const StaticRun found = run_statics(model);
  ASSERT_TRUE(found.results.has_value());
  EXPECT_EQ(verdict_kind(found.results->checks, found.results->findings), VerdictKind::passed);
  EXPECT_EQ(find_governing_check(found.results->checks)->id, "anchor_load");
}

}  // namespace
}  // namespace overbend
