#include "results/warnings.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

using Texts = std::vector<std::string>;

TEST(warnings, of_a_run_in_time_are_its_own_and_then_those_of_statics_each_once) {
  StaticResults statics;
  statics.warnings = {"of both", "of statics"};
  DynamicResults results;
  results.warnings = {"in time", "of both"};
  EXPECT_EQ(all_warnings(statics, results), (Texts{"in time", "of both", "of statics"}));
}

TEST(warnings, of_statics_without_a_pipe_are_those_of_the_hull_on_its_moorings) {
  StaticResults statics;
  statics.moorings.emplace();
  statics.moorings->warnings = {"of the hull"};
  EXPECT_EQ(static_warnings(statics), Texts{"of the hull"});
  statics.stations.resize(1);
  statics.warnings = {"of the lay"};
  EXPECT_EQ(static_warnings(statics), Texts{"of the lay"});
}

}  // namespace
}  // namespace overbend
