// Lay tables.
#include <pybind11/stl.h>

#include <mutex>

#include "python/bindings.h"
#include "python/given.h"
#include "python/model_handle.h"
#include "python/to_python.h"
#include "python/without_lock.h"
#include "resultfiles/hdf5/result_tree.h"
#include "resultfiles/studies/lay_table_writer.h"
#include "resultfiles/summary/summary_json.h"
#include "results/fields/lay_table_fields.h"
#include "seafiles/route_depths_reader.h"
#include "statics/solver/static_obstacle.h"
#include "study/lay_table/lay_table.h"
#include "study/lay_table/lay_table_range.h"

namespace overbend {
namespace {

namespace py = pybind11;

struct LayTableHandle {
  std::shared_ptr<ModelHandle> model;
  LayTable table;
};

/// What is asked for; empty texts are the model's own.
struct LayTableWish {
  std::string vary, range, depths;  ///< "tension", "200 kN..400 kN/20", file of the depths along a route
  bool least = false;
  std::vector<std::pair<double, double>> profile{};  ///< Distance along the route and depth [m].
};

LayTableDescription asked_table(const Description& description, const LayTableWish& wish) {
  LayTableDescription table = description.lay_table.value_or(LayTableDescription{});
  if (!wish.vary.empty() && !from_word(wish.vary, table.vary)) {
    throw std::invalid_argument("vary: found '" + wish.vary + "', expected tension, lay_back or depth");
  }
  if (!wish.range.empty()) {
    take_range(table.vary, wish.range, table);
  } else if (!wish.vary.empty()) {
    table.from.reset();
    table.to.reset();
    table.profile.clear();
  }
  if (!wish.depths.empty()) {
    Diagnostics diagnostics;
    table.profile = read_route_depths(wish.depths, diagnostics);
    if (diagnostics.has_errors()) throw UnreadableModel(std::move(diagnostics));
  }
  for (const auto& [distance, depth] : wish.profile) table.profile.push_back({distance, depth});
  if (wish.least) table.tension = RouteTension::least;
  return table;
}

/// Counts the rows for the thread that waits.
struct RowWatch {
  std::atomic<bool> stopped = false;
  std::atomic<std::size_t> done = 0, of = 0;

  void tell(const py::object& progress) const {
    if (!progress.is_none() && done > 0) progress(done.load(), of.load());
  }
};

std::shared_ptr<LayTableHandle> made_table(const Given<ModelHandle>& model, const LayTableWish& wish,
                                           const py::object& progress) {
  auto handle = std::make_shared<LayTableHandle>(LayTableHandle{model.shared(), {}});
  RowWatch watch;
  const auto told = [&](const LayTableRow&, std::size_t of) {
    ++watch.done;
    watch.of = of;
    return !watch.stopped;
  };
  const auto make = [&] {
    const Description& description = model->description();
    if (const auto obstacle = pipe_obstacle(description, "a lay table")) throw std::invalid_argument(*obstacle);
    handle->table = make_lay_table(description, asked_table(description, wish), told);
  };
  work_beside(make, watch.stopped, [&] { watch.tell(progress); });
  return handle;
}

using GivenTable = Given<LayTableHandle>;

std::shared_ptr<ResultTree> tree_of_table(const GivenTable& handle) {
  auto tree = std::make_shared<ResultTree>();
  write_lay_table_groups(*tree, handle->table);
  return tree;
}

void save_table(const GivenTable& handle, const std::string& folder) {
  write_lay_table_run(handle->table, handle->model->description(), folder);
}

}  // namespace

void add_lay_tables(py::module_& module) {
  py::class_<LayTableHandle, std::shared_ptr<LayTableHandle>>(module, "LayTable", "A lay in each row.")
      .def(py::init([](const Given<ModelHandle>& model, const std::string& vary, const std::string& range,
                       const std::string& depths, const std::vector<std::pair<double, double>>& profile, bool least,
                       const py::object& progress) {
             return made_table(model, {vary, range, depths, least, profile}, progress);
           }),
           py::arg("model"), py::arg("vary") = "", py::arg("range") = "", py::arg("depths") = "",
           py::arg("profile") = std::vector<std::pair<double, double>>(), py::arg("least") = false,
           py::arg("progress") = py::none())
      .def_property_readonly("model", [](const GivenTable& handle) { return handle->model; })
      .def("summary", [](const GivenTable& handle) { return to_python(read_json(lay_table_summary(handle->table))); })
      .def("tree", &tree_of_table)
      .def("save", &save_table, py::arg("folder"));
}

}  // namespace overbend
