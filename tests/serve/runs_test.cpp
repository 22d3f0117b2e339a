// Runs: queued, followed, stopped, read.
#include <cmath>

#include "resultfiles/dynamic/dynamic_reader.h"
#include "serve/http/base64.h"
#include "serve/runs/run_data.h"
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::Reply;
using testing::Serving;
using testing::with;

std::string start(const Serving& serving, const Json& what) {
  const Reply reply = serving.post("/api/runs", what);
  EXPECT_EQ(reply.status, 200) << reply.body;
  return reply.json.value("id", "");
}

TEST(serve_runs, a_static_run_leaves_the_files_of_the_command) {
  const Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "static"}});
  EXPECT_EQ(serving.wait_for(id)["state"], "done");
  for (const char* name : {"summary.json", "pipe.csv", "supports.csv", "results.h5", "report.html"}) {
    EXPECT_TRUE(std::filesystem::exists(serving.folder / "runs" / id / name)) << name;
  }
  EXPECT_EQ(serving.get("/api/runs/" + id + "/summary").json["status"], "converged");
  EXPECT_TRUE(serving.get("/api/runs/" + id + "/columns").json.empty());
  const Json envelopes = serving.get("/api/runs/" + id + "/envelopes").json;
  EXPECT_EQ(envelopes["effective_tension"]["static"].size(), envelopes["s"].size());
  EXPECT_EQ(envelopes["z"].size(), envelopes["s"].size());
}

TEST(serve_runs, a_static_run_has_the_limits_of_roller_friction_like_the_command) {
  const Serving serving(with(kSmallLay, "plain: {", "plain: {friction: {axial: 0.1, lateral: 0.2}, "));
  const std::string id = start(serving, {{"kind", "static"}});
  EXPECT_EQ(serving.wait_for(id)["state"], "done");
  EXPECT_FALSE(serving.get("/api/runs/" + id + "/summary").json["static"]["roller_friction"].empty());
}

TEST(serve_runs, the_spectrum_of_a_sine_has_its_variance_and_its_frequency) {
  // 40 periods of 8 s and amplitude 3, every half second, after a build-up that does not count.
  constexpr double kPeriod = 8.0, kAmplitude = 3.0, kStep = 0.5;
  std::vector<double> time, values;
  for (int i = -100; i < 40 * 16; ++i) {
    time.push_back(i * kStep);
    values.push_back(i < 0 ? 1e6 : 7.0 + kAmplitude * std::sin(2.0 * 3.14159265358979 * i * kStep / kPeriod));
  }
  const Json spectrum = spectrum_json(time, values);
  const std::vector<double> frequency = spectrum["frequency"], density = spectrum["density"];
  ASSERT_EQ(frequency.size(), density.size());
  double integral = 0.0;
  std::size_t peak = 0;
  for (std::size_t i = 0; i < density.size(); ++i) {
    integral += density[i] * frequency[1];
    if (density[i] > density[peak]) peak = i;
  }
  EXPECT_NEAR(integral, 0.5 * kAmplitude * kAmplitude, 0.01);
  EXPECT_NEAR(frequency[peak], 1.0 / kPeriod, frequency[1]);
  EXPECT_NEAR(spectrum["std"].get<double>(), kAmplitude / std::sqrt(2.0), 1e-6);
  EXPECT_TRUE(spectrum_json({}, {})["frequency"].empty());
}

TEST(serve_runs, a_run_says_in_which_keys_the_open_model_differs_from_its_own) {
  const Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "static"}});
  serving.wait_for(id);
  const std::string path = "/api/runs/" + id + "/changes";
  EXPECT_EQ(serving.get(path).json["changed"], "");
  const Json model = serving.get("/api/model").json;
  serving.put("/api/model", {{"text", with(kSmallLay, "hs: 1 m", "hs: 1.5 m")}, {"revision", model["revision"]}});
  EXPECT_EQ(serving.get(path).json["changed"], "environment.waves.hs 1.5 m");
  EXPECT_EQ(serving.get("/api/runs/none/changes").status, 404);

  const Json changed = serving.get("/api/model").json;
  serving.put("/api/model", {{"text", with(with(kSmallLay, "title: small lay", "title: other"), "build_up: 5 s,",
                                           "build_up: 5 s, seeds: 3,")},
                             {"revision", changed["revision"]}});
  EXPECT_EQ(serving.get(path).json["changed"], "");  // neither name nor seeds change what the run has computed
}

TEST(serve_runs, a_run_in_time_comes_to_its_end_and_can_be_read) {
  const Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "dynamic"}, {"duration", 6.0}});
  const Json run = serving.wait_for(id);
  ASSERT_EQ(run["state"], "done") << run;
  EXPECT_EQ(run["title"], "small lay");
  EXPECT_EQ(run["progress"], 1.0);
  const std::string text_place = "/api/runs/" + id;

  const Json columns = serving.get(text_place + "/columns").json;
  EXPECT_GT(columns.size(), 20u);
  const Json series = serving.get(text_place + "/series?name=top_tension&px=5").json;
  ASSERT_EQ(series["t"].size(), 5u);
  const Json all = serving.get(text_place + "/series?name=top_tension&name=support/ramp%201/reaction&t0=0&t1=2").json;
  EXPECT_EQ(all["series"]["top_tension"]["t"].size(), 5u);  // every half second from 0 to 2
  EXPECT_TRUE(all["series"].contains("support/ramp 1/reaction"));
  EXPECT_EQ(serving.get(text_place + "/series?name=nothing").status, 404);
  EXPECT_EQ(serving.get(text_place + "/spectrum?name=nothing").status, 404);
  EXPECT_GT(serving.get(text_place + "/spectrum?name=top_tension").json["frequency"].size(), 100u);

  const Json envelopes = serving.get(text_place + "/envelopes").json;
  EXPECT_EQ(envelopes["von_mises"]["max"].size(), envelopes["s"].size());
  EXPECT_EQ(envelopes["x"].size(), envelopes["s"].size());
  EXPECT_EQ(envelopes["s"].front(), 0.0);

  const Json frames = serving.get(text_place + "/frames?from=1&count=2").json;
  EXPECT_EQ(frames["time"].size(), 2u);
  EXPECT_EQ(frames["pose"][0].size(), 12u);
  EXPECT_GT(frames["total"].get<int>(), 2);
  // Four letters for three bytes, four bytes a number, three numbers a place.
  const std::size_t bytes = 2 * 3 * 4 * frames["stations"].get<std::size_t>();
  EXPECT_EQ(frames["place"].get<std::string>().size(), (bytes + 2) / 3 * 4);

  EXPECT_TRUE(serving.get(text_place + "/impacts").json["impacts"].is_array());
  EXPECT_TRUE(serving.get(text_place + "/summary").json.contains("dynamic"));
  const httplib::Result report = serving.client().Get(text_place + "/report.html?token=" + serving.server->token());
  ASSERT_TRUE(report);
  EXPECT_NE(report->body.find("small lay"), std::string::npos);
  EXPECT_NE(report->get_header_value("Content-Disposition").find("attachment"), std::string::npos);
  const httplib::Result shown =
      serving.client().Get(text_place + "/report.html?show=1&token=" + serving.server->token());
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->body, report->body);
  EXPECT_FALSE(shown->has_header("Content-Disposition"));
  EXPECT_FALSE(std::filesystem::exists(serving.folder / "runs" / id / ".run"));
}

TEST(serve_runs, a_run_can_be_looked_at_while_it_runs_and_be_cancelled) {
  const Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "dynamic"}, {"duration", 3600.0}});
  const Json running = serving.wait_until(id, [](const Json& run) { return run.contains("top_tension"); });
  EXPECT_EQ(running["state"], "running");
  EXPECT_GT(running["worst_stress"].get<double>(), 1e6);
  EXPECT_GT(running["top_tension"].get<double>(), 1e5);
  EXPECT_FALSE(serving.get("/api/runs/" + id + "/series?name=top_tension").json["t"].empty());
  EXPECT_EQ(serving.get("/api/runs/" + id + "/summary").status, 404);

  const std::string next = start(serving, {{"kind", "static"}});
  EXPECT_EQ(serving.post("/api/runs/" + id + "/cancel", Json::object()).status, 200);
  EXPECT_EQ(serving.wait_for(id)["state"], "cancelled");
  EXPECT_EQ(serving.wait_for(next)["state"], "done");  // the queue goes on
}

TEST(serve_runs, a_cancelled_run_keeps_what_was_computed_and_can_go_on) {
  Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "dynamic"}, {"duration", 3600.0}}), run_path = "/api/runs/" + id;
  serving.wait_until(id, [](const Json& run) { return run.value("time", -1.0) > 2.0; });
  serving.post(run_path + "/cancel", Json::object());
  for (int start = 0; start < 2; ++start) {
    const Json run = serving.wait_for(id);
    EXPECT_EQ(run["state"], "cancelled");
    EXPECT_EQ(run["has_results"], true);
    const double reached = serving.get(run_path + "/summary").json["dynamic"]["duration"];
    EXPECT_GT(reached, 2.0);
    EXPECT_LT(reached, 3600.0);
    EXPECT_EQ(serving.get(run_path + "/series?name=top_tension").json["t"].back(), reached);
    EXPECT_FALSE(serving.get(run_path + "/envelopes").json["effective_tension"]["max"].empty());
    EXPECT_GT(serving.get(run_path + "/frames").json["total"].get<int>(), 2);
    EXPECT_TRUE(std::filesystem::exists(serving.folder / "runs" / id / ".run"));  // to be taken up again
    serving.restart("model.yaml");  // the next start of the program knows it too
  }
}

TEST(serve_runs, a_run_cancelled_during_the_build_up_has_nothing_to_show) {
  const Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "static"}});
  const std::string run = start(serving, {{"kind", "dynamic"}, {"duration", 3600.0}});
  serving.wait_for(id);
  serving.wait_until(run, [](const Json& sample) { return sample["state"] != "queued"; });
  serving.post("/api/runs/" + run + "/cancel", Json::object());
  const Json ended = serving.wait_for(run);
  const Reply late =
      serving.get("/api/runs/" + run + "/series?name=top_tension");  // asked before the page was notified
  EXPECT_EQ(late.status, 200);
  EXPECT_EQ(late.json["t"].empty(), !ended["has_results"].get<bool>());
}

TEST(serve_runs, a_run_has_a_name_and_a_note_and_is_removed) {
  Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "static"}}), run_path = "/api/runs/" + id;
  serving.wait_for(id);
  EXPECT_EQ(serving.post(run_path + "/annotate", {{"name", "first"}, {"note", "for the client"}}).json["name"],
            "first");
  EXPECT_EQ(serving.post(run_path + "/annotate", {{"name", "second"}}).json["note"], "for the client");
  serving.restart("");
  EXPECT_EQ(serving.wait_for(id)["name"], "second");
  EXPECT_EQ(serving.post(run_path + "/delete", Json::object()).status, 200);
  EXPECT_TRUE(serving.get("/api/runs").json.empty());
  EXPECT_FALSE(std::filesystem::exists(serving.folder / "runs" / id));
  EXPECT_EQ(serving.post(run_path + "/delete", Json::object()).status, 404);
}

TEST(serve_runs, a_run_says_what_was_changed_since_the_one_before_of_the_same_title) {
  Serving serving(kSmallLay);
  const Json first = serving.wait_for(start(serving, {{"kind", "static"}}));
  EXPECT_EQ(first["changed"], "");
  const Json changes = {{{"path", "tensioner.tension"}, {"value", "255 kN"}},
                        {{"path", "vessel.trim"}, {"value", "0.1 deg"}}};
  const int revision = serving.get("/api/model").json["revision"].get<int>();
  ASSERT_EQ(serving.post("/api/model/set", {{"changes", changes}, {"revision", revision}}).status, 200);
  const std::string id = start(serving, {{"kind", "static"}});
  const std::string said = serving.wait_for(id)["changed"].get<std::string>();
  EXPECT_NE(said.find("tensioner.tension 255 kN"), std::string::npos) << said;
  EXPECT_NE(said.find("vessel.trim 0.1 deg"), std::string::npos) << said;
  serving.restart("model.yaml");  // it is kept with the run
  EXPECT_EQ(serving.wait_for(id)["changed"], said);
}

TEST(serve_runs, a_run_shows_its_verdict_and_the_model_with_which_it_was_started) {
  const Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "static"}});
  const Json run = serving.wait_for(id);
  const Json summary = serving.get("/api/runs/" + id + "/summary").json;
  EXPECT_EQ(run["verdict"]["kind"], summary["verdict"]["kind"]);
  EXPECT_NEAR(run["utilisation"].get<double>(), summary["checks"]["worst"]["utilisation"].get<double>(), 1e-6);
  const Json before = serving.get("/api/model").json;
  const Json changes = Json::array({{{"path", "tensioner.tension"}, {"value", "1 kN"}}});
  serving.post("/api/model/set", {{"changes", changes}, {"revision", before["revision"]}});
  const Json model = serving.get("/api/runs/" + id + "/model").json;
  EXPECT_EQ(model["text"], before["text"]);
  EXPECT_EQ(model["fields"], before["fields"]);
}

TEST(serve_runs, a_run_that_goes_on_is_not_removed) {
  const Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "dynamic"}, {"duration", 3600.0}});
  EXPECT_EQ(serving.post("/api/runs/" + id + "/delete", Json::object()).status, 409);
  serving.post("/api/runs/" + id + "/cancel", Json::object());
  serving.wait_for(id);
}

TEST(serve_runs, the_statics_of_a_run_are_those_of_its_own_model) {
  const Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "static"}}), run_path = "/api/runs/" + id;
  serving.wait_for(id);
  serving.post("/api/model/set", {{"changes", {{{"path", "tensioner.tension"}, {"value", "350 kN"}}}},
                                  {"revision", serving.get("/api/model").json["revision"]}});
  const Json then = serving.get(run_path + "/statics").json;
  EXPECT_EQ(then["status"], "converged");
  EXPECT_NEAR(then["key"]["top_tension"].get<double>(), 300e3, 100.0);  // to the coarse mesh; 350 kN would be now
  EXPECT_EQ(then["pipe"]["s"].size(), then["pipe"]["von_mises"].size());
  EXPECT_EQ(serving.get(run_path + "/scene").json["status"], "ok");
}

/// Elevation of the sea that the page draws.
double drawn(const Json& waves, double x, double y, double t) {
  double sum = 0.0;
  for (const Json& w : waves) {
    const double direction = w["direction"], along = x * std::cos(direction) + y * std::sin(direction);
    sum += w["amplitude"].get<double>() *
           std::cos(w["number"].get<double>() * along - w["frequency"].get<double>() * t + w["phase"].get<double>());
  }
  return sum;
}

TEST(serve_runs, the_sea_that_is_drawn_is_that_of_the_run) {
  const Serving serving(kSmallLay);  // a random sea of seed 3
  const std::string id = start(serving, {{"kind", "dynamic"}, {"duration", 10.0}}), run_path = "/api/runs/" + id;
  ASSERT_EQ(serving.wait_for(id)["state"], "done");
  const Json live = serving.get("/api/scene").json, run_scene = serving.get(run_path + "/scene").json;
  EXPECT_EQ(run_scene["waves"], live["waves"]);  // of the model while it is the same
  const Json history = serving.get(run_path + "/series?name=elevation&t0=0").json;
  const Json shoe = run_scene["stern_shoe"];
  ASSERT_GT(history["t"].size(), 10u);
  for (std::size_t i = 0; i < history["t"].size(); ++i) {
    EXPECT_NEAR(history["min"][i], drawn(run_scene["waves"], shoe[0], shoe[1], history["t"][i]), 1e-4);
  }
}

TEST(serve_runs, a_run_that_waits_can_be_cancelled) {
  const Serving serving(kSmallLay);
  const std::string first = start(serving, {{"kind", "dynamic"}, {"duration", 3600.0}});
  const std::string second = start(serving, {{"kind", "static"}});
  EXPECT_EQ(serving.post("/api/runs/" + second + "/cancel", Json::object()).json["state"], "cancelled");
  serving.post("/api/runs/" + first + "/cancel", Json::object());
  EXPECT_EQ(serving.wait_for(first)["state"], "cancelled");
  EXPECT_EQ(serving.wait_for(second)["state"], "cancelled");
}

TEST(serve_runs, a_run_without_solution_fails_with_the_reason) {
  const Serving serving(with(kSmallLay, "tension: 300 kN", "tension: 2 kN"));
  const Json run = serving.wait_for(start(serving, {{"kind", "dynamic"}}));
  EXPECT_EQ(run["state"], "failed");
  EXPECT_NE(run["message"].get<std::string>().find("tension is too low"), std::string::npos) << run;
}

TEST(serve_runs, a_model_with_errors_is_not_run) {
  const Serving serving(with(kSmallLay, "tension: 300 kN", "tension: 300 m"));
  const Reply reply = serving.post("/api/runs", {{"kind", "static"}});
  EXPECT_EQ(reply.status, 422);
  EXPECT_EQ(reply.json["diagnostics"][0]["key"], "tensioner.tension");
  EXPECT_TRUE(serving.get("/api/runs").json.empty());
  EXPECT_EQ(serving.post("/api/runs", {{"kind", "quick"}}).status, 400);
}

TEST(serve_runs, earlier_runs_of_the_folder_are_listed) {
  Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "static"}});
  serving.wait_for(id);
  const std::string cut_off = start(serving, {{"kind", "dynamic"}, {"duration", 3600.0}});
  serving.wait_until(cut_off, [](const Json& run) { return run["state"] == "running"; });
  serving.restart("");
  EXPECT_EQ(serving.wait_for(id)["state"], "done");
  EXPECT_EQ(serving.wait_for(cut_off)["state"], "cancelled");
  EXPECT_EQ(serving.get("/api/runs/" + id + "/summary").status, 200);
  EXPECT_EQ(serving.get("/api/runs/none/summary").status, 404);
}

// The program ends while a run in time is at work; the next start goes on with it, although the open model changed.
TEST(serve_runs, an_interrupted_run_is_resumed_with_the_text_it_was_begun_with) {
  Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "dynamic"}, {"duration", 300.0}});
  serving.wait_until(id, [](const Json& run) { return run.contains("top_tension"); });
  serving.restart("");
  const Json cut_off = serving.wait_for(id);
  ASSERT_EQ(cut_off["state"], "cancelled") << "the run came to its end before the program";
  EXPECT_EQ(cut_off["resumable"], true);
  EXPECT_EQ(testing::file_text(serving.folder / "runs" / id / "model.yaml"), kSmallLay);
  testing::write_file(serving.folder / "model.yaml", with(kSmallLay, "tension: 300 kN", "tension: 310 kN"));
  EXPECT_EQ(serving.post("/api/runs/" + id + "/resume", Json::object()).status, 200);
  const Json run = serving.wait_for(id);
  EXPECT_EQ(run["state"], "done") << run;
  EXPECT_EQ(run["resumable"], false);
  const Json summary = serving.get("/api/runs/" + id + "/summary").json;
  EXPECT_EQ(summary["dynamic"]["duration"], 300.0);
  EXPECT_NEAR(summary["static"]["top_tension"].get<double>(), 300e3, 1e3);  // not 310
  EXPECT_TRUE(std::filesystem::exists(serving.folder / "runs" / id / "model.yaml"));
  EXPECT_EQ(serving.post("/api/runs/" + id + "/resume", Json::object()).status, 409);
  EXPECT_EQ(serving.post("/api/runs/none/resume", Json::object()).status, 404);
}

TEST(serve_runs, a_run_that_was_cancelled_goes_on_where_it_stopped) {
  const Serving serving(kSmallLay);
  const std::string id = start(serving, {{"kind", "dynamic"}, {"duration", 600.0}});
  serving.wait_until(id, [](const Json& run) { return run.value("time", -1.0) > 1.0; });
  serving.post("/api/runs/" + id + "/cancel", Json::object());
  const Json stopped = serving.wait_for(id);
  ASSERT_EQ(stopped["state"], "cancelled") << "the run came to its end before";
  EXPECT_EQ(stopped["resumable"], true);
  EXPECT_EQ(stopped["has_results"], true);
  EXPECT_EQ(serving.post("/api/runs/" + id + "/resume", Json::object()).status, 200);  // it may be at work already
  EXPECT_EQ(serving.wait_for(id)["state"], "done");
  EXPECT_EQ(serving.get("/api/runs/" + id + "/summary").json["dynamic"]["duration"], 600.0);
}

TEST(serve_runs, events_report_progress_and_changes_of_the_model) {
  const Serving serving(kSmallLay);
  std::string heard;
  std::thread listener([&] {
    httplib::Client client = serving.client();
    client.Get("/api/events?token=" + serving.server->token(), [&](const char* data, std::size_t size) {
      heard.append(data, size);
      return heard.find("\"done\"") == std::string::npos;
    });
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  serving.put("/api/model", {{"text", kSmallLay + "# more\n"}, {"revision", 1}});
  const std::string id = start(serving, {{"kind", "dynamic"}, {"duration", 6.0}});
  listener.join();
  EXPECT_NE(heard.find("event: model\ndata: {\"revision\":2}"), std::string::npos) << heard;
  EXPECT_NE(heard.find("event: run\ndata: {\"id\":\"" + id), std::string::npos) << heard;
}

TEST(serve_runs, a_window_of_a_series_keeps_every_peak) {
  const std::vector<double> time = {0, 1, 2, 3, 4, 5, 6, 7}, values = {0, 9, 1, 1, -7, 1, 1, 5};
  const Json series = series_json(time, values, {1.0, 6.0, 2});
  EXPECT_EQ(json_text(series), R"({"t":[1.0,4.0],"min":[1.0,-7.0],"max":[9.0,1.0]})");
  EXPECT_TRUE(series_json(time, values, {10.0, 20.0, 5})["t"].empty());
}

TEST(serve_runs, numbers_travel_as_little_endian_base64) {
  EXPECT_EQ(base64_floats(std::vector<float>{}), "");
  EXPECT_EQ(base64_floats(std::vector<float>{1.0F}), "AACAPw==");
  EXPECT_EQ(base64_floats(std::vector<float>{1.0F, -2.5F}), "AACAPwAAIMA=");
}

}  // namespace
}  // namespace overbend
