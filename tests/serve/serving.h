/// A server on the loopback address and a client that talks to it as the page does.
#pragma once

#include <httplib.h>
#undef _res  // <resolv.h> has it as a macro, Eigen as a name

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/small_lay.h"
#include "base/json.h"
#include "serve/server.h"
#include "support/solved_case.h"

namespace overbend::testing {

struct Reply {
  int status = 0;
  Json json;
  std::string body;
  std::string type;
};

class Serving {
 public:
  /// The text, if any, is the open model, model.yaml of the server's folder.
  explicit Serving(const std::string& text = "") {
    if (!text.empty()) write_file(folder / "model.yaml", text);
    restart(text.empty() ? "" : "model.yaml");
  }

  void restart(const std::string& model) {
    server.reset();
    server = std::make_unique<Server>(ServiceOptions{folder.path(), model}, 0);
  }

  httplib::Client client() const {
    httplib::Client client("127.0.0.1", server->port());
    client.set_read_timeout(60);
    return client;
  }
  httplib::Headers headers() const { return {{"X-Overbend-Token", server->token()}}; }

  Reply get(const std::string& path) const { return reply(client().Get(path, headers())); }
  Reply post(const std::string& path, const Json& body) const {
    return reply(client().Post(path, headers(), json_text(body), "application/json"));
  }
  Reply put(const std::string& path, const Json& body) const {
    return reply(client().Put(path, headers(), json_text(body), "application/json"));
  }

  /// The run as listed, when it has come to its end (or a minute has passed).
  Json wait_for(const std::string& id) const {
    return wait_until(id, [](const Json& run) { return run["state"] != "queued" && run["state"] != "running"; });
  }

  template <class Condition>
  Json wait_until(const std::string& id, Condition condition) const {
    Json found;
    for (int i = 0; i < 3000; ++i) {
      for (const Json& run : get("/api/runs").json) {
        if (run["id"] == id) found = run;
      }
      if (found.is_object() && condition(found)) return found;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ADD_FAILURE() << "the run does not get there: " << found;
    return found;
  }

  static Reply reply(const httplib::Result& result) {
    if (!result) {
      ADD_FAILURE() << "no answer: " << httplib::to_string(result.error());
      return {};
    }
    return {result->status, Json::parse(result->body, nullptr, false), result->body,
            result->get_header_value("Content-Type")};
  }

  TemporaryFolder folder;
  std::unique_ptr<Server> server;
};

}  // namespace overbend::testing
