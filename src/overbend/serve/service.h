/// The graphical interface without its transport: model, solvers and runs of one folder, and the routes to them.
#pragma once

#include <string>
#include <vector>

#include "serve/model/lay_table_routes.h"
#include "serve/model/live_operation.h"
#include "serve/model/live_statics.h"
#include "serve/model/open_model.h"
#include "serve/runs/run_queue.h"

namespace overbend {

struct ServiceOptions {
  std::filesystem::path folder = ".";  ///< Folder of model files; runs are stored in its subfolder `runs`.
  std::string model;                   ///< Name of the file to open; empty: none.
  RunQueue::Mode runs = RunQueue::Mode::background;
};

class Service {
 public:
  /// Throws HttpError if the model cannot be opened.
  explicit Service(const ServiceOptions& options);

  EventHub& events() { return events_; }
  RunQueue& runs() { return runs_; }
  const std::vector<HttpRoute>& routes() const { return routes_; }

 private:
  EventHub events_;
  OpenModel model_;
  LiveStatics statics_;
  LiveOperation operation_{events_};
  LayTables lay_tables_;
  RunQueue runs_;
  std::vector<HttpRoute> routes_;
};

}  // namespace overbend
