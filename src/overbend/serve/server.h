/// HTTP server of the graphical interface.
#pragma once

#include <memory>

#include "serve/http/http_server.h"
#include "serve/service.h"

namespace overbend {

/// Serves requests in its own threads during its lifetime.
class Server {
 public:
  /// Binds `port` (0: any free port). Throws HttpError if the model cannot be opened, PortError if the port is not
  /// available.
  Server(const ServiceOptions& options, int port)
      : service_(options), http_(std::make_unique<HttpServer>(service_.routes(), service_.events(), port)) {}

  int port() const { return http_->port(); }
  const std::string& token() const { return http_->token(); }
  std::string url() const { return http_->url(); }
  std::string one_time_url() { return http_->one_time_url(); }

 private:
  Service service_;
  std::unique_ptr<HttpServer> http_;  ///< Last member: its threads use the others.
};

}  // namespace overbend
