#include "study/run/model_statics.h"

#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "results/verdict.h"

namespace overbend {
namespace {

TEST(model_statics, judge_a_hull_alone_by_its_lines_and_anchors) {
  Model model = build_model(read_model(OVERBEND_SOURCE_DIR "/examples/moored-barge.yaml").description.value());
  const ModelStatics found = solve_model(model, nullptr);
  ASSERT_TRUE(found.moorings.has_value());
  EXPECT_EQ(verdict_kind(found.moorings->checks, found.moorings->findings), VerdictKind::passed);
  EXPECT_EQ(worst_check(found.moorings->checks)->id, "anchor_load");
}

}  // namespace
}  // namespace overbend
