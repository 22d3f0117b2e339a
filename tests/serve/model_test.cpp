// The open model: diagnosed, changed key by key, kept in files.
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::Reply;
using testing::Serving;
using testing::with;

Json field(const Json& fields, const std::string& path) {
  for (const Json& item : fields) {
    if (item["path"] == path) return item;
  }
  return nullptr;
}

TEST(serve_model, an_error_is_reported_at_its_line_and_column) {
  const Serving serving(kSmallLay);
  const std::string text = with(kSmallLay, "wall_thickness: 12.7 mm", "wall_thickness: 12.7 kN");
  const Reply reply = serving.put("/api/model", {{"text", text}, {"revision", 1}});
  ASSERT_EQ(reply.json["diagnostics"].size(), 1u) << reply.body;
  const Json error = reply.json["diagnostics"][0];
  EXPECT_EQ(error["severity"], "error");
  EXPECT_EQ(error["line"], 8);
  EXPECT_EQ(error["column"], 55);
  EXPECT_EQ(error["key"], "pipe.steel.wall_thickness");
  EXPECT_NE(error["message"].get<std::string>().find("a length"), std::string::npos) << error;
}

TEST(serve_model, a_text_that_is_no_yaml_is_diagnosed_too) {
  const Serving serving(kSmallLay);
  const Reply reply = serving.put("/api/model", {{"text", "a: [1\nb: 2\n"}, {"revision", 1}});
  EXPECT_EQ(reply.status, 200);
  ASSERT_GE(reply.json["diagnostics"].size(), 1u);
  EXPECT_GE(reply.json["diagnostics"][0]["line"].get<int>(), 1);
  EXPECT_TRUE(reply.json["fields"].empty());
}

TEST(serve_model, fields_report_what_is_written_and_what_could_be) {
  const Serving serving(kSmallLay);
  const Json fields = serving.get("/api/model").json["fields"];
  const Json tension = field(fields, "tensioner.tension");
  EXPECT_EQ(tension["value"], "300 kN");
  EXPECT_EQ(tension["si"], 300e3);
  EXPECT_EQ(tension["unit"], "kN");
  EXPECT_EQ(tension["given"], true);
  EXPECT_EQ(tension["line"], 13);
  const Json box = field(fields, "supports.stinger.boxes[1].x");
  EXPECT_EQ(box["si"], 15.0);
  const Json trim = field(fields, "vessel.trim");
  EXPECT_EQ(trim["given"], false);
  EXPECT_EQ(trim["value"], nullptr);
  EXPECT_FALSE(trim["default"].is_null());
  const Json type = field(fields, "environment.waves.type");
  EXPECT_NE(std::find(type["choices"].begin(), type["choices"].end(), "airy"), type["choices"].end());
  EXPECT_EQ(field(fields, "supports.ramp.boxes")["count"], 3);
}

TEST(serve_model, fields_of_several_groups_of_waves_are_those_of_each) {
  const Serving serving(kSmallLay);
  const Reply changed = serving.post(
      "/api/model/set", {{"revision", 1},
                         {"changes",
                          {{{"path", "environment.waves"},
                            {"value",
                             {{{"type", "jonswap"}, {"hs", "2 m"}, {"tp", "7 s"}, {"from", "240 deg"}},
                              {{"type", "airy"}, {"height", "1 m"}, {"period", "13 s"}, {"from", "300 deg"}}}}}}}});
  ASSERT_EQ(changed.status, 200) << changed.body;
  const Json fields = changed.json["fields"];
  EXPECT_EQ(field(fields, "environment.waves")["count"], 2);
  EXPECT_EQ(field(fields, "environment.waves[0].hs")["value"], "2 m");
  EXPECT_EQ(field(fields, "environment.waves[1].type")["value"], "airy");
  EXPECT_TRUE(field(fields, "environment.waves.type").is_null());
}

TEST(serve_model, setting_a_key_keeps_comments_and_layout) {
  const std::string text = with(kSmallLay, "title: small lay", "title: small lay   # a comment");
  const Serving serving(text);
  const Reply reply =
      serving.post("/api/model/set", {{"revision", 1},
                                      {"changes",
                                       {{{"path", "tensioner.tension"}, {"value", "260 kN"}},
                                        {{"path", "supports.stinger.boxes[1].z"}, {"value", "-7.2 m"}}}}});
  EXPECT_EQ(reply.json["text"], with(with(text, "300 kN", "260 kN"), "-7.18 m", "-7.2 m"));
  EXPECT_EQ(reply.json["revision"], 2);
  EXPECT_EQ(reply.json["saved"], false);
  EXPECT_EQ(field(reply.json["fields"], "tensioner.tension")["si"], 260e3);
}

TEST(serve_model, a_key_that_can_not_be_set_is_422_with_the_reason) {
  const Serving serving(kSmallLay);
  const Reply reply = serving.post(
      "/api/model/set", {{"revision", 1}, {"changes", {{{"path", "supports.ramp.boxes[9].x"}, {"value", "1 m"}}}}});
  EXPECT_EQ(reply.status, 422);
  EXPECT_NE(reply.json["error"]["message"].get<std::string>().find("3 items"), std::string::npos) << reply.body;
  EXPECT_EQ(serving.get("/api/model").json["revision"], 1);
}

TEST(serve_model, a_change_upon_an_older_revision_is_409_with_the_newer_model) {
  const Serving serving(kSmallLay);
  EXPECT_EQ(serving.put("/api/model", {{"text", kSmallLay + "# mine\n"}, {"revision", 1}}).status, 200);
  const Reply late = serving.put("/api/model", {{"text", kSmallLay + "# other\n"}, {"revision", 1}});
  EXPECT_EQ(late.status, 409);
  EXPECT_EQ(late.json["revision"], 2);
  EXPECT_EQ(late.json["text"], kSmallLay + "# mine\n");
  EXPECT_EQ(serving.post("/api/model/set", {{"revision", 1}, {"changes", Json::array()}}).status, 409);
}

TEST(serve_model, a_model_is_saved_and_opened_by_its_bare_name_alone) {
  const Serving serving(kSmallLay);
  const std::string changed = kSmallLay + "# changed\n";
  EXPECT_EQ(serving.put("/api/model", {{"text", changed}, {"revision", 1}}).json["saved"], false);
  EXPECT_EQ(serving.post("/api/model/save", {{"name", "other.yaml"}}).json["saved"], true);
  EXPECT_EQ(testing::file_text(serving.folder / "other.yaml"), changed);
  EXPECT_EQ(testing::file_text(serving.folder / "model.yaml"), kSmallLay);
  EXPECT_EQ(serving.get("/api/files").json["files"].size(), 2u);
  EXPECT_EQ(serving.post("/api/model/open", {{"name", "model.yaml"}}).json["text"], kSmallLay);
  for (const char* name : {"../out.yaml", "/tmp/out.yaml", ".hidden.yaml", "a\\b.yaml", "model.txt", ""}) {
    EXPECT_EQ(serving.post("/api/model/save", {{"name", name}}).status, 422) << name;
    EXPECT_EQ(serving.post("/api/model/open", {{"name", name}}).status, 422) << name;
  }
  EXPECT_EQ(serving.post("/api/model/open", {{"name", "none.yaml"}}).status, 404);
}

TEST(serve_model, a_text_that_is_again_that_of_its_file_is_saved) {
  const Serving serving(kSmallLay);
  EXPECT_EQ(serving.put("/api/model", {{"text", kSmallLay + "# changed\n"}, {"revision", 1}}).json["saved"], false);
  EXPECT_EQ(serving.put("/api/model", {{"text", kSmallLay}, {"revision", 2}}).json["saved"], true);
  const Json unnamed = {{"text", kSmallLay}, {"revision", 3}, {"name", ""}};
  EXPECT_EQ(serving.put("/api/model", unnamed).json["saved"], false);
}

TEST(serve_model, an_example_opens_without_an_error_and_with_its_data) {
  const Serving serving;
  const Json info = serving.get("/api/info").json;
  EXPECT_EQ(info["has_model"], false);
  EXPECT_GE(info["examples"].size(), 3u);
  for (const Json& example : info["examples"]) {
    const Json read = serving.get("/api/examples/" + example["name"].get<std::string>()).json;
    const Json revision = serving.get("/api/model").json["revision"];
    const Json put = serving.put("/api/model", {{"text", read["text"]}, {"revision", revision}, {"name", ""}}).json;
    EXPECT_EQ(json_text(put["diagnostics"]).find("not there"), std::string::npos) << put["diagnostics"];
    for (const Json& d : put["diagnostics"]) EXPECT_EQ(d["severity"], "warning") << d;
  }
  EXPECT_EQ(serving.get("/api/examples/none").status, 404);
}

TEST(serve_model, the_start_dialogue_makes_a_model_that_solves) {
  const Serving serving;
  const Json offer = serving.get("/api/new").json;
  EXPECT_GE(offer["pipes"].size(), 10u);
  EXPECT_GT(offer["pipes"][0]["walls"].size(), 2u);
  const Reply made = serving.post("/api/new", {{"pipe", "16"}, {"depth", "60 m"}, {"lay", "s"}});
  ASSERT_EQ(made.status, 200) << made.body;
  const Json put = serving.put("/api/model", {{"text", made.json["text"]}, {"revision", 0}}).json;
  for (const Json& d : put["diagnostics"]) EXPECT_EQ(d["severity"], "warning") << d;
  EXPECT_EQ(serving.post("/api/static", Json::object()).json["status"], "converged");
}

TEST(serve_model, the_start_dialogue_names_the_answer_that_is_wrong) {
  const Serving serving;
  const Reply wall = serving.post("/api/new", {{"pipe", "16"}, {"depth", "60 m"}, {"wall", "20 kN"}});
  EXPECT_EQ(wall.status, 422);
  EXPECT_EQ(wall.json["error"]["key"], "wall");
  EXPECT_EQ(serving.post("/api/new", {{"depth", "60 m"}}).json["error"]["key"], "pipe");
  EXPECT_EQ(serving.post("/api/new", {{"pipe", 16}, {"depth", "60 m"}, {"boxes", "x"}}).json["error"]["key"], "boxes");
}

TEST(serve_model, the_schema_is_that_of_the_command) {
  const Serving serving;
  EXPECT_EQ(serving.get("/api/schema").json["title"], "Overbend model file");
}

TEST(serve_new, quantities_stand_in_the_unit_they_were_typed_in) {
  const Serving serving;
  const Reply made =
      serving.post("/api/new", {{"pipe", "16"}, {"depth", "300 ft"}, {"concrete", "1.5 in"}, {"vessel", "BGL-1"}});
  const std::string text = made.json["text"];
  for (const char* part :
       {"water_depth: 300 ft\n", "thickness: 1.5 in,", "name: BGL-1\n", "outside_diameter: 406.4 mm\n"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << text;
  }
}

}  // namespace
}  // namespace overbend
