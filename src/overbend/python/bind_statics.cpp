// Statics of a model.
#include "python/bindings.h"
#include "python/statics_handle.h"
#include "python/to_python.h"
#include "python/without_lock.h"

namespace overbend {
namespace {

namespace py = pybind11;

std::shared_ptr<StaticsHandle> solved(const std::shared_ptr<ModelHandle>& model, const std::string& stage,
                                      const StaticsHandle* start) {
  return without_lock([&] { return std::make_shared<StaticsHandle>(model, stage, start); });
}

}  // namespace

void add_statics(py::module_& module) {
  py::class_<StaticsHandle, std::shared_ptr<StaticsHandle>>(module, "Statics", "An equilibrium.")
      .def(py::init(&solved), py::arg("model"), py::arg("stage") = "", py::arg("start") = nullptr)
      .def_property_readonly("model", &StaticsHandle::model)
      .def(
          "summary",
          [](const StaticsHandle& statics, bool all) {
            return to_python(without_lock([&] { return statics.summary(all); }));
          },
          py::arg("all"), "As summary.json; without `all` lacks the limits of roller friction and the hull's damping.")
      .def("tree", &StaticsHandle::tree, py::call_guard<py::gil_scoped_release>(), "As results.h5.")
      .def(
          "save", [](const StaticsHandle& statics, const std::string& folder) { statics.save(folder); },
          py::arg("folder"));
}

}  // namespace overbend
