// Controllers from Python, and their machine readings.
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

GivenPointer make_python_controller(const py::function& function, double interval, const py::object& save,
                                    const py::object& restore) {
  return std::make_shared<GivenController>(
      GivenController{std::make_shared<PythonController>(function, save, restore), interval});
}

GivenPointer compiled(const py::object& function, double interval, const std::vector<double>& memory) {
  return std::make_shared<GivenController>(
      GivenController{std::make_shared<CtypesController>(function, memory), interval});
}

std::vector<double> saved_memory(const Given<GivenController>& controller) {
  return controller->controller ? controller->controller->save() : std::vector<double>();
}

template <double MachineReading::*kMember>
double number(const GivenReading& seen) {
  return (*seen).*kMember;
}

void add_reading(py::module_& module) {
  py::class_<MachineReading, std::shared_ptr<MachineReading>>(
      module, "MachineReading", "State of the machine and of the vessel, passed to a controller.")
      .def_property_readonly("time", number<&MachineReading::time>,
                             "Time from the end of the build-up; negative during it [s].")
      .def_property_readonly("tension", number<&MachineReading::tension>,
                             "Tension of the pipe at the tensioner, or of the mooring line at its fairlead [N].")
      .def_property_readonly("paid_out", number<&MachineReading::paid_out>,
                             "Length paid out since the start; negative if hauled in [m].")
      .def_property_readonly("speed", number<&MachineReading::speed>, "Pay-out speed; negative when hauling in [m/s].")
      .def_property_readonly("set_tension", number<&MachineReading::set_tension>,
                             "Target tension of the machine's own law; 0 if it has none [N].")
      .def_property_readonly("length", number<&MachineReading::length>,
                             "Unstressed length of the mooring line; equal to paid_out for the tensioner [m].")
      .def_property_readonly("guide_speed", number<&MachineReading::guide_speed>,
                             "Speed of the attachment of the line end, along the line and away from it [m/s].")
      .def_property_readonly(
          "vessel", [](const GivenReading& seen) { return six(seen->vessel); },
          "Surge, sway, heave [m] and roll, pitch, yaw [rad] from the mean pose, shape (6,).")
      .def_property_readonly(
          "vessel_velocity", [](const GivenReading& seen) { return six(seen->vessel_velocity); },
          "Velocity of the vessel's origin along the world axes [m/s] and angular velocity about them [rad/s], shape "
          "(6,).");
}

}  // namespace

void add_controllers(py::module_& module) {
  add_reading(module);
  py::class_<GivenController, GivenPointer>(module, "Controller", "A controller for the engine.")
      .def(py::init(&make_python_controller), py::arg("function"), py::arg("interval"), py::arg("save") = py::none(),
           py::arg("restore") = py::none())
      .def_static("compiled", &compiled, py::arg("function"), py::arg("interval"),
                  py::arg("memory") = std::vector<double>())
      .def_static(
          "by_calls", [] { return std::make_shared<GivenController>(); },
          "A machine that is commanded by method calls.")
      .def_property_readonly("memory", &saved_memory);
}

}  // namespace overbend
