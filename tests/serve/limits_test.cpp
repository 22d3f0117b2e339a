// Requests of a page keep the server busy for seconds at most, and no other user waiting.
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

#include "base/interruption.h"
#include "serve/http/http.h"
#include "serve/model/model_fields.h"
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::Reply;
using testing::Serving;
using testing::with;

std::string repeated(int count, const std::function<std::string(int)>& line) {
  std::string text;
  for (int i = 0; i < count; ++i) text += line(i);
  return text;
}

/// So many boxes more on the stinger.
std::string with_boxes(int count) {
  const auto box = [](int i) { return ", {x: " + std::to_string(20 + i) + " m, z: -12 m}"; };
  return with(kSmallLay, "{x: 15 m, z: -7.18 m}]", "{x: 15 m, z: -7.18 m}" + repeated(count, box) + "]");
}

Json put(const Serving& serving, const std::string& text) {
  return serving.put("/api/model", {{"text", text}, {"revision", serving.get("/api/model").json["revision"]}}).json;
}

TEST(serve_limits, too_many_items_of_a_list_are_one_error) {
  const Serving serving(kSmallLay);
  const Json answer = put(serving, with_boxes(20000));
  ASSERT_EQ(answer["diagnostics"].size(), 1U) << answer["diagnostics"];
  EXPECT_EQ(answer["diagnostics"][0]["key"], "supports.stinger.boxes");
  EXPECT_NE(answer["diagnostics"][0]["message"].get<std::string>().find("at most 1000"), std::string::npos);
  EXPECT_LT(json_text(answer["fields"]).size(), 2000000U);
}

TEST(serve_limits, fields_are_those_of_the_first_items_of_a_long_list) {
  const Serving serving(kSmallLay);
  int items = 0;
  std::size_t count = 0;
  const Json answer = put(serving, with_boxes(500));
  for (const Json& field : answer["fields"]) {
    const std::string path = field["path"];
    if (path.starts_with("supports.stinger.boxes[") && path.ends_with("].x")) ++items;
    if (path == "supports.stinger.boxes") count = field["count"];
  }
  EXPECT_EQ(items, 200);
  EXPECT_GT(count, 500U);
}

TEST(serve_limits, of_many_errors_the_first_are_reported_and_the_number_of_the_others) {
  const Serving serving(kSmallLay);
  const auto line = [](int i) { return "unknown" + std::to_string(i) + ": 3\n"; };
  const Json diagnostics = put(serving, kSmallLay + repeated(5000, line))["diagnostics"];
  ASSERT_EQ(diagnostics.size(), 201U);
  EXPECT_EQ(diagnostics.back()["message"], "and 4800 more");
}

TEST(serve_limits, paths_deeper_than_any_key_are_rejected) {
  const Serving serving(kSmallLay);
  const std::string deep = repeated(30000, [](int) { return std::string("a."); }) + "b";
  const std::string stars = "supports.stinger.boxes[" + std::string(300, '*') + "x].z";
  for (const std::string& path : {deep, stars}) {
    const Reply reply = serving.post("/api/static", {{"changes", {{{"path", path}, {"value", "1"}}}}});
    EXPECT_EQ(reply.status, 422) << reply.body;
    EXPECT_LT(reply.body.size(), 5000U);
  }
}

TEST(serve_limits, changes_are_a_thousand_at_most) {
  const Serving serving(kSmallLay);
  Json changes = Json::array();
  for (int i = 0; i < 20000; ++i) changes.push_back({{"path", "title"}, {"value", "a"}});
  EXPECT_EQ(serving.post("/api/static", {{"changes", changes}}).status, 422);
}

HttpRoute endless(std::chrono::seconds limit) {
  return {"GET", "/api/endless",
          [](const HttpRequest&) -> HttpAnswer {
            for (;;) check_interruption();
          },
          limit};
}

TEST(serve_limits, an_answer_that_takes_more_than_its_time_is_503) {
  const HttpAnswer answer = answer_by_routes({endless(std::chrono::seconds(0))}, {"GET", "/api/endless", {}, "", {}});
  EXPECT_EQ(answer.status, 503);
  EXPECT_NE(answer.body.find("more than 0 s"), std::string::npos);
}

TEST(serve_limits, the_server_closes_though_answers_are_on_their_way) {
  EventHub events;
  auto server = std::make_unique<HttpServer>(std::vector{endless(std::chrono::hours(1))}, events, 0);
  httplib::Client client("127.0.0.1", server->port());
  std::thread asking([&] { client.Get("/api/endless", {{"X-Overbend-Token", server->token()}}); });
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  server.reset();  // the test ends
  asking.join();
}

TEST(serve_limits, bodies_nested_deeply_are_rejected_also_behind_brackets_in_texts) {
  const HttpRequest shallow{"POST", "/", {}, R"({"a": "[[[[[\"[{", "b": [1, {"c": 2}]})", {}};
  EXPECT_EQ(shallow.json()["b"][1]["c"], 2);
  const HttpRequest deep{"POST", "/", {}, "{\"a\": " + std::string(100, '[') + std::string(100, ']') + "}", {}};
  EXPECT_THROW(deep.json(), HttpError);
}

TEST(serve_limits, a_long_solution_keeps_no_other_tab_waiting) {
  // Thousands of elements take a second or more, some dozens a few milliseconds.
  const std::string coarse = "overbend_element: 2.5 m, touchdown_element: 4 m, longest_element: 8 m";
  const Serving serving(
      with(kSmallLay, coarse, "overbend_element: 20 mm, touchdown_element: 20 mm, longest_element: 40 mm"));
  std::atomic<bool> ended{false};
  std::thread second([&] {
    serving.post("/api/static", {{"full", true}});
    ended = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  Json changes = Json::array();
  for (const char* key : {"overbend_element", "touchdown_element", "longest_element"}) {
    changes.push_back({{"path", std::string("analysis.mesh.") + key}, {"value", "4 m"}});
  }
  const Json answer = serving.post("/api/static", {{"full", true}, {"changes", changes}}).json;
  const bool waited = ended;
  second.join();
  EXPECT_EQ(answer["status"], "converged") << answer;
  EXPECT_FALSE(waited);
}

TEST(serve_limits, a_newer_request_ends_a_probe) {
  // Thousands of elements take a second or more.
  const std::string coarse = "overbend_element: 2.5 m, touchdown_element: 4 m, longest_element: 8 m";
  const Serving serving(
      with(kSmallLay, coarse, "overbend_element: 20 mm, touchdown_element: 20 mm, longest_element: 40 mm"));
  Json probe;
  std::thread background([&] { probe = serving.post("/api/static", {{"full", true}, {"probe", true}}).json; });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const Json invalid = {{"changes", {{{"path", "tensioner.tension"}, {"value", "2 m"}}}}};
  EXPECT_EQ(serving.post("/api/static", invalid).json["status"], "invalid");
  background.join();
  EXPECT_EQ(probe["status"], "overtaken");
}

TEST(serve_limits, changes_of_a_long_text_keep_no_other_tab_waiting) {
  const Serving serving(kSmallLay);
  put(serving, with_boxes(900));
  const Json revision = serving.get("/api/model").json["revision"];
  Json changes = Json::array();  // a second or more: each is made in the text anew
  for (int i = 0; i < 100; ++i) {
    changes.push_back({{"path", "supports.stinger.boxes[" + std::to_string(i) + "].z"}, {"value", "-9 m"}});
  }
  std::atomic<bool> ended{false};
  Reply set;
  std::thread second([&] {
    set = serving.post("/api/model/set", {{"changes", changes}, {"revision", revision}});
    ended = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const Json seen = serving.get("/api/model").json["revision"];
  const bool waited = ended;
  second.join();
  EXPECT_EQ(seen, revision);
  EXPECT_FALSE(waited);
  EXPECT_EQ(set.status, 200) << set.body;
  EXPECT_EQ(serving.get("/api/model").json["revision"], revision.get<int>() + 1);
}

}  // namespace
}  // namespace overbend
