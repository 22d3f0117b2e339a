// Sensitivities of key results for the page.
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::Serving;

const Json& result_named(const Json& answer, const std::string& name) {
  static const Json kNone;
  for (const Json& result : answer["results"]) {
    if (result["name"] == name) return result;
  }
  ADD_FAILURE() << "no result " << name << " in " << json_text(answer).substr(0, 300);
  return kNone;
}

TEST(serve_sensitivities, the_tension_moves_the_bottom_tension_by_as_much) {
  const Serving serving(kSmallLay);
  const Json answer = serving.post("/api/sensitivities", Json::object()).json;
  ASSERT_EQ(answer["status"], "converged") << answer;
  const Json& inputs = result_named(answer, "static.bottom_tension")["inputs"];
  ASSERT_LE(inputs.size(), 12U);
  EXPECT_EQ(inputs[0]["name"], "tensioner.tension");
  EXPECT_EQ(inputs[0]["tolerance"], "3 kN");  // 1 % of 300 kN
  EXPECT_EQ(inputs[0]["usual"], true);
  EXPECT_NEAR(inputs[0]["up"].get<double>(), 1.0, 0.05);
  EXPECT_NEAR(inputs[0]["down"].get<double>(), -1.0, 0.05);
}

TEST(serve_sensitivities, changes_go_on_top_and_what_cannot_be_solved_says_so) {
  const Serving serving(kSmallLay);
  const Json changed = {{"changes", {{{"path", "tensioner.tension"}, {"value", "400 kN"}}}}};
  const Json answer = serving.post("/api/sensitivities", changed).json;
  EXPECT_EQ(result_named(answer, "static.bottom_tension")["inputs"][0]["tolerance"], "4 kN");
  const Json low = {{"changes", {{{"path", "tensioner.tension"}, {"value", "1 N"}}}}};
  EXPECT_EQ(serving.post("/api/sensitivities", low).json["status"], "failed");
}

}  // namespace
}  // namespace overbend
