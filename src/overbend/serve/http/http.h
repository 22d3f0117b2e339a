/// Requests and answers for handlers, independent of the HTTP library (serve/http/http_server.cpp).
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

  /// Returns the first value of a query parameter; empty if missing.
  std::string parameter(const std::string& name) const;
  /// The same as a number; `fallback` if missing. HttpError 400 if it is not a number.
  double number(const std::string& name, double fallback) const;
  /// Returns the body as a JSON object; HttpError 400 if it is not one.
  Json json() const;
};

struct HttpAnswer {
  int status = 200;
  std::string type, body;
  std::string download;  ///< File name under which a browser saves the body; empty: it is displayed.
};

HttpAnswer json_answer(const Json& json, int status = 200);
HttpAnswer error_answer(int status, const std::string& message, const std::string& hint = "");

/// Error of a request; becomes an error answer.
class HttpError : public std::runtime_error {
 public:
  HttpError(int status, const std::string& message, std::string hint = "");
  int status;
  std::string hint;
  Json more = Json::object();       ///< Additional members of `error`.
  Json top_level = Json::object();  ///< Additional members next to `error`.
};

/// Limits of processor time per request: of most routes, and of routes that search or solve repeatedly.
inline constexpr std::chrono::seconds kShortLimit{10}, kLongLimit{600};

struct HttpRoute {
  std::string method, pattern;  ///< "/api/runs/*/summary": '*' matches one part.
  std::function<HttpAnswer(const HttpRequest&)> handler;
  std::chrono::seconds limit = kShortLimit;
};

/// Answers a request by the first matching route: 404 if none matches, 405 if only the method does not match.
/// Exceptions become error answers. 503 if the request exceeds its time limit or is interrupted.
HttpAnswer answer_by_routes(const std::vector<HttpRoute>& routes, HttpRequest request);

}  // namespace overbend
