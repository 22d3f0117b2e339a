// Static analysis of a model.
#include <pybind11/stl.h>

#include "base/file_lock.h"
#include "python/background_work.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/statics_handle.h"
#include "python/to_python.h"

namespace overbend {
namespace {

namespace py = pybind11;

using GivenStatics = Given<StaticsHandle>;

std::shared_ptr<StaticsHandle> solved(const Given<ModelHandle>& model, const std::string& stage,
                                      const std::optional<GivenStatics>& start) {
  const StaticsHandle* const from = start ? &**start : nullptr;
  return interruptible([&] { return std::make_shared<StaticsHandle>(model.shared(), stage, from); });
}

}  // namespace

void add_statics(py::module_& module) {
  py::class_<StaticsHandle, std::shared_ptr<StaticsHandle>>(module, "Statics", "A static equilibrium.")
      .def(py::init(&solved), py::arg("model"), py::arg("stage") = "", py::arg("start") = py::none())
      .def_property_readonly("model", [](const GivenStatics& statics) { return statics->model(); })
      .def(
          "summary",
          [](const GivenStatics& statics, bool all) {
            return to_python(interruptible([&] { return statics->summary(all); }));
          },
          py::arg("all"),
          "Returns the contents of summary.json; without `all`, the limits of roller friction and the hull damping are "
          "omitted.")
      .def(
          "tree", [](const GivenStatics& statics) { return interruptible([&] { return statics->tree(); }); },
          "Returns the datasets of results.h5.")
      .def(
          "save",
          [](const GivenStatics& statics, const std::string& folder) {
            const std::lock_guard hold(hdf5_lock());
            statics->save(folder);
          },
          py::arg("folder"));
}

}  // namespace overbend
