/// Server of the graphical interface.
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
  std::filesystem::path folder = ".";  ///< Folder of model files; runs are stored in its subfolder `runs`.
  std::string model;                   ///< Name of the file to open; empty: none.
  int port = 0;                        ///< 0: any free port.
};

/// Serves requests in its own threads during its lifetime.
class Server {
 public:
  /// Throws HttpError if the model cannot be opened, PortError if the port is not available.
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
  std::unique_ptr<HttpServer> http_;  ///< Last member: its threads use the others.
};

}  // namespace overbend
