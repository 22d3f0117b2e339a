// Controllers from Python, and what they see.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "python/bindings.h"
#include "python/given.h"
#include "python/given_controller.h"

namespace overbend {
namespace {

namespace py = pybind11;
using GivenPointer = std::shared_ptr<GivenController>;
using GivenReading = Given<MachineReading>;

py::array_t<double> six(const double* values) {
  return py::array_t<double>(6, values);
}

GivenPointer of_python(const py::function& function, double interval, const py::object& save,
                       const py::object& restore) {
  return std::make_shared<GivenController>(
      GivenController{std::make_shared<PythonController>(function, save, restore), interval});
}

GivenPointer compiled(const py::object& function, double interval, const std::vector<double>& memory) {
  return std::make_shared<GivenController>(
      GivenController{std::make_shared<KeptController>(function, memory), interval});
}

std::vector<double> memory_of(const Given<GivenController>& given) {
  return given->controller ? given->controller->save() : std::vector<double>();
}

template <double MachineReading::*kMember>
double number(const GivenReading& seen) {
  return (*seen).*kMember;
}

void add_reading(py::module_& module) {
  py::class_<MachineReading, std::shared_ptr<MachineReading>>(
      module, "MachineReading", "What a controller sees of its machine and of the vessel.")
      .def_property_readonly("time", number<&MachineReading::time>,
                             "From the end of the build-up; negative during it [s].")
      .def_property_readonly("tension", number<&MachineReading::tension>,
                             "Of the pipe at the tensioner, or of the mooring line at its fairlead [N].")
      .def_property_readonly("paid_out", number<&MachineReading::paid_out>, "Since the start; hauled in negative [m].")
      .def_property_readonly("speed", number<&MachineReading::speed>, "Paying out counts positive [m/s].")
      .def_property_readonly("set_tension", number<&MachineReading::set_tension>,
                             "That the machine's own law restores; 0 where it keeps none [N].")
      .def_property_readonly("length", number<&MachineReading::length>,
                             "Unstressed length of the mooring line; of the tensioner the same as paid_out [m].")
      .def_property_readonly("guide_speed", number<&MachineReading::guide_speed>,
                             "Of what holds the line's end, along the line and away from it [m/s].")
      .def_property_readonly(
          "vessel", [](const GivenReading& seen) { return six(seen->vessel); },
          "Surge, sway, heave [m], roll, pitch, yaw [rad] from the mean pose, shape (6,).")
      .def_property_readonly(
          "vessel_velocity", [](const GivenReading& seen) { return six(seen->vessel_velocity); },
          "Of the vessel's origin along the axes of the world [m/s], and about them [rad/s], shape (6,).");
}

}  // namespace

void add_controllers(py::module_& module) {
  add_reading(module);
  py::class_<GivenController, GivenPointer>(module, "Controller", "A controller as the engine takes it.")
      .def(py::init(&of_python), py::arg("function"), py::arg("interval"), py::arg("save") = py::none(),
           py::arg("restore") = py::none())
      .def_static("compiled", &compiled, py::arg("function"), py::arg("interval"),
                  py::arg("memory") = std::vector<double>())
      .def_static(
          "by_calls", [] { return std::make_shared<GivenController>(); }, "A machine that takes commands by calls.")
      .def_property_readonly("memory", &memory_of);
}

}  // namespace overbend
