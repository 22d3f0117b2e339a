#include "serve/server.h"

#include "serve/model/data_files.h"
#include "serve/model/lay_table_routes.h"
#include "serve/model/library_hull.h"
#include "serve/model/model_routes.h"
#include "serve/model/seek_routes.h"
#include "serve/model/sensitivity_routes.h"
#include "serve/runs/run_routes.h"

namespace overbend {

Server::Server(const ServeOptions& options)
    : model_(ModelFolder(std::filesystem::canonical(options.folder)),
             [this](std::int64_t revision) {
               events_.send("model", {{"revision", revision}}, "model");
             }),
      runs_(model_.folder().path() / "runs", events_) {
  if (!options.model.empty()) model_.open(options.model);
  std::vector<HttpRoute> routes;
  add_model_routes(routes, model_);
  add_data_routes(routes, model_.folder().path());
  add_hull_routes(routes, model_.folder().path());
  add_static_routes(routes, model_, statics_);
  add_operation_routes(routes, model_, operation_);
  add_lay_table_routes(routes, model_, lay_tables_);
  add_sensitivity_routes(routes, model_);
  add_seek_routes(routes, model_);
  add_run_routes(routes, model_, runs_);
  http_ = std::make_unique<HttpServer>(std::move(routes), events_, options.port);
}

}  // namespace overbend
