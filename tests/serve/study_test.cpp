// Several seeds and comparisons, started, followed and read through the interface of the page.
#include "app/program.h"
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::Reply;
using testing::Serving;
using testing::with;

const std::string kRange = with(kSmallLay, "tension: 300 kN}", "tension: 300 kN, range: [290 kN, 310 kN]}");

std::string start(const Serving& serving, const Json& what) {
  const Reply reply = serving.post("/api/runs", what);
  EXPECT_EQ(reply.status, 200) << reply.body;
  return reply.json.value("id", "");
}

Json make_study_cases(const Serving& serving, const std::string& id) {
  Json cases = Json::array();
  for (const Json& run : serving.get("/api/runs").json) {
    if (run["parent"] == id) cases.push_back(run);
  }
  return cases;
}

const Json& quantity(const Json& study, const std::string& name) {
  for (const Json& item : study["quantities"]) {
    if (item["name"] == name) return item;
  }
  throw std::runtime_error("no quantity " + name);
}

TEST(serve_study, several_seeds_run_and_give_the_table_of_the_command) {
  const Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "seeds"}, {"seeds", {3, 1}}, {"duration", 4.0}}),
                    run_path = "/api/runs/" + id;
  const Json run = serving.wait_for(id);
  ASSERT_EQ(run["state"], "done") << run;
  EXPECT_EQ(run["progress"], 1.0);

  const Json study = serving.get(run_path + "/study").json;
  ASSERT_EQ(study["cases"].size(), 2U) << study;
  EXPECT_EQ(study["cases"][0]["words"], "Seed 3");
  const Json& tension = quantity(study, "top_tension_max");
  EXPECT_EQ(tension["unit"], "kN");
  const double a = tension["values"][0], b = tension["values"][1];
  EXPECT_EQ(tension["max"], std::max(a, b));
  EXPECT_EQ(tension["min"], std::min(a, b));
  EXPECT_NEAR(tension["mean"].get<double>(), 0.5 * (a + b), 1e-9 * a);
  EXPECT_NEAR(tension["std"].get<double>(), std::abs(a - b) / std::sqrt(2.0), 1e-9 * a);
  EXPECT_TRUE(serving.get(run_path + "/summary").json.contains("seeds"));
  EXPECT_EQ(serving.get(run_path + "/report.html").status, 404);

  // The same seeds of the same model by the command.
  const std::string model = (serving.folder / "seeds.yaml").string();
  testing::write_file(model, with(kSmallLay, "duration: 10 s", "seeds: [3, 1], duration: 4 s"));
  ASSERT_EQ(testing::run_program("dynamic " + model + " -o " + (serving.folder / "out").string()).code, 0);
  EXPECT_EQ(serving.client().Get(run_path + "/table.csv?token=" + serving.server->token())->body,
            testing::file_text(serving.folder / "out/seeds.csv"));
}

TEST(serve_study, the_cases_of_a_study_are_runs_to_be_looked_at) {
  Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "seeds"}, {"seeds", {1, 2}}, {"duration", 3.0}});
  ASSERT_EQ(serving.wait_for(id)["state"], "done");
  for (int start = 0; start < 2; ++start) {
    const Json cases = make_study_cases(serving, id);
    ASSERT_EQ(cases.size(), 2U);
    EXPECT_EQ(cases[0]["id"], id + "~seed-1");
    EXPECT_EQ(cases[0]["title"], "Seed 1");
    EXPECT_EQ(cases[0]["kind"], "dynamic");
    EXPECT_EQ(cases[1]["state"], "done");
    const std::string text_place = "/api/runs/" + cases[1]["id"].get<std::string>();
    EXPECT_EQ(serving.get(text_place + "/summary").json["dynamic"]["seed"], 2);
    EXPECT_FALSE(serving.get(text_place + "/series?name=top_tension").json["t"].empty());
    EXPECT_GT(serving.get(text_place + "/frames").json["total"].get<int>(), 1);
    EXPECT_EQ(serving.get(text_place + "/scene").json["status"], "ok");
    EXPECT_EQ(serving.post(text_place + "/delete", Json::object()).status, 409);
    EXPECT_EQ(serving.get("/api/runs/" + id + "/envelopes").status, 404);
    EXPECT_TRUE(serving.get("/api/runs/" + id + "/columns").json.empty());
    serving.restart("");  // the next start of the program knows them too
  }
  EXPECT_EQ(serving.post("/api/runs/" + id + "/delete", Json::object()).status, 200);
  EXPECT_TRUE(serving.get("/api/runs").json.empty());
}

TEST(serve_study, variants_of_the_tensioner_are_compared) {
  const Serving serving(kRange);
  const std::string id = start(serving, {{"kind", "comparison"}, {"of", "tensioner"}, {"duration", 3.0}});
  const Json run = serving.wait_for(id);
  ASSERT_EQ(run["state"], "done") << run;
  EXPECT_EQ(make_study_cases(serving, id).size(), 3U);
  const Json study = serving.get("/api/runs/" + id + "/study").json;
  EXPECT_EQ(study["cases"][2]["name"], "constant");
  EXPECT_EQ(quantity(study, "largest_travel")["values"][0], 0.0);  // held by its brake
  EXPECT_NE(quantity(study, "largest_travel")["values"][2], 0.0);
  const httplib::Result page =
      serving.client().Get("/api/runs/" + id + "/report.html?token=" + serving.server->token());
  ASSERT_TRUE(page);
  EXPECT_NE(page->body.find("compared_tensioner"), std::string::npos);
}

TEST(serve_study, a_cancelled_study_goes_on_and_finished_cases_are_not_run_again) {
  Serving serving(kSmallLay);
  // Three times as many as run at once: when the first is done, a whole run is still before others.
  const std::size_t count = 3 * std::max<std::size_t>(1, std::thread::hardware_concurrency());
  Json seeds = Json::array();
  for (std::size_t seed = 1; seed <= count; ++seed) seeds.push_back(seed);
  const std::string id = start(serving, {{"kind", "seeds"}, {"seeds", seeds}, {"duration", 20.0}});
  const std::string first = id + "~seed-1";
  EXPECT_EQ(serving.wait_for(first)["state"], "done");
  EXPECT_EQ(serving.post("/api/runs/" + first + "/cancel", Json::object()).status, 409);  // the study goes as a whole
  serving.post("/api/runs/" + id + "/cancel", Json::object());
  const Json stopped = serving.wait_for(id);
  ASSERT_EQ(stopped["state"], "cancelled") << "the study came to its end before";
  EXPECT_EQ(stopped["resumable"], true);
  EXPECT_EQ(serving.get("/api/runs/" + id + "/study").status, 404);
  const auto written = std::filesystem::last_write_time(serving.folder / "runs" / id / "seed-1/results.h5");
  serving.restart("");
  EXPECT_EQ(serving.wait_for(id)["resumable"], true);
  EXPECT_EQ(serving.post("/api/runs/" + id + "/resume", Json::object()).status, 200);
  for (const Json& item : make_study_cases(serving, id))
    EXPECT_NE(item["state"], "cancelled") << item;  // they wait or are done
  const Json run = serving.wait_for(id);
  ASSERT_EQ(run["state"], "done") << run;
  EXPECT_EQ(serving.get("/api/runs/" + id + "/study").json["cases"].size(), count);
  EXPECT_EQ(std::filesystem::last_write_time(serving.folder / "runs" / id / "seed-1/results.h5"), written);
}

TEST(serve_study, what_cannot_be_run_is_rejected_with_the_reason) {
  const Serving serving(kSmallLay);
  EXPECT_EQ(serving.post("/api/runs", {{"kind", "seeds"}}).status, 422);  // the model has one seed
  EXPECT_EQ(serving.post("/api/runs", {{"kind", "seeds"}, {"seeds", {1, 1}}}).status, 422);
  EXPECT_EQ(serving.post("/api/runs", {{"kind", "seeds"}, {"seeds", {1, -2}}}).status, 422);
  EXPECT_EQ(serving.post("/api/runs", {{"kind", "comparison"}}).status, 400);
  const Reply rejected = serving.post("/api/runs", {{"kind", "comparison"}, {"of", "tensioner"}});
  EXPECT_EQ(rejected.status, 422);
  EXPECT_NE(rejected.body.find("tensioner.range is missing"), std::string::npos);
  EXPECT_TRUE(serving.get("/api/runs").json.empty());
}

TEST(serve_study, seeds_that_the_command_ran_are_listed_with_their_cases) {
  Serving serving(with(kSmallLay, "duration: 10 s", "seeds: [5, 6], duration: 2 s"));
  ASSERT_EQ(testing::run_program("dynamic " + (serving.folder / "model.yaml").string() + " -o " +
                                 (serving.folder / "runs/by-hand").string())
                .code,
            0);
  serving.restart("");
  EXPECT_EQ(serving.wait_for("by-hand")["kind"], "seeds");
  EXPECT_EQ(make_study_cases(serving, "by-hand").size(), 2U);
  EXPECT_EQ(serving.get("/api/runs/by-hand/study").json["cases"].size(), 2U);
}

}  // namespace
}  // namespace overbend
