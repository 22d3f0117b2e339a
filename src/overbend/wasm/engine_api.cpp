// The program as a WebAssembly module: requests to the routes of the graphical interface, its events, and runs in
// slices, as functions that a worker of the page calls (web/src/api/engine.worker.ts). Texts are UTF-8; a returned text
// is valid until the next call.
#include <emscripten.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "serve/service.h"

namespace overbend {
namespace {

std::unique_ptr<Service> service;
HttpAnswer answer;
std::string text;
std::uint64_t last_event = 0;

/// Decodes "%20"; other text after a percent sign is left unchanged.
std::string percent_decoded(std::string_view part) {
  std::string plain;
  for (std::size_t i = 0; i < part.size(); ++i) {
    unsigned code = 0;
    const char *const digits = part.data() + i + 1, *const end = digits + 2;
    if (part[i] == '%' && i + 2 < part.size() && std::from_chars(digits, end, code, 16).ptr == end) {
      plain += static_cast<char>(code);
      i += 2;
    } else {
      plain += part[i];
    }
  }
  return plain;
}

/// Parses "duration=5&name=a%20b+c".
std::multimap<std::string, std::string> parse_query(std::string query) {
  std::replace(query.begin(), query.end(), '+', ' ');
  std::multimap<std::string, std::string> parameters;
  for (std::string_view rest = query; !rest.empty();) {
    const std::string_view part = rest.substr(0, rest.find('&'));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    const std::size_t equals = std::min(part.find('='), part.size());
    if (part.empty()) continue;
    parameters.emplace(percent_decoded(part.substr(0, equals)),
                       percent_decoded(part.substr(std::min(equals + 1, part.size()))));
  }
  return parameters;
}

}  // namespace
}  // namespace overbend

extern "C" {

/// Opens a folder of the module's file system, and a model of it; "": none. Returns an empty text or an error.
EMSCRIPTEN_KEEPALIVE const char* overbend_start(const char* folder, const char* model) {
  try {
    overbend::service = std::make_unique<overbend::Service>(
        overbend::ServiceOptions{folder, model, overbend::RunQueue::Mode::in_slices});
    overbend::text.clear();
  } catch (const std::exception& error) {
    overbend::text = error.what();
  }
  return overbend::text.c_str();
}

/// Answers a request; returns its HTTP status.
EMSCRIPTEN_KEEPALIVE int overbend_request(const char* method, const char* path, const char* query, const char* body) {
  overbend::answer = overbend::answer_by_routes(
      overbend::service->routes(), {method, overbend::percent_decoded(path), overbend::parse_query(query), body, {}});
  return overbend::answer.status;
}

EMSCRIPTEN_KEEPALIVE const char* overbend_answer_type() {
  return overbend::answer.type.c_str();
}
EMSCRIPTEN_KEEPALIVE const char* overbend_answer_download() {
  return overbend::answer.download.c_str();
}
EMSCRIPTEN_KEEPALIVE const char* overbend_answer_body() {
  return overbend::answer.body.data();
}
EMSCRIPTEN_KEEPALIVE int overbend_answer_size() {
  return static_cast<int>(overbend::answer.body.size());
}

/// Executes the active run for about `milliseconds`; returns 0 if no run is queued.
EMSCRIPTEN_KEEPALIVE int overbend_execute_slice(int milliseconds) {
  return overbend::service->runs().execute_slice(std::chrono::milliseconds(milliseconds)) ? 1 : 0;
}

/// Returns the events since the last call as text of an event stream.
EMSCRIPTEN_KEEPALIVE const char* overbend_take_events() {
  overbend::text = overbend::service->events().since(overbend::last_event);
  return overbend::text.c_str();
}
}
