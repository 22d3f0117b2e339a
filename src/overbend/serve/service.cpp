#include "serve/service.h"

#include "serve/model/data_files.h"
#include "serve/model/import_routes.h"
#include "serve/model/library_hull.h"
#include "serve/model/model_routes.h"
#include "serve/model/seek_routes.h"
#include "serve/model/sensitivity_routes.h"
#include "serve/runs/run_routes.h"

namespace overbend {

Service::Service(const ServiceOptions& options)
    : model_(ModelFolder(std::filesystem::canonical(options.folder)),
             [this](std::int64_t revision) {
               events_.send("model", {{"revision", revision}}, "model");
             }),
      runs_(model_.folder().path() / "runs", events_, options.runs) {
  if (!options.model.empty()) model_.open(options.model);
  add_model_routes(routes_, model_);
  add_data_routes(routes_, model_.folder().path());
  add_import_routes(routes_, model_.folder().path());
  add_hull_routes(routes_, model_.folder().path());
  add_static_routes(routes_, model_, statics_);
  add_operation_routes(routes_, model_, operation_);
  add_lay_table_routes(routes_, model_, lay_tables_);
  add_sensitivity_routes(routes_, model_);
  add_seek_routes(routes_, model_);
  add_run_routes(routes_, model_, runs_);
}

}  // namespace overbend
