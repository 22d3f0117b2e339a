#include "resultfiles/hdf5/dataset_path.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(dataset_path, keeps_the_parts_of_a_name_and_mends_what_hdf5_would_misread) {
  EXPECT_EQ(dataset_path("top_tension"), "top_tension");
  EXPECT_EQ(dataset_path("support/stinger 8/reaction"), "support/stinger 8/reaction");
  EXPECT_EQ(dataset_path("support/./reaction"), "support/_/reaction");
  EXPECT_EQ(dataset_path("a//b/"), "a/_/b/_");
}

}  // namespace
}  // namespace overbend
