/// Requests and answers as the handlers see them; the library behind stays in serve/http/http_server.cpp.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/json.h"

namespace overbend {

struct HttpRequest {
  std::string method, path;
  std::multimap<std::string, std::string> query;
  std::string body;
  std::vector<std::string> parts;  ///< The parts matched by '*' in the route's pattern.

  /// First value of a parameter of the address; empty where there is none.
  std::string parameter(const std::string& name) const;
  /// The same as a number, `fallback` where there is none; 400 when it is no number.
  double number(const std::string& name, double fallback) const;
  /// The body as a JSON object; 400 when it is none.
  Json json() const;
};

struct HttpAnswer {
  int status = 200;
  std::string type, body;
  std::string download;  ///< File name under which a browser saves the body; empty: it shows it.
};

HttpAnswer json_answer(const Json& json, int status = 200);
HttpAnswer error_answer(int status, const std::string& message, const std::string& hint = "");

/// A request that cannot be fulfilled; becomes an error answer.
class HttpFault : public std::runtime_error {
 public:
  HttpFault(int status, const std::string& message, std::string hint = "");
  int status;
  std::string hint;
  Json more = Json::object();    ///< In `error`, with the message.
  Json beside = Json::object();  ///< Beside `error`.
};

/// Processor time that an answer may take: of most routes, and of those that search or solve again and again.
inline constexpr std::chrono::seconds kShortLimit{10}, kLongLimit{600};

struct HttpRoute {
  std::string method, pattern;  ///< "/api/runs/*/summary": '*' matches one part.
  std::function<HttpAnswer(const HttpRequest&)> handler;
  std::chrono::seconds limit = kShortLimit;
};

/// Answers a request by the first route that fits: 404 where none does, 405 where only the method does not; faults and
/// exceptions become error answers. 503 where it takes more than its limit, or shall end otherwise.
HttpAnswer answer_by_routes(const std::vector<HttpRoute>& routes, HttpRequest request);

}  // namespace overbend
