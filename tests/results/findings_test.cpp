#include "results/findings.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

using Texts = std::vector<std::string>;

Finding about(const std::string& message) {
  return {FindingCode::free_spans, message};
}

TEST(findings, of_a_run_in_time_are_its_own_and_then_those_of_statics_each_once) {
  StaticResults statics;
  statics.stations.resize(1);
  statics.findings = {about("of both"), about("of statics")};
  DynamicResults results;
  results.findings = {about("in time"), about("of both")};
  EXPECT_EQ(messages(all_findings(statics, results)), (Texts{"in time", "of both", "of statics"}));
}

}  // namespace
}  // namespace overbend
