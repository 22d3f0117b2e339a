#include "serve/http/http.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <optional>
#include <string_view>

#include "base/interruption.h"
#include "base/units.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

/// Maximum nesting depth of a JSON body, because its traversal is recursive.
constexpr int kMaxNesting = 64;

std::vector<std::string_view> split(std::string_view path) {
  std::vector<std::string_view> parts;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/', 1), path.size());
    parts.push_back(path.substr(1, end - 1));
    path.remove_prefix(end);
  }
  return parts;
}

/// Returns the parts matched by '*'; nothing if the path does not match.
std::optional<std::vector<std::string>> match(const std::string& pattern, const std::string& path) {
  const std::vector<std::string_view> wanted = split(pattern), found = split(path);
  if (wanted.size() != found.size()) return std::nullopt;
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] == "*") {
      parts.emplace_back(found[i]);
    } else if (wanted[i] != found[i]) {
      return std::nullopt;
    }
  }
  return parts;
}

/// Returns the nesting depth of a JSON text. Not done with a callback of the JSON library, whose parser then takes
/// quadratic time in the length of a list.
int nesting_depth(std::string_view text) {
  int depth = 0, deepest = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return deepest;
}

/// Returns the processor time of this thread.
std::chrono::nanoseconds processor_time() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

HttpAnswer answer_guarded(const HttpRoute& route, const HttpRequest& request) {
  const InterruptionScope scope([until = processor_time() + route.limit] { return processor_time() > until; });
  try {
    return route.handler(request);
  } catch (const Interrupted&) {
    return error_answer(503, fmt::format("the request takes more than {} s", route.limit.count()),
                        "make the model smaller, or start a run, which has no time limit");
  } catch (const HttpError& rejection) {
    Json error = {{"message", rejection.what()}, {"hint", rejection.hint}};
    error.update(rejection.more);
    Json answer = {{"error", error}};
    answer.update(rejection.top_level);
    return json_answer(answer, rejection.status);
  } catch (const Json::exception&) {
    return error_answer(400, "the request does not have the required form", "see docs/api.md");
  } catch (const FileError& error) {
    return error_answer(507, error.what(), "the disk may be full");
  } catch (const std::exception& error) {
    return error_answer(500, error.what(), "this is an internal error of the program");
  }
}

}  // namespace

std::string HttpRequest::parameter(const std::string& name) const {
  const auto found = query.find(name);
  return found == query.end() ? std::string() : found->second;
}

double HttpRequest::number(const std::string& name, double fallback) const {
  const std::string text = parameter(name);
  if (text.empty()) return fallback;
  const std::optional<double> value = parse_number(text);
  if (!value) throw HttpError(400, "the parameter " + name + " is not a number");
  return *value;
}

Json HttpRequest::json() const {
  if (nesting_depth(body) > kMaxNesting) throw HttpError(400, "the body of the request is nested too deeply");
  Json read = Json::parse(body.empty() ? "{}" : body, nullptr, false);
  if (!read.is_object()) throw HttpError(400, "the body of the request is not a JSON object");
  return read;
}

HttpAnswer json_answer(const Json& json, int status) {
  // Bytes of a model that are not UTF-8 become the replacement character. The charset keeps the library from
  // compressing local answers.
  return {status, "application/json; charset=utf-8", json_text(json), ""};
}

HttpAnswer error_answer(int status, const std::string& message, const std::string& hint) {
  return json_answer({{"error", {{"message", message}, {"hint", hint}}}}, status);
}

HttpError::HttpError(int code, const std::string& message, std::string advice)
    : std::runtime_error(message), status(code), hint(std::move(advice)) {}

HttpAnswer answer_by_routes(const std::vector<HttpRoute>& routes, HttpRequest request) {
  bool known = false;
  for (const HttpRoute& route : routes) {
    std::optional<std::vector<std::string>> parts = match(route.pattern, request.path);
    if (!parts) continue;
    known = true;
    if (route.method != request.method) continue;
    request.parts = std::move(*parts);
    return answer_guarded(route, request);
  }
  return known ? error_answer(405, "this address does not accept " + request.method)
               : error_answer(404, "there is nothing at " + request.path);
}

}  // namespace overbend
