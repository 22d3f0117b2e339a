/// HTTP server on the loopback address: controls access, dispatches requests to routes, sends events and page files.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "serve/http/access_token.h"
#include "serve/http/events.h"
#include "serve/http/http.h"

namespace overbend {

/// Thrown if a port is not available.
class PortError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class HttpServer {
 public:
  static constexpr std::size_t kMaxBody = 2U << 20U;

  /// Binds the port (0: any free port) and serves in its own thread. Throws PortError.
  HttpServer(std::vector<HttpRoute> routes, EventHub& events, int port);
  /// Ends all connections, including event streams.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const { return port_; }
  const std::string& token() const { return token_; }
  /// Returns the address of the page with the token.
  std::string url() const;
  /// Returns an address for a command line, which other users can read: it opens the page once (OneTimeCode).
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
  std::atomic<bool> closing_{false};  ///< True if running requests must end.
  std::thread thread_;
};

}  // namespace overbend
