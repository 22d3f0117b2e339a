// Requests that no browser would send do no harm to those that one does.
#include <atomic>
#include <memory>

#include "platform/socket.h"
#include "serve/http/connection.h"
#include "serve/http/connection_limiter.h"
#include "serve/raw_client.h"
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::RawClient;
using testing::Reply;
using testing::Serving;

/// Head of a request with the token; more headers, each with its line end, may be added.
std::string head(const Serving& serving, const std::string& line, const std::string& more = "") {
  return line + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(serving.server->port()) +
         "\r\nX-Overbend-Token: " + serving.server->token() + "\r\n" + more + "\r\n";
}

/// Number of answers in it.
int answers(const std::string& text) {
  int count = 0;
  for (std::size_t index = text.find("HTTP/1.1 "); index != std::string::npos;
       index = text.find("HTTP/1.1 ", index + 1))
    ++count;
  return count;
}

std::string converse(const Serving& serving, const std::string& text) {
  const RawClient client(serving.server->port());
  client.send(text);
  return client.read();
}

TEST(serve_door, json_nested_beyond_reason_is_400) {
  const Serving serving(kSmallLay);
  const std::string nested = std::string(500000, '[') + std::string(500000, ']');
  for (const std::string& body : {R"({"revision": 1, "changes": [{"path": "title", "value": )" + nested + "}]}",
                                  R"({"revision": 1, "text": )" + nested + "}", nested, std::string(1000000, '[')}) {
    const Reply reply =
        Serving::reply(serving.client().Post("/api/model/set", serving.headers(), body, "application/json"));
    EXPECT_EQ(reply.status, 400);
  }
  EXPECT_EQ(serving.get("/api/info").status, 200);
}

TEST(serve_door, a_model_nested_beyond_reason_is_diagnosed) {
  const Serving serving(kSmallLay);
  std::string ladder;
  for (int i = 0; i < 700; ++i) ladder += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  int revision = 0;
  for (const std::string& text :
       {"a: " + std::string(20000, '['), "a: " + std::string(20000, '{'), ladder, std::string(20000, '-')}) {
    const Reply reply = serving.put("/api/model", {{"text", text}, {"revision", ++revision}});
    ASSERT_EQ(reply.status, 200);
    EXPECT_FALSE(reply.json["diagnostics"].empty());
  }
}

TEST(serve_door, a_body_of_unknown_length_is_411_before_it_is_read) {
  const Serving serving;
  const std::string answer =
      converse(serving, head(serving, "PUT /api/model", "Transfer-Encoding: chunked\r\n") + "100000\r\nand no end");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 411 ")) << answer;
  EXPECT_EQ(answers(answer), 1);
}

TEST(serve_door, a_packed_body_is_415_before_it_is_read) {
  const Serving serving;
  for (const std::string packing : {"gzip", "deflate", "br"}) {
    const std::string more = "Content-Encoding: " + packing + "\r\nContent-Length: 1000000\r\n";
    const std::string answer = converse(serving, head(serving, "PUT /api/model", more) + "xxxx");
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 415 ")) << answer;
  }
}

TEST(serve_door, a_length_beyond_the_limit_is_413_before_it_is_read) {
  const Serving serving;
  for (const std::string length : {"3000000", "3000000000", "99999999999999999999999"}) {
    const std::string answer =
        converse(serving, head(serving, "PUT /api/model", "Content-Length: " + length + "\r\n") + "xxxx");
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 413 ")) << answer;
  }
}

// The body is a whole request with the right token, which a page of another origin could not have sent by itself.
TEST(serve_door, the_body_of_a_rejected_request_is_no_request) {
  const Serving serving;
  const std::string hidden = head(serving, "GET /api/info");
  const std::string length = "Content-Length: " + std::to_string(hidden.size()) + "\r\n";
  const std::string port = std::to_string(serving.server->port());
  for (const std::string& outer :
       {head(serving, "POST /api/runs", "Origin: http://evil.example\r\n" + length),
        "POST /api/runs HTTP/1.1\r\nHost: evil.example\r\n" + length + "\r\n",
        "POST /api/runs HTTP/1.1\r\nHost: 127.0.0.1:" + port + "\r\n" + length + "\r\n",
        head(serving, "GET /api/info", length), head(serving, "DELETE /api/info", length),
        head(serving, "OPTIONS /api/info", length), head(serving, "GET /", length),
        head(serving, "POST /api/runs", "Content-Length: x\r\n"),
        head(serving, "POST /api/runs", "Content-Length: 0\r\n" + length),
        head(serving, "POST /api/runs", "Transfer-Encoding: chunked\r\n" + length), head(serving, "no request"),
        std::string("POST /api/runs HTTP/1.1\r\nno header\r\n\r\n")}) {
    const std::string answer = converse(serving, outer + hidden);
    EXPECT_LE(answers(answer), 1) << outer << answer;
    EXPECT_EQ(answer.find("\"version\""), std::string::npos) << outer << answer;
  }
}

TEST(serve_door, requests_one_after_the_other_on_a_connection_are_all_answered) {
  const Serving serving(kSmallLay);
  const std::string body = R"({"revision": 1, "changes": []})";
  const std::string set =
      head(serving, "POST /api/model/set", "Content-Length: " + std::to_string(body.size()) + "\r\n") + body;
  const std::string get = head(serving, "GET /api/info"),
                    last = head(serving, "GET /api/info", "Connection: close\r\n");
  EXPECT_EQ(answers(converse(serving, set + get + get + last)), 4);
}

TEST(serve_door, a_head_without_end_ends_the_connection) {
  const Serving serving;
  const RawClient client(serving.server->port());
  client.send("GET / HTTP/1.1\r\n");
  const std::string line = "X: " + std::string(1000, 'x') + "\r\n";
  int sent = 0;
  while (sent < 100000 && client.send(line)) ++sent;
  EXPECT_LT(sent, 100000);  // 100 MB
}

TEST(serve_door, an_address_beyond_reason_is_rejected) {
  const Serving serving;
  const std::string answer =
      converse(serving, head(serving, "GET /api/" + std::string(5000, 'x'), "Connection: close\r\n"));
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 414 ")) << answer;
}

TEST(serve_door, dripping_connections_keep_no_user_out) {
  const Serving serving(kSmallLay);
  std::vector<std::unique_ptr<RawClient>> unauthenticated_clients;
  for (int i = 0; i < 100; ++i) {
    unauthenticated_clients.push_back(std::make_unique<RawClient>(serving.server->port()));
    unauthenticated_clients.back()->send("GET / HTTP/1.1\r\nX-Slow: ");
  }
  std::atomic<bool> enough = false;
  std::thread dripping([&] {
    while (!enough) {
      for (const auto& unauthenticated_client : unauthenticated_clients) unauthenticated_client->send("x");
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  });
  EXPECT_EQ(serving.get("/api/info").status, 200);
  EXPECT_EQ(serving.post("/api/static", Json::object()).json["status"], "converged");
  enough = true;
  dripping.join();
}

TEST(serve_door, a_crowd_of_unauthenticated_connections_does_not_end_a_connection_with_the_token) {
  const Serving serving(kSmallLay);
  const RawClient listener(serving.server->port());
  listener.send(head(serving, "GET /api/events"));
  ASSERT_NE(listener.read("welcome").find("200 OK"), std::string::npos);
  std::vector<std::unique_ptr<RawClient>> unauthenticated_clients;
  for (int i = 0; i < 100; ++i) {
    unauthenticated_clients.push_back(std::make_unique<RawClient>(serving.server->port()));
    unauthenticated_clients.back()->send("GET / HTTP/1.1\r\n");
  }
  serving.put("/api/model", {{"text", kSmallLay + "# more\n"}, {"revision", 1}});
  EXPECT_NE(listener.read("event: model").find("event: model"), std::string::npos);
}

TEST(serve_door, a_request_that_drips_is_cut_off) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  RequestBounds bounds;
  bounds.head = std::chrono::milliseconds(60);
  Connection connection(ends[0], bounds);
  std::atomic<bool> enough = false;
  std::thread dripping([&] {
    while (!enough && ::send(ends[1], "x", 1, MSG_NOSIGNAL) == 1) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  });
  ASSERT_TRUE(connection.wait_for_request());
  char byte = 0;
  while (connection.read(&byte, 1) == 1) {
  }
  enough = true;  // would never be reached by a bound on each byte alone
  dripping.join();
  for (const int end : ends) ::close(end);
}

TEST(serve_door, an_opening_address_opens_once_and_leads_to_the_token) {
  const Serving serving;
  const std::string url = serving.server->one_time_url();
  EXPECT_EQ(url.find(serving.server->token()), std::string::npos);
  const std::string path = url.substr(url.find("/open/"));
  EXPECT_EQ(serving.client().Get("/open/" + std::string(32, '0'))->status, 403);
  EXPECT_EQ(serving.client().Get("/open/")->status, 403);
  const httplib::Result first = serving.client().Get(path);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->status, 302);
  EXPECT_EQ(first->get_header_value("Location"), "/?token=" + serving.server->token());
  EXPECT_EQ(serving.client().Get(path)->status, 403);
}

TEST(serve_door, an_opening_address_opens_for_its_own_user_alone) {
  OneTimeCode code;
  const std::string made = code.make();
  EXPECT_FALSE(code.take(made, false));
  EXPECT_TRUE(code.take(made, true));
  EXPECT_FALSE(code.take(made, true));
  EXPECT_FALSE(OneTimeCode().take("", true));
}

TEST(serve_door, the_system_reports_whose_a_connection_is) {
  const Serving serving;
  const RawClient client(serving.server->port());
  EXPECT_TRUE(is_own_connection(client.port(), serving.server->port()));
  EXPECT_FALSE(is_own_connection(1, serving.server->port()));
}

}  // namespace
}  // namespace overbend
