// Runs executed in slices, where there are no threads.
#include <gtest/gtest.h>

#include "app/small_lay.h"
#include "base/json.h"
#include "serve/service.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::TemporaryFolder;
using testing::write_file;

constexpr std::chrono::milliseconds kShort{20}, kLong{600'000};

/// The routes of a folder with one model, without a server.
struct Sliced {
  Sliced() {
    write_file(folder / "model.yaml", kSmallLay);
    service = std::make_unique<Service>(ServiceOptions{folder.path(), "model.yaml", RunQueue::Mode::in_slices});
  }

  Json ask(const std::string& method, const std::string& path, const Json& body = Json::object()) const {
    const HttpAnswer answer = answer_by_routes(service->routes(), {method, path, {}, json_text(body), {}});
    EXPECT_EQ(answer.status, 200) << path << ": " << answer.body;
    return Json::parse(answer.body);
  }

  Json run(const std::string& id) const {
    for (const Json& listed : ask("GET", "/api/runs")) {
      if (listed["id"] == id) return listed;
    }
    return {};
  }

  std::string start(const Json& what) const { return ask("POST", "/api/runs", what).value("id", ""); }

  TemporaryFolder folder;
  std::unique_ptr<Service> service;
};

TEST(serve_slices, a_run_in_slices_gives_the_numbers_of_a_run_in_one) {
  const Sliced sliced;
  const Json order = {{"kind", "dynamic"}, {"duration", 600.0}};
  const std::string at_once = sliced.start(order);
  EXPECT_TRUE(sliced.service->runs().execute_slice(kLong));
  ASSERT_EQ(sliced.run(at_once)["state"], "done");
  const std::string in_parts = sliced.start(order);
  int slices = 0;
  while (sliced.service->runs().execute_slice(kShort)) ++slices;
  EXPECT_GT(slices, 2);
  ASSERT_EQ(sliced.run(in_parts)["state"], "done");
  const auto histories = [&](const std::string& id) {
    return sliced.ask("GET", "/api/runs/" + id + "/summary")["dynamic"]["extremes"];
  };
  EXPECT_FALSE(histories(at_once).empty());
  EXPECT_EQ(histories(in_parts), histories(at_once));
}

TEST(serve_slices, a_run_is_cancelled_between_two_slices_and_keeps_its_results) {
  const Sliced sliced;
  const std::string id = sliced.start({{"kind", "dynamic"}, {"duration", 3600.0}});
  for (int i = 0; i < 1000 && sliced.run(id).value("progress", 0.0) < 0.01; ++i) {
    EXPECT_TRUE(sliced.service->runs().execute_slice(kShort));
  }
  EXPECT_EQ(sliced.run(id)["state"], "running");
  sliced.ask("POST", "/api/runs/" + id + "/cancel");
  while (sliced.service->runs().execute_slice(kShort)) {
  }
  EXPECT_EQ(sliced.run(id)["state"], "cancelled");
  EXPECT_EQ(sliced.run(id)["has_results"], true);
}

TEST(serve_slices, a_study_in_slices_shorter_than_a_case_ends) {
  const Sliced sliced;
  for (const char* analysis : {"static", "dynamic"}) {
    const std::string study = std::string("overbend_study: 1\nbase: model.yaml\nanalysis: ") + analysis +
                              "\naxes:\n  - {key: tensioner.tension, values: [290 kN, 300 kN, 310 kN]}\n";
    const std::string id = sliced.start({{"kind", "study"}, {"study", study}});
    while (sliced.service->runs().execute_slice(std::chrono::milliseconds(1))) {
    }
    EXPECT_EQ(sliced.run(id)["state"], "done") << analysis << ": " << sliced.run(id);
  }
}

TEST(serve_slices, several_seeds_in_slices_end) {
  const Sliced sliced;
  const std::string id = sliced.start({{"kind", "seeds"}, {"seeds", {1, 2}}, {"duration", 4.0}});
  while (sliced.service->runs().execute_slice(std::chrono::milliseconds(1))) {
  }
  EXPECT_EQ(sliced.run(id)["state"], "done") << sliced.run(id);
}

TEST(serve_slices, other_runs_wait_for_the_end_of_the_one_in_progress) {
  const Sliced sliced;
  const std::string first = sliced.start({{"kind", "dynamic"}, {"duration", 10.0}});
  const std::string second = sliced.start({{"kind", "static"}});
  EXPECT_TRUE(sliced.service->runs().execute_slice(kShort));
  EXPECT_EQ(sliced.run(second)["state"], "queued");
  while (sliced.service->runs().execute_slice(kShort)) {
  }
  EXPECT_EQ(sliced.run(first)["state"], "done");
  EXPECT_EQ(sliced.run(second)["state"], "done");
}

}  // namespace
}  // namespace overbend
