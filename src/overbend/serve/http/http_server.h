/// HTTP on the loopback address: guards the door, hands requests to routes, sends events and the page's files.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "serve/http/events.h"
#include "serve/http/guard.h"
#include "serve/http/http.h"

namespace overbend {

/// A port that cannot be had.
class PortFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class HttpServer {
 public:
  static constexpr std::size_t kLargestBody = 2U << 20U;

  /// Takes the port (0: any that is free) and serves from a thread of its own. Throws PortFault.
  HttpServer(std::vector<HttpRoute> routes, EventHub& events, int port);
  /// Ends all connections, events too.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const { return port_; }
  const std::string& token() const { return token_; }
  /// Where the page opens, with the token.
  std::string url() const;
  /// The same for a command line, which others can read: it opens the page once (OneTimeCode).
  std::string one_time_url();

 private:
  struct Library;

  void guard();
  void serve_opening();
  void serve_routes();
  void serve_events();

  std::vector<HttpRoute> routes_;
  EventHub& events_;
  std::string token_;
  OneTimeCode code_;
  int port_ = 0;
  std::unique_ptr<Library> library_;
  std::atomic<bool> closing_{false};  ///< Answers shall end.
  std::thread thread_;
};

}  // namespace overbend
