#include "serve/http/http_server.h"

#include <fmt/format.h>

#include "base/interruption.h"
#include "platform/socket.h"
#include "serve/http/listener.h"
#include "serve/http/page_files.h"

namespace overbend {
namespace {

constexpr std::size_t kMaxPathLength = 1000;  ///< The library's pattern matching recurses for every character.

HttpRequest make_request(const httplib::Request& from) {
  return {from.method, from.path, {from.params.begin(), from.params.end()}, from.body, {}};
}

void fill(httplib::Response& to, HttpAnswer answer) {
  to.status = answer.status;
  if (!answer.download.empty()) {
    to.set_header("Content-Disposition", "attachment; filename=\"" + answer.download + "\"");
  }
  if (answer.body.empty()) {
    to.set_content("", answer.type);
    return;
  }
  // A provider of known length keeps the library from compressing texts, which is useless on the same machine.
  const auto body = std::make_shared<std::string>(std::move(answer.body));
  to.set_content_provider(body->size(), answer.type,
                          [body](std::size_t offset, std::size_t count, httplib::DataSink& sink) {
                            return sink.write(body->data() + offset, count);
                          });
}

const char* status_message(int status) {
  switch (status) {
    case 413:
      return "the request is larger than 2 MB";
    case 404:
      return "there is nothing at this address";
    default:
      return "the request cannot be understood";
  }
}

bool bears_token(const httplib::Request& request, const std::string& token) {
  const std::string header = request.get_header_value("X-Overbend-Token");
  return same_token(header.empty() ? request.get_param_value("token") : header, token);
}

/// Returns an error answer if the body announced by the head cannot be accepted; an empty answer otherwise. Only a body
/// with a known length and without encoding can be limited in size.
HttpAnswer find_body_error(const httplib::Request& request) {
  if (request.has_header("Transfer-Encoding")) {
    return error_answer(411, "the request does not state the length of its body", "send it with Content-Length");
  }
  if (request.has_header("Content-Encoding")) {
    return error_answer(415, "the body of the request is compressed", "send it without Content-Encoding");
  }
  if (!request.has_header("Content-Length")) return {};
  const std::string length = request.get_header_value("Content-Length");
  const bool number = !length.empty() && length.find_first_not_of("0123456789") == std::string::npos;
  if (!number || request.get_header_value_count("Content-Length") > 1) {
    return error_answer(400, "the length of the request body is ambiguous");
  }
  if (length.size() > 12 || std::stoull(length) > HttpServer::kMaxBody) return error_answer(413, status_message(413));
  const bool takes_body = request.method == "PUT" || request.method == "POST";
  if (takes_body || length.find_first_not_of('0') == std::string::npos) return {};
  return error_answer(400, "a request of this kind has no body");
}

HttpAnswer find_request_error(const httplib::Request& request, int port, const std::string& token) {
  if (!own_host(request.get_header_value("Host"), port) || !own_origin(request.get_header_value("Origin"), port)) {
    return error_answer(403, "this server accepts requests from its own page only",
                        "open the address that the program printed");
  }
  if (request.path.size() > kMaxPathLength) return error_answer(414, "the address is too long");
  if (HttpAnswer answer = find_body_error(request); !answer.type.empty()) return answer;
  if (!request.path.starts_with("/api") || bears_token(request, token)) return {};
  return error_answer(401, "the token of the address is missing or from an earlier session",
                      "open the address that the program printed");
}

LimitedServer::Standing standing(const httplib::Request& request, int port, const std::string& token) {
  if (!find_request_error(request, port, token).type.empty()) return LimitedServer::Standing::rejected;
  return bears_token(request, token) ? LimitedServer::Standing::known : LimitedServer::Standing::unauthenticated;
}

}  // namespace

struct HttpServer::Library {
  LimitedServer server;
};

HttpServer::HttpServer(std::vector<HttpRoute> routes, EventHub& events, int port)
    : routes_(std::move(routes)), events_(events), token_(random_token()) {
  library_.reset(new Library{LimitedServer([this](const httplib::Request& r) { return standing(r, port_, token_); })});
  LimitedServer& server = library_->server;
  server.set_payload_max_length(kMaxBody);
  // Omits the library's SO_REUSEPORT, with which two programs could share a port.
  server.set_socket_options([](socket_t socket) { set_exclusive_port(static_cast<Socket>(socket)); });
  server.set_tcp_nodelay(true);
  server.set_keep_alive_max_count(1U << 20U);  // announced to the client; a slider makes thousands of requests
  port_ = port == 0 ? server.bind_to_any_port("127.0.0.1") : server.bind_to_port("127.0.0.1", port) ? port : -1;
  if (port_ <= 0) {
    throw PortError(fmt::format("the port {} on 127.0.0.1 is not available; another program may be using it", port));
  }
  server.set_backlog();
  guard();
  serve_opening();
  serve_events();
  serve_routes();
  thread_ = std::thread([&server] { server.listen_after_bind(); });
}

HttpServer::~HttpServer() {
  closing_ = true;
  events_.close();
  while (!library_->server.is_running()) std::this_thread::yield();  // stop() before the start would have no effect
  library_->server.stop();
  library_->server.close();
  thread_.join();
}

std::string HttpServer::url() const {
  return fmt::format("http://127.0.0.1:{}/?token={}", port_, token_);
}

std::string HttpServer::one_time_url() {
  return fmt::format("http://127.0.0.1:{}/open/{}", port_, code_.make());
}

/// Redirects to the page with the token in its address. A cookie would also be sent to servers of other users at other
/// ports of this machine.
void HttpServer::serve_opening() {
  library_->server.Get("/open/.*", [this](const httplib::Request& request, httplib::Response& response) {
    const std::string code = request.path.substr(std::string("/open/").size());
    if (request.method == "GET" && code_.take(code, is_own_connection(request.remote_port, port_))) {
      response.set_redirect("/?token=" + token_);
    } else {
      fill(response, error_answer(403, "this address has already been used, or belongs to another user",
                                  "open the address that the program printed"));
    }
  });
}

void HttpServer::guard() {
  httplib::Server& server = library_->server;
  server.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Cache-Control", "no-store");
    HttpAnswer answer = find_request_error(request, port_, token_);
    if (answer.type.empty()) return httplib::Server::HandlerResponse::Unhandled;
    fill(response, std::move(answer));
    return httplib::Server::HandlerResponse::Handled;
  });
  server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
    if (response.get_header_value("Content-Type").empty()) {
      const HttpAnswer answer = error_answer(response.status, status_message(response.status));
      response.set_content(answer.body, answer.type);
    }
  });
}

void HttpServer::serve_routes() {
  httplib::Server& server = library_->server;
  const auto by_routes = [this](const httplib::Request& request, httplib::Response& response) {
    const InterruptionScope scope([this] { return closing_.load(); });
    fill(response, answer_by_routes(routes_, make_request(request)));
  };
  server.Get("/api/.*", by_routes);
  server.Put("/api/.*", by_routes);
  server.Post("/api/.*", by_routes);
  server.Get("/.*", [](const httplib::Request& request, httplib::Response& response) {
    response.set_header("Content-Security-Policy", kPagePolicy);
    fill(response, page_file(request.path));
  });
}

void HttpServer::serve_events() {
  library_->server.Get("/api/events", [this](const httplib::Request&, httplib::Response& response) {
    const auto last = std::make_shared<std::uint64_t>(events_.newest());
    const auto begun = std::make_shared<bool>(false);
    response.set_chunked_content_provider("text/event-stream",
                                          [this, last, begun](std::size_t, httplib::DataSink& sink) {
                                            std::string text = *begun ? events_.wait(*last) : ": welcome\n\n";
                                            *begun = true;
                                            if (events_.closed()) {
                                              sink.done();
                                              return false;
                                            }
                                            // A periodic comment detects closed connections.
                                            if (text.empty()) text = ":\n\n";
                                            return sink.write(text.data(), text.size());
                                          });
  });
}

}  // namespace overbend
