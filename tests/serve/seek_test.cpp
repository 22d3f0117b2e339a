// Goal seek asked for by the page.
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::Reply;
using testing::Serving;

Json asking(const std::string& result, const std::string& value) {
  return {{"seek",
           {{"vary", {{"key", "tensioner.tension"}, {"from", "250 kN"}, {"to", "400 kN"}}},
            {"until", {{"result", result}, {"equals", value}}}}}};
}

TEST(serve_seek, reports_the_answer_and_the_changes_that_put_it_in) {
  const Serving serving(kSmallLay);
  const Json answer = serving.post("/api/seek", asking("static.bottom_tension", "310 kN")).json;
  ASSERT_EQ(answer["status"], "found") << answer;
  ASSERT_EQ(answer["changes"].size(), 1U);
  EXPECT_EQ(answer["changes"][0]["path"], "tensioner.tension");
  const Json state = serving.post("/api/static", {{"changes", answer["changes"]}, {"full", true}}).json;
  EXPECT_NEAR(state["key"]["bottom_tension"].get<double>(), 310e3, 310.0);  // meshes differ: a per mille
  EXPECT_EQ(serving.get("/api/model").json["text"], kSmallLay);
}

TEST(serve_seek, says_why_there_is_none_and_what_is_wrong_with_the_question) {
  const Serving serving(kSmallLay);
  const Json none = serving.post("/api/seek", asking("static.bottom_tension", "900 kN")).json;
  EXPECT_EQ(none["status"], "none");
  EXPECT_FALSE(none["seek"]["why"].get<std::string>().empty());
  const Json wrong = serving.post("/api/seek", asking("static.bottom_tension", "9 m")).json;
  ASSERT_EQ(wrong["status"], "invalid");
  EXPECT_EQ(wrong["diagnostics"][0]["key"], "seek.until.equals");
}

}  // namespace
}  // namespace overbend
