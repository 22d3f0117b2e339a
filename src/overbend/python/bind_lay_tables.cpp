// Lay tables.
#include <pybind11/stl.h>

#include <mutex>

#include "python/background_work.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/model_handle.h"
#include "python/to_python.h"
#include "resultfiles/hdf5/result_tree.h"
#include "resultfiles/studies/lay_table_writer.h"
#include "resultfiles/summary/summary_json.h"
#include "results/fields/lay_table_fields.h"
#include "seafiles/route_depths_reader.h"
#include "statics/solver/unsupported_statics.h"
#include "study/lay_table/lay_table.h"
#include "study/lay_table/lay_table_range.h"

namespace overbend {
namespace {

namespace py = pybind11;

struct LayTableHandle {
  std::shared_ptr<ModelHandle> model;
  LayTable table;
};

/// Request for a lay table; empty texts: use the model's settings.
struct LayTableRequest {
  std::string vary, range, depths;  ///< "tension", "200 kN..400 kN/20", file of the depths along a route
  bool min_tension = false;
  std::vector<std::pair<double, double>> profile{};  ///< Distance along the route and depth [m].
};

LayTableDescription requested_table(const Description& description, const LayTableRequest& request) {
  LayTableDescription table = description.lay_table.value_or(LayTableDescription{});
  if (!request.vary.empty() && !from_enum_name(request.vary, table.vary)) {
    throw std::invalid_argument("vary: found '" + request.vary + "', expected tension, lay_back or depth");
  }
  if (!request.range.empty()) {
    take_range(table.vary, request.range, table);
  } else if (!request.vary.empty()) {
    table.from.reset();
    table.to.reset();
    table.profile.clear();
  }
  if (!request.depths.empty()) {
    Diagnostics diagnostics;
    table.profile = read_route_depths(request.depths, diagnostics);
    if (diagnostics.has_errors()) throw UnreadableModel(std::move(diagnostics));
  }
  for (const auto& [distance, depth] : request.profile) table.profile.push_back({distance, depth});
  if (request.min_tension) table.tension = RouteTension::minimum;
  return table;
}

/// Counts the rows, for the waiting thread.
struct RowWatch {
  std::atomic<bool> stopped = false;
  std::atomic<std::size_t> done = 0, of = 0;

  void report_progress(const py::object& progress) const {
    if (!progress.is_none() && done > 0) progress(done.load(), of.load());
  }
};

std::shared_ptr<LayTableHandle> made_table(const Given<ModelHandle>& model, const LayTableRequest& request,
                                           const py::object& progress) {
  auto handle = std::make_shared<LayTableHandle>(LayTableHandle{model.shared(), {}});
  RowWatch watch;
  const auto on_row = [&](const LayTableRow&, std::size_t total) {
    ++watch.done;
    watch.of = total;
    return !watch.stopped;
  };
  const auto make = [&] {
    const Description& description = model->description();
    if (const auto unsupported = missing_pipe_message(description, "a lay table")) {
      throw std::invalid_argument(*unsupported);
    }
    handle->table = make_lay_table(description, requested_table(description, request), on_row);
  };
  run_in_background(make, watch.stopped, [&] { watch.report_progress(progress); });
  return handle;
}

using GivenTable = Given<LayTableHandle>;

std::shared_ptr<ResultTree> make_table_tree(const GivenTable& handle) {
  auto tree = std::make_shared<ResultTree>();
  write_lay_table_groups(*tree, handle->table);
  return tree;
}

void save_table(const GivenTable& handle, const std::string& folder) {
  write_lay_table_run(handle->table, handle->model->description(), folder);
}

}  // namespace

void add_lay_tables(py::module_& module) {
  py::class_<LayTableHandle, std::shared_ptr<LayTableHandle>>(module, "LayTable",
                                                              "Table of lay equilibria, one per row.")
      .def(py::init([](const Given<ModelHandle>& model, const std::string& vary, const std::string& range,
                       const std::string& depths, const std::vector<std::pair<double, double>>& profile,
                       bool min_tension, const py::object& progress) {
             return made_table(model, {vary, range, depths, min_tension, profile}, progress);
           }),
           py::arg("model"), py::arg("vary") = "", py::arg("range") = "", py::arg("depths") = "",
           py::arg("profile") = std::vector<std::pair<double, double>>(), py::arg("least") = false,
           py::arg("progress") = py::none())
      .def_property_readonly("model", [](const GivenTable& handle) { return handle->model; })
      .def("summary", [](const GivenTable& handle) { return to_python(read_json(lay_table_summary(handle->table))); })
      .def("tree", &make_table_tree)
      .def("save", &save_table, py::arg("folder"));
}

}  // namespace overbend
