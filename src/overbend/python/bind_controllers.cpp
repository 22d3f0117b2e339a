// Controllers from Python, and what they see.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "python/bindings.h"
#include "python/given_controller.h"

namespace overbend {
namespace {

namespace py = pybind11;
using GivenPointer = std::shared_ptr<GivenController>;

py::array_t<double> six(const double* values) {
  return py::array_t<double>(6, values);
}

GivenPointer of_python(const py::function& function, double interval, const py::object& save,
                       const py::object& restore) {
  return std::make_shared<GivenController>(
      GivenController{std::make_shared<PythonController>(function, save, restore), interval});
}

GivenPointer compiled(std::uintptr_t address, double interval, const std::vector<double>& memory) {
  // NOLINTNEXTLINE(performance-no-int-to-ptr): Python tells the place of a function as a number
  const auto function = reinterpret_cast<overbend_controller>(address);
  return std::make_shared<GivenController>(
      GivenController{std::make_shared<CompiledController>(function, memory), interval});
}

std::vector<double> memory_of(const GivenController& given) {
  return given.controller ? given.controller->save() : std::vector<double>();
}

void add_reading(py::module_& module) {
  py::class_<MachineReading>(module, "MachineReading", "What a controller sees of its machine and of the vessel.")
      .def_readonly("time", &MachineReading::time, "From the end of the build-up; negative during it [s].")
      .def_readonly("tension", &MachineReading::tension,
                    "Of the pipe at the tensioner, or of the mooring line at its fairlead [N].")
      .def_readonly("paid_out", &MachineReading::paid_out, "Since the start; hauled in negative [m].")
      .def_readonly("speed", &MachineReading::speed, "Paying out counts positive [m/s].")
      .def_readonly("set_tension", &MachineReading::set_tension,
                    "That the machine's own law restores; 0 where it keeps none [N].")
      .def_readonly("length", &MachineReading::length,
                    "Unstressed length of the mooring line; of the tensioner the same as paid_out [m].")
      .def_readonly("guide_speed", &MachineReading::guide_speed,
                    "Of what holds the line's end, along the line and away from it [m/s].")
      .def_property_readonly(
          "vessel", [](const MachineReading& seen) { return six(seen.vessel); },
          "Surge, sway, heave [m], roll, pitch, yaw [rad] from the mean pose, shape (6,).")
      .def_property_readonly(
          "vessel_velocity", [](const MachineReading& seen) { return six(seen.vessel_velocity); },
          "Of the vessel's origin along the axes of the world [m/s], and about them [rad/s], shape (6,).");
}

}  // namespace

void add_controllers(py::module_& module) {
  add_reading(module);
  py::class_<GivenController, GivenPointer>(module, "Controller", "A controller as the engine takes it.")
      .def(py::init(&of_python), py::arg("function"), py::arg("interval"), py::arg("save") = py::none(),
           py::arg("restore") = py::none())
      .def_static("compiled", &compiled, py::arg("address"), py::arg("interval"),
                  py::arg("memory") = std::vector<double>())
      .def_static(
          "by_calls", [] { return std::make_shared<GivenController>(); }, "A machine that takes commands by calls.")
      .def_property_readonly("memory", &memory_of);
}

}  // namespace overbend
