// Only the page of this start is served.
#include "serve/http/access_token.h"

#include "serve/serving.h"

namespace overbend {
namespace {

using testing::Serving;

TEST(serve_guard, a_token_is_never_the_same_twice) {
  EXPECT_EQ(random_token().size(), 32u);
  EXPECT_NE(random_token(), random_token());
}

TEST(serve_guard, only_the_loopback_names_with_the_right_port_are_its_own) {
  EXPECT_TRUE(own_host("127.0.0.1:8080", 8080));
  EXPECT_TRUE(own_host("localhost:8080", 8080));
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:80", "evil.example:8080", "127.0.0.1.evil.example:8080"}) {
    EXPECT_FALSE(own_host(host, 8080)) << host;
  }
  EXPECT_TRUE(own_origin("", 8080));
  EXPECT_TRUE(own_origin("http://localhost:8080", 8080));
  for (const char* origin : {"null", "https://127.0.0.1:8080", "http://127.0.0.1:81", "http://evil.example"}) {
    EXPECT_FALSE(own_origin(origin, 8080)) << origin;
  }
}

TEST(serve_guard, a_request_without_the_token_is_rejected) {
  const Serving serving;
  EXPECT_EQ(Serving::reply(serving.client().Get("/api/info")).status, 401);
  EXPECT_EQ(Serving::reply(serving.client().Get("/api/info?token=guess")).status, 401);
  EXPECT_EQ(Serving::reply(serving.client().Get("/api/info", {{"X-Overbend-Token", "guess"}})).status, 401);
  EXPECT_EQ(Serving::reply(serving.client().Get("/api/info?token=" + serving.server->token())).status, 200);
  EXPECT_EQ(serving.get("/api/info").status, 200);
}

TEST(serve_guard, a_rejection_says_what_to_do) {
  const Serving serving;
  const auto answer = Serving::reply(serving.client().Get("/api/info")).json;
  EXPECT_NE(answer["error"]["message"].get<std::string>().find("token"), std::string::npos);
  EXPECT_NE(answer["error"]["hint"].get<std::string>().find("address"), std::string::npos);
}

TEST(serve_guard, a_foreign_host_or_origin_is_rejected_even_with_the_token) {
  const Serving serving;
  httplib::Headers headers = serving.headers();
  headers.emplace("Host", "evil.example:" + std::to_string(serving.server->port()));
  EXPECT_EQ(Serving::reply(serving.client().Get("/api/info", headers)).status, 403);
  EXPECT_EQ(Serving::reply(serving.client().Get("/", headers)).status, 403);
  headers = serving.headers();
  headers.emplace("Origin", "http://evil.example");
  EXPECT_EQ(Serving::reply(serving.client().Get("/api/info", headers)).status, 403);
}

TEST(serve_guard, an_oversized_body_is_413) {
  const Serving serving;
  const std::string body(HttpServer::kMaxBody + 1, ' ');
  const testing::Reply reply =
      Serving::reply(serving.client().Put("/api/model", serving.headers(), body, "application/json"));
  EXPECT_EQ(reply.status, 413);
  EXPECT_NE(reply.json["error"]["message"].get<std::string>().find("2 MB"), std::string::npos);
}

TEST(serve_guard, what_is_not_there_is_404_and_a_wrong_method_405) {
  const Serving serving;
  EXPECT_EQ(serving.get("/api/nothing").status, 404);
  EXPECT_EQ(serving.get("/nothing.js").status, 404);
  EXPECT_EQ(serving.get("/api/model/set").status, 405);
  EXPECT_EQ(serving.get("/../CMakeLists.txt").status, 404);
}

TEST(serve_guard, a_body_that_is_no_json_is_400) {
  const Serving serving;
  const auto reply = Serving::reply(serving.client().Put("/api/model", serving.headers(), "{", "application/json"));
  EXPECT_EQ(reply.status, 400);
}

TEST(serve_guard, the_page_comes_with_a_policy_and_is_not_kept) {
  const Serving serving;
  const httplib::Result page = serving.client().Get("/");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 200);
  EXPECT_NE(page->body.find("<html"), std::string::npos);
  EXPECT_NE(page->get_header_value("Content-Security-Policy").find("default-src 'self'"), std::string::npos);
  EXPECT_EQ(page->get_header_value("X-Content-Type-Options"), "nosniff");
}

TEST(serve_guard, a_port_that_is_taken_is_said_so) {
  const Serving serving;
  EXPECT_THROW(Server(ServiceOptions{serving.folder.path(), ""}, serving.server->port()), PortError);
}

}  // namespace
}  // namespace overbend
