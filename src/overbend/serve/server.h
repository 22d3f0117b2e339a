/// The server of the graphical interface, assembled from its parts.
#pragma once

#include <memory>

#include "serve/http/http_server.h"
#include "serve/model/lay_table_routes.h"
#include "serve/model/live_operation.h"
#include "serve/model/live_statics.h"
#include "serve/model/open_model.h"
#include "serve/runs/run_queue.h"

namespace overbend {

struct ServeOptions {
  std::filesystem::path folder = ".";  ///< Of model files; runs go to its `runs`.
  std::string model;                   ///< Name of the file to open; empty: none.
  int port = 0;                        ///< 0: any that is free.
};

/// Serves while it lives, from threads of its own.
class Server {
 public:
  /// Throws HttpFault when the model cannot be opened, PortFault when the port cannot be had.
  explicit Server(const ServeOptions& options);

  int port() const { return http_->port(); }
  const std::string& token() const { return http_->token(); }
  std::string url() const { return http_->url(); }
  std::string one_time_url() { return http_->one_time_url(); }

 private:
  EventHub events_;
  OpenModel model_;
  LiveStatics statics_;
  LiveOperation operation_{events_};
  LayTables lay_tables_;
  RunQueue runs_;
  std::unique_ptr<HttpServer> http_;  ///< The last: its threads use the others.
};

}  // namespace overbend
