// Statics while a value is dragged.
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::Reply;
using testing::Serving;
using testing::with;

// The tension asked for is held at the node; recovery within the coarse elements of the small lay gives 1e-4 of it
// more.
constexpr double kTension = 50.0;  // [N]

Json change(const std::string& path, const Json& value) {
  return {{"changes", {{{"path", path}, {"value", value}}}}};
}

TEST(serve_static, the_answer_is_a_line_from_tensioner_to_anchor) {
  const Serving serving(kSmallLay);
  const Json answer = serving.post("/api/static", Json::object()).json;
  ASSERT_EQ(answer["status"], "converged") << answer;
  EXPECT_NEAR(answer["key"]["top_tension"].get<double>(), 300e3, kTension);
  const Json& pipe = answer["pipe"];
  const std::size_t count = pipe["s"].size();
  ASSERT_GT(count, 20u);
  for (const char* name :
       {"x", "y", "z", "effective_tension", "bending_moment", "bending_stress", "von_mises", "strain", "utilisation"}) {
    EXPECT_EQ(pipe[name].size(), count) << name;
  }
  EXPECT_EQ(pipe["s"].front(), 0.0);
  EXPECT_GT(pipe["z"].front().get<double>(), 0.0);
  EXPECT_LT(pipe["z"].back().get<double>(), -19.0);  // on the seabed in 20 m of water
  ASSERT_EQ(answer["supports"].size(), 5u);
  EXPECT_EQ(answer["supports"][0]["structure"], "ramp");
  EXPECT_EQ(answer["supports"][4]["rollers"][0]["position"], "bottom");
  EXPECT_NEAR(answer["tensioner"]["place"][2].get<double>(), 5.6, 1e-6);
}

TEST(serve_static, changes_go_on_top_and_are_not_kept) {
  const Serving serving(kSmallLay);
  const Json higher = serving.post("/api/static", change("tensioner.tension", "350 kN")).json;
  EXPECT_NEAR(higher["key"]["top_tension"].get<double>(), 350e3, kTension);
  EXPECT_EQ(serving.get("/api/model").json["text"], kSmallLay);
  EXPECT_NEAR(serving.post("/api/static", Json::object()).json["key"]["top_tension"].get<double>(), 300e3, kTension);
}

TEST(serve_static, from_the_last_solution_and_from_nothing_are_the_same_state) {
  const Serving serving(kSmallLay);
  serving.post("/api/static", change("tensioner.tension", "330 kN"));
  const Json warm = serving.post("/api/static", Json::object()).json;
  const Json cold = serving.post("/api/static", {{"full", true}}).json;
  EXPECT_EQ(warm["warm"], true);
  EXPECT_EQ(cold["warm"], false);
  // The meshes may differ by where they are fine: a per mille.
  for (const char* name : {"top_tension", "bottom_tension", "lay_back", "departure_angle"}) {
    const double expected = cold["key"][name].get<double>();
    EXPECT_NEAR(warm["key"][name].get<double>(), expected, 2e-3 * std::abs(expected)) << name;
  }
}

TEST(serve_static, a_lay_in_a_current_is_that_of_a_run_once_a_value_rests) {
  const Serving serving(
      with(kSmallLay, "environment:", "environment:\n  current: [{depth: 0 m, speed: 0.3 m/s, towards: 180 deg}]"));
  serving.post("/api/static", change("tensioner.tension", "330 kN"));
  const Json rests = serving.post("/api/static", Json::object()).json;
  ASSERT_EQ(rests["status"], "converged") << rests;
  EXPECT_EQ(rests["warm"], false);
  const auto prescribed = [](const Json& answer) {
    int count = 0;
    for (const Json& finding : answer["findings"]) count += finding["code"] == "other-equilibrium-possible" ? 1 : 0;
    return count;
  };
  EXPECT_EQ(prescribed(rests), 0);
  const Json dragged = serving.post("/api/static", {{"lists", {"effective_tension"}}}).json;
  EXPECT_EQ(dragged["warm"], true);
  EXPECT_EQ(prescribed(dragged), 1);
}

TEST(serve_static, a_probe_gives_the_same_state_and_leaves_the_start_of_the_next_request) {
  const Serving serving(kSmallLay);
  const Json probe = {{"probe", true}, {"lists", Json::array()}};
  const Json far = serving.post("/api/static", probe).json;
  ASSERT_EQ(far["status"], "converged") << far;
  EXPECT_NEAR(far["key"]["top_tension"].get<double>(), 300e3, kTension);
  EXPECT_TRUE(far["verdict"]["kind"].is_string());
  EXPECT_EQ(serving.post("/api/static", Json::object()).json["warm"], false);  // nothing to start from yet
  EXPECT_EQ(serving.post("/api/static", probe).json["warm"], true);
}

TEST(serve_static, a_case_without_solution_says_what_where_and_why) {
  const Serving serving(kSmallLay);
  const Reply reply = serving.post("/api/static", change("tensioner.tension", "2 kN"));
  EXPECT_EQ(reply.status, 200);
  EXPECT_EQ(reply.json["status"], "failed") << reply.body;
  EXPECT_NE(reply.json["what"].get<std::string>().find("tension is too low"), std::string::npos);
  EXPECT_EQ(reply.json["where"], "at the tensioner");
  EXPECT_FALSE(reply.json["why"].get<std::string>().empty());
  EXPECT_EQ(serving.post("/api/static", Json::object()).json["status"], "converged");  // and goes on after it
}

TEST(serve_static, a_model_with_errors_is_invalid_with_its_diagnostics) {
  const Serving serving(kSmallLay);
  const Json answer = serving.post("/api/static", change("tensioner.tension", "2 m")).json;
  EXPECT_EQ(answer["status"], "invalid");
  EXPECT_EQ(answer["diagnostics"][0]["key"], "tensioner.tension");
  EXPECT_EQ(Serving().post("/api/static", Json::object()).json["status"], "invalid");
}

TEST(serve_static, the_scene_is_what_stands_still) {
  const Serving serving(kSmallLay);
  const Json scene = serving.get("/api/scene").json;
  ASSERT_EQ(scene["status"], "ok");
  EXPECT_EQ(scene["vessel"]["pose"].size(), 12u);
  EXPECT_EQ(scene["ramp"].size(), 3u);
  EXPECT_EQ(scene["stinger"].size(), 2u);
  EXPECT_EQ(scene["water_depth"], 20.0);
  EXPECT_EQ(scene["waves"].size(), 20u);
  EXPECT_EQ(scene["seabed"]["normal"][2], 1.0);
}

TEST(serve_static, no_answer_holds_nan) {
  const Serving serving(kSmallLay);
  for (const std::string& body : {serving.post("/api/static", Json::object()).body, serving.get("/api/scene").body}) {
    EXPECT_EQ(body.find("nan"), std::string::npos);
    EXPECT_EQ(body.find("inf"), std::string::npos);
  }
}

TEST(serve_static, the_utilisation_of_a_region_is_its_own_von_mises_stress_over_yield) {
  const Serving serving(kSmallLay);
  const Json answer = serving.post("/api/static", Json::object()).json;
  const Json& pipe = answer["pipe"];
  const double yield = pipe["von_mises"][5].get<double>() / pipe["utilisation"][5].get<double>();
  for (const char* name : {"overbend", "sagbend"}) {
    const Json& region = answer["key"][name];
    EXPECT_NEAR(region["utilisation"].get<double>(), region["von_mises"].get<double>() / yield, 1e-5) << name;
  }
}

TEST(serve_static, only_the_lists_asked_for_are_sent) {
  const Serving serving(kSmallLay);
  const Json pipe = serving.post("/api/static", {{"lists", {"effective_tension"}}}).json["pipe"];
  EXPECT_TRUE(pipe.contains("x") && pipe.contains("effective_tension"));
  EXPECT_FALSE(pipe.contains("bending_moment") || pipe.contains("strain"));
}

}  // namespace
}  // namespace overbend
