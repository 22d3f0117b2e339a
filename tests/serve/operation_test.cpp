// The stages of an operation on the line as the page gets them.
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::Reply;
using testing::Serving;

/// The barge of the small lay goes ahead; the last stage has too little tension.
const std::string kMove = std::string(kSmallLay) + R"(
operation:
  type: move
  stages:
    - {ahead: 0 m, tension: 300 kN}
    - {name: half a joint, ahead: 6 m, tension: 320 kN}
    - {ahead: 12 m, tension: 1 kN}
)";

TEST(serve_operation, stages_come_as_a_table_and_each_line_by_itself) {
  const Serving serving(kMove);
  const Json answer = serving.post("/api/operation", Json::object()).json;
  ASSERT_EQ(answer["status"], "solved") << answer;
  EXPECT_EQ(answer["title"], "Move ahead");
  ASSERT_EQ(answer["stages"].size(), 3u);
  EXPECT_EQ(answer["stages"][1]["name"], "half a joint");
  EXPECT_EQ(answer["stages"][1]["out"], 6.0);
  EXPECT_TRUE(answer["stages"][1]["parts"].is_null());  // no cable
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const Json& row = answer["stages"][i]["values"];
    const Json stage = serving.get("/api/operation/stages/" + std::to_string(i)).json;
    ASSERT_EQ(stage["status"], "converged");
    EXPECT_EQ(row["top_tension"], stage["key"]["top_tension"]);
    EXPECT_EQ(row["sagbend_von_mises"], stage["key"]["sagbend"]["von_mises"]);
    EXPECT_FALSE(stage["pipe"]["effective_tension"].empty());
  }
  EXPECT_GT(answer["stages"][1]["values"]["top_tension"], answer["stages"][0]["values"]["top_tension"]);
}

TEST(serve_operation, a_stage_that_cannot_be_says_why_and_leaves_the_others) {
  const Serving serving(kMove);
  const Json answer = serving.post("/api/operation", Json::object()).json;
  const Json& last = answer["stages"][2];
  EXPECT_TRUE(last["values"].is_null());
  EXPECT_FALSE(last["failure"]["why"].get<std::string>().empty());
  EXPECT_EQ(serving.get("/api/operation/stages/2").status, 404);
}

TEST(serve_operation, has_a_report_with_the_procedure_sheet_when_it_is_solved) {
  const Serving serving(kMove);
  EXPECT_EQ(serving.get("/api/operation/report.html").status, 404);
  serving.post("/api/operation", Json::object());
  const Reply report = serving.get("/api/operation/report.html");
  EXPECT_EQ(report.status, 200);
  EXPECT_NE(report.body.find("\"id\":\"procedure\""), std::string::npos);
  EXPECT_NE(report.body.find("half a joint"), std::string::npos);
}

TEST(serve_operation, a_run_may_be_of_one_stage) {
  const Serving serving(kMove);
  const Json stages = serving.post("/api/operation", Json::object()).json["stages"];
  const std::string id = serving.post("/api/runs", {{"kind", "static"}, {"stage", "2"}}).json["id"];
  ASSERT_EQ(serving.wait_for(id)["state"], "done");
  const Json lay = serving.get("/api/runs/" + id + "/statics").json;
  EXPECT_NEAR(lay["key"]["top_tension"].get<double>(), stages[1]["values"]["top_tension"].get<double>(), 1.0);
  const std::string none = serving.post("/api/runs", {{"kind", "static"}, {"stage", "9"}}).json["id"];
  const Json failed = serving.wait_for(none);
  EXPECT_EQ(failed["state"], "failed");
  EXPECT_NE(failed["message"].get<std::string>().find("there is no stage '9'"), std::string::npos);
  EXPECT_EQ(serving.post("/api/runs", {{"kind", "seeds"}, {"stage", "2"}, {"seeds", {1, 2}}}).status, 422);
}

TEST(serve_operation, is_rejected_where_the_model_has_none) {
  const Serving serving(kSmallLay);
  const Reply reply = serving.post("/api/operation", Json::object());
  EXPECT_EQ(reply.status, 422);
  EXPECT_NE(reply.json["error"]["hint"].get<std::string>().find("operation.stages"), std::string::npos);
  EXPECT_EQ(serving.get("/api/operation/stages/0").status, 404);
  EXPECT_EQ(serving.get("/api/operation/stages/x").status, 404);
}

}  // namespace
}  // namespace overbend
