// Models without a pipe, and a lay on mooring lines: statics, scene and runs as the page gets them.
#include "modelfile/moored_texts.h"
#include "serve/serving.h"
#include "statics/moored/moored_lay.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::kLines;
using testing::kMoored;
using testing::kSmallLay;
using testing::Reply;
using testing::Serving;
using testing::with;

/// Ahead, astern and abeam of the barge of the small lay, which heads north and is held.
const std::string kMooredLay = with(kSmallLay, "tensioner:", R"(moorings:
  types: {wire: {wire_rope: {diameter: 50 mm, core: wire}}}
  lines:
    - {name: ahead, fairlead: {x: 57 m, y: 0 m, z: 3 m}, bearing: 0 deg, anchor_distance: 400 m, type: wire, tension: 200 kN}
    - {name: port, fairlead: {x: 0 m, y: 15 m, z: 3 m}, bearing: 270 deg, anchor_distance: 400 m, type: wire, tension: 200 kN}
    - {name: starboard, fairlead: {x: 0 m, y: -15 m, z: 3 m}, bearing: 90 deg, anchor_distance: 400 m, type: wire, tension: 200 kN}
tensioner:)");

Model read_moored_model(const std::string& text) {
  return build_model(read_model_text(text, "model.yaml").description.value());
}

TEST(serve_moored, a_hull_without_a_pipe_has_its_lines_and_no_pipe) {
  const Serving serving(kMoored);
  const Json answer = serving.post("/api/static", Json::object()).json;
  ASSERT_EQ(answer["status"], "converged") << answer;
  EXPECT_TRUE(answer["key"].is_null() && answer["touchdown"].is_null() && answer["tensioner"].is_null());
  EXPECT_TRUE(answer["pipe"]["s"].empty() && answer["supports"].empty() && answer["lines"].empty());

  Model model = read_moored_model(kMoored);
  const MooringResults expected = solve_moored_hull(model).moorings.value();
  const Json& rest = answer["moorings"]["rest"];
  EXPECT_NEAR(rest["vessel"]["surge"].get<double>(), expected.rest.vessel.surge, 1e-6);
  ASSERT_EQ(rest["moorings"].size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const MooringLineResult& line = expected.rest.moorings[i];
    const Json& prescribed = rest["moorings"][i];
    EXPECT_EQ(prescribed["name"], line.name);
    EXPECT_NEAR(prescribed["fairlead_tension"].get<double>(), line.fairlead_tension, 1e-6 * line.fairlead_tension);
    EXPECT_EQ(prescribed["shape"].size(), line.shape_W.size());
    EXPECT_NEAR(prescribed["shape"].back()[0].get<double>(), line.anchor_W.x(), 1e-3);
  }
  ASSERT_EQ(answer["moorings"]["stages"].size(), 2u);
  EXPECT_EQ(answer["moorings"]["stages"][1]["name"], "one parted");
  EXPECT_EQ(answer["moorings"]["stages"][1]["moorings"][2]["parted"], true);
}

TEST(serve_moored, the_stages_of_an_operation_wait_while_a_value_is_dragged) {
  const Serving serving(kMoored);
  const Json dragged = serving.post("/api/static", {{"lists", Json::array()}}).json;
  ASSERT_EQ(dragged["status"], "converged") << dragged;
  EXPECT_TRUE(dragged["moorings"]["stages"].empty());
  EXPECT_EQ(dragged["moorings"]["rest"]["moorings"].size(), 3u);
}

TEST(serve_moored, lines_by_themselves_are_answered_with_their_nodes) {
  const Serving serving(kLines);
  const Json answer = serving.post("/api/static", Json::object()).json;
  ASSERT_EQ(answer["status"], "converged") << answer;
  EXPECT_TRUE(answer["key"].is_null() && answer["moorings"].is_null());
  const std::vector<LineResult> expected = solve_lines(read_moored_model(kLines)).lines;
  ASSERT_EQ(answer["lines"].size(), 2u);
  const Json& jumper = answer["lines"][0];
  EXPECT_EQ(jumper["name"], "jumper");
  EXPECT_EQ(jumper["shape"].size(), expected[0].nodes.size());
  EXPECT_EQ(jumper["tension"].size(), jumper["s"].size());
  EXPECT_EQ(jumper["shape"].front(), Json({-100.0, 0.0, -55.0}));
  EXPECT_NEAR(jumper["second"]["tension"].get<double>(), expected[0].second.tension, 1.0);
}

TEST(serve_moored, a_lay_on_mooring_lines_has_both) {
  const Serving serving(kMooredLay);
  const Json answer = serving.post("/api/static", Json::object()).json;
  ASSERT_EQ(answer["status"], "converged") << answer;
  EXPECT_NEAR(answer["key"]["top_tension"].get<double>(), 300e3, 50.0);
  ASSERT_EQ(answer["moorings"]["rest"]["moorings"].size(), 3u);
  EXPECT_NEAR(answer["moorings"]["rest"]["moorings"][0]["fairlead_tension"].get<double>(), 200e3, 1.0);
  EXPECT_TRUE(serving.post("/api/static", Json::object()).json["moorings"].is_object());  // from the last solution too
}

TEST(serve_moored, a_scene_has_only_what_the_model_speaks_of) {
  const Json hull = Serving(kMoored).get("/api/scene").json;
  EXPECT_EQ(hull["vessel"]["pose"].size(), 12u);
  EXPECT_TRUE(hull["tensioner"].is_null() && hull["stern_shoe"].is_null());
  EXPECT_EQ(hull["objects"][0]["name"], "pipeline");
  EXPECT_EQ(hull["objects"][0]["points"][1], Json({300.0, 500.0, -88.5}));
  const Json lines = Serving(kLines).get("/api/scene").json;
  EXPECT_TRUE(lines["vessel"].is_null());
  EXPECT_EQ(lines["water_depth"], 100.0);
}

TEST(serve_moored, static_runs_of_models_without_a_pipe_leave_their_files) {
  for (const auto& [text, table] : {std::pair{kMoored, "moorings.csv"}, {kLines, "lines.csv"}}) {
    const Serving serving(text);
    const std::string id = serving.post("/api/runs", {{"kind", "static"}}).json.value("id", "");
    ASSERT_EQ(serving.wait_for(id)["state"], "done");
    EXPECT_EQ(serving.get("/api/runs/" + id + "/summary").json["status"], "converged");
    const Reply csv = serving.get("/api/runs/" + id + "/table.csv");
    EXPECT_EQ(csv.status, 200) << table;
    EXPECT_EQ(csv.body, testing::file_text((serving.folder / "runs" / id / table).string()));
  }
}

TEST(serve_moored, a_run_of_a_moored_hull_is_looked_at_as_it_was_computed) {
  const Serving serving(kMoored);
  const std::string id = serving.post("/api/runs", {{"kind", "static"}}).json.value("id", "");
  ASSERT_EQ(serving.wait_for(id)["state"], "done");
  EXPECT_EQ(serving.get("/api/runs/" + id + "/statics").json["moorings"],
            serving.post("/api/static", Json::object()).json["moorings"]);
  EXPECT_EQ(serving.get("/api/runs/" + id + "/scene").json, serving.get("/api/scene").json);
}

TEST(serve_moored, a_moored_hull_moves_in_time_and_its_lines_are_shown) {
  const Serving serving(kMoored + "analysis:\n  dynamic: {duration: 4 s, build_up: 2 s, max_step: 0.1 s}\n");
  const std::string id = serving.post("/api/runs", {{"kind", "dynamic"}}).json.value("id", "");
  const Json ended = serving.wait_for(id);
  ASSERT_EQ(ended["state"], "done") << ended;
  EXPECT_TRUE(serving.get("/api/runs/" + id + "/envelopes").json["s"].empty());
  EXPECT_EQ(serving.get("/api/runs/" + id + "/statics").json["moorings"]["rest"]["moorings"].size(), 3u);
  EXPECT_EQ(serving.get("/api/runs/" + id + "/scene").json["vessel"]["pose"].size(), 12u);
  const Json frames = serving.get("/api/runs/" + id + "/frames?from=0&count=3").json;
  EXPECT_EQ(frames["stations"], 0);
  EXPECT_EQ(frames["time"].size(), 3u);
  EXPECT_EQ(frames["lines"].size(), 3u);
  const Json columns = serving.get("/api/runs/" + id + "/columns").json;
  EXPECT_TRUE(std::any_of(columns.begin(), columns.end(), [](const Json& column) {
    return column["name"] == "mooring/stern/fairlead_tension";
  })) << columns;
  EXPECT_EQ(serving.get("/api/runs/" + id + "/impacts").json["total"], 0);
  EXPECT_EQ(serving.get("/api/runs/" + id + "/report.html").status, 200);
}

TEST(serve_moored, a_run_of_lines_is_looked_at_as_it_was_computed) {
  const Serving serving(kLines);
  const std::string id = serving.post("/api/runs", {{"kind", "static"}}).json.value("id", "");
  ASSERT_EQ(serving.wait_for(id)["state"], "done");
  Json current = serving.post("/api/static", Json::object()).json;
  EXPECT_EQ(serving.get("/api/runs/" + id + "/statics").json["lines"], current["lines"]);
  EXPECT_EQ(serving.get("/api/runs/" + id + "/scene").json, serving.get("/api/scene").json);
  EXPECT_TRUE(serving.get("/api/runs/" + id + "/envelopes").json["s"].empty());
}

}  // namespace
}  // namespace overbend
