// Simulations that go on step by step.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <bit>
#include <cmath>

#include "dynamics/machines/mooring_tension.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/python_errors.h"
#include "python/simulation_handle.h"
#include "python/to_python.h"
#include "python/without_lock.h"
#include "recording/line_recorder.h"
#include "runstore/checksum.h"
#include "study/run/case.h"

namespace overbend {
namespace {

namespace py = pybind11;
using Handle = Given<SimulationHandle>;
using Saved = Given<SavedSimulation>;

/// Values with what is told of them: (values, units, description, frame).
py::tuple told(const py::object& values, const char* units, const char* description, const char* frame = "") {
  return py::make_tuple(values, units, description, frame);
}

py::array read_only(py::array array) {
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Of the nodes from `first` on.
py::array along(const std::vector<double>& values, std::size_t first) {
  return read_only(py::array_t<double>(static_cast<py::ssize_t>(values.size() - first), values.data() + first));
}

/// The first or the last three of six unknowns per node, as rows.
py::array vectors(const std::vector<double>& values, std::size_t first_node, std::size_t part) {
  const py::ssize_t nodes = static_cast<py::ssize_t>(values.size() / 6 - first_node);
  py::array_t<double> rows({nodes, py::ssize_t{3}});
  auto out = rows.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < nodes; ++i) {
    for (py::ssize_t k = 0; k < 3; ++k) {
      out(i, k) = values[6 * (first_node + static_cast<std::size_t>(i)) + part + static_cast<std::size_t>(k)];
    }
  }
  return read_only(rows);
}

py::dict state_of(const SimulationHandle& handle) {
  const Simulation& simulation = handle.simulation();
  const NodeValues values = handle.values();
  const std::size_t first = handle.first_node();
  const LineState& pipe = simulation.now().pipe();
  py::dict state;
  state["s"] = told(along(handle.pipe().mesh.s, first), "m", "Unstressed arc length from the anchor of the line");
  state["position"] = told(vectors(pipe.q, first, 0), "m", "Place of the pipe's axis", "W");
  state["tangent"] = told(vectors(pipe.q, first, 3), "1", "Derivative of the place with s", "W");
  state["velocity"] = told(vectors(pipe.v, first, 0), "m/s", "Velocity of the pipe's axis", "W");
  state["acceleration"] = told(vectors(pipe.acc, first, 0), "m/s2", "Acceleration of the pipe's axis", "W");
  state["effective_tension"] = told(along(values.effective_tension, first), "N", "Effective tension");
  state["bending_moment"] = told(along(values.bending_moment, first), "N m", "Bending moment, its magnitude");
  state["curvature"] = told(along(values.curvature, first), "1/m", "Curvature, its magnitude");
  state["bending_stress"] = told(along(values.bending_stress, first), "Pa", "Bending stress of the steel");
  state["von_mises"] = told(along(values.von_mises, first), "Pa", "Von Mises stress of the steel");
  state["strain"] = told(along(values.strain, first), "1", "Largest longitudinal strain of the steel");
  return state;
}

/// Names of the boxes, their resultants, and the normal forces of all rollers.
py::tuple reactions_of(const SimulationHandle& handle) {
  const Instant now = handle.simulation().now();
  const Supports& supports = handle.model().supports;
  py::list names, sizes, forces, normals, boxes;
  std::vector<Vec3> force(supports.boxes.size(), Vec3::Zero());
  for (std::size_t i = 0; i < supports.rollers.size(); ++i) {
    const RollerContact& contact = now.contacts()[i];
    force[static_cast<std::size_t>(supports.rollers[i].box)] += contact.force();
    normals.append(contact.normal);
    boxes.append(supports.boxes[static_cast<std::size_t>(supports.rollers[i].box)].name);
  }
  for (std::size_t i = 0; i < supports.boxes.size(); ++i) {
    names.append(supports.boxes[i].name);
    sizes.append(force[i].norm());
    forces.append(py::make_tuple(force[i].x(), force[i].y(), force[i].z()));
  }
  return py::make_tuple(names, sizes, forces, boxes, normals);
}

py::dict vessel_of(const SimulationHandle& handle) {
  const RigidMotion& vessel = handle.simulation().now().vessel();
  const auto vector = [](const Vec3& v) { return py::make_tuple(v.x(), v.y(), v.z()); };
  constexpr const char* kFreedoms[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};
  py::dict pose;
  for (std::size_t i = 0; i < vessel.freedoms.size(); ++i) pose[kFreedoms[i]] = vessel.freedoms[i];
  pose["position"] = vector(vessel.pose.p_WV);
  pose["velocity"] = vector(vessel.velocity);
  pose["angular_velocity"] = vector(vessel.omega);
  py::list axes;
  for (int row = 0; row < 3; ++row) axes.append(vector(vessel.pose.R_WV.row(row)));
  pose["axes"] = axes;
  return pose;
}

py::dict energy_of(const SimulationHandle& handle) {
  const EnergyBalance& e = handle.simulation().energy();
  py::dict told;
  told["kinetic"] = e.kinetic;
  told["strain"] = e.strain;
  told["gravity"] = e.gravity;
  told["contact"] = e.contact;
  told["seabed"] = e.seabed;
  told["work_of_water"] = e.fluid;
  told["work_of_rollers"] = e.rollers;
  told["work_of_top"] = e.top;
  told["work_of_anchor"] = e.anchor;
  told["contact_loss"] = e.contact_loss;
  told["friction_loss"] = e.friction_loss;
  told["seabed_loss"] = e.seabed_loss;
  told["yielding_loss"] = e.yielding_loss;
  told["line_loss"] = e.line_loss;
  told["bodies"] = e.bodies.value_or(0.0);
  told["work_on_bodies"] = e.on_bodies.value_or(0.0);
  told["error"] = e.error;
  told["throughput"] = e.throughput;
  return told;
}

constexpr const char* kStateWords[kTensionerStates] = {"hold", "delay", "pay_out", "haul_in", "at_limit"};

/// Tensions of a mooring line by its number.
py::dict mooring_of(const SimulationHandle& handle, std::size_t line) {
  checked_index(line, handle.simulation().moorings().size(), "mooring lines");
  const Instant now = handle.simulation().now();
  py::dict told;
  told["tension"] = mooring_tension(*now.assembly, *now.state, line, LineEnd::last);
  told["anchor_tension"] = mooring_tension(*now.assembly, *now.state, line, LineEnd::first);
  return told;
}

/// Tensions at the ends of a line that stands by itself, by its number.
py::dict line_of(const SimulationHandle& handle, std::size_t line) {
  const Simulation& simulation = handle.simulation();
  checked_index(line, simulation.lines().size(), "lines");
  const FollowedLine& at = simulation.lines()[line];
  const Instant now = simulation.now();
  py::dict told;
  told["first_tension"] = end_tension(*now.assembly, *now.state, at, LineEnd::first);
  told["second_tension"] = end_tension(*now.assembly, *now.state, at, LineEnd::last);
  return told;
}

std::vector<std::string> line_names(const Simulation& simulation) {
  std::vector<std::string> names;
  for (const FollowedLine& line : simulation.lines()) names.push_back(line.name);
  return names;
}

/// The tensioner, or the winch of a mooring line of elements.
py::dict machine_of(const SimulationHandle& handle, const std::string& name) {
  const Simulation& simulation = handle.simulation();
  const std::size_t attachment = handle.attachment_of(name);
  const Instant now = simulation.now();
  const Attachment& held = simulation.system().attachments[attachment];
  const AttachmentState& at = now.state->attachments[attachment];
  const bool tensioner = name == kTensionerMachine;
  const TensionerLaw& law = held.winch ? held.winch->tension : *held.tensioner;
  py::dict told;
  if (tensioner) {
    told["tension"] = simulation.tension();
    told["paid_out"] = now.move.paid_out;
    told["speed"] = at.travel.v;
  } else {
    told = mooring_of(handle, static_cast<std::size_t>(held.line) - first_line(simulation.system(), LineRole::mooring));
    told["paid_out"] = at.way.moved;
    told["speed"] = at.way.rate;
  }
  told["set_tension"] = law.mode == TensionerMode::locked ? 0.0 : law.wanted;
  told["commanded_speed"] = at.machine.commanded && !at.machine.returning
                                ? py::object(py::float_(*at.machine.commanded))
                                : py::object(py::none());
  told["state"] = kStateWords[static_cast<std::size_t>(at.machine.state)];
  return told;
}

/// What the user's own function raised comes out as it was; else a failure as ControllerError or NoSolution.
[[noreturn]] void tell_failure(const SimulationHandle& handle, const SolveFault& fault) {
  const StaticFailure& failure = fault.failure();
  if (!failure.input) throw fault;
  raise_of_controllers(handle.controllers(), failure.what + " (" + failure.where + ")");
  raise_controller_error(failure.what, failure.where, failure.why);
}

void advance_to(const Handle& handle, double until) {
  if (std::isnan(until)) throw std::invalid_argument("until: found nan, expected a time [s]");
  std::atomic<bool> stop = false;
  try {
    work_beside([&] { work_with_calls([&] { handle->advance(until, stop); }); }, stop, {});
  } catch (const SolveFault& fault) {
    tell_failure(*handle, fault);
  }
}

/// In a thread of its own, too: Ctrl-C is not for the controllers.
bool take_step(const Handle& handle) {
  std::atomic<bool> stop = false;
  bool stepped = false;
  try {
    work_beside([&] { work_with_calls([&] { stepped = handle->step(); }); }, stop, {});
  } catch (const SolveFault& fault) {
    tell_failure(*handle, fault);
  }
  return stepped;
}

py::dict arrays_of(const Saved& saved) {
  py::dict arrays;
  for (const DynamicCheckpoint::Array& array : saved->state.arrays) {
    arrays[py::str(array.name)] =
        py::array_t<double>(static_cast<py::ssize_t>(array.values.size()), array.values.data());
  }
  return arrays;
}

/// Of all numbers of a state: one that was changed would lead the engine astray.
std::uint64_t state_checksum(const SavedSimulation& saved) {
  std::uint64_t sum = add_to_checksum(kChecksumStart, std::bit_cast<std::uint64_t>(saved.state.time));
  for (const DynamicCheckpoint::Array& array : saved.state.arrays) {
    sum = add_to_checksum(sum, array.values.size());
    for (const double value : array.values) sum = add_to_checksum(sum, std::bit_cast<std::uint64_t>(value));
  }
  return sum;
}

py::tuple pickled_state(const Saved& saved) {
  return py::make_tuple(saved->input, saved->state.time, arrays_of(saved), state_checksum(*saved));
}

std::shared_ptr<SavedSimulation> saved_of(const py::tuple& told) {
  if (told.size() != 4) throw py::value_error("this is no state of a simulation, or one of another version");
  auto saved = std::make_shared<SavedSimulation>();
  saved->input = told[0].cast<std::string>();
  saved->state.time = told[1].cast<double>();
  for (const auto& [name, values] : told[2].cast<py::dict>()) {
    saved->state.arrays.push_back({name.cast<std::string>(), values.cast<std::vector<double>>()});
  }
  if (told[3].cast<std::uint64_t>() != state_checksum(*saved)) {
    throw py::value_error("the state of the simulation is damaged: it is not what was saved");
  }
  return saved;
}

void add_saved(py::module_& module) {
  py::class_<SavedSimulation, std::shared_ptr<SavedSimulation>>(module, "SavedSimulation", "A state of a simulation.")
      .def_property_readonly("time", [](const Saved& saved) { return saved->state.time; })
      .def_property_readonly("arrays", &arrays_of)
      .def(py::pickle(&pickled_state, &saved_of));
}

std::shared_ptr<SimulationHandle> started(const Given<ModelHandle>& model, const std::string& stage,
                                          std::optional<double> duration, std::optional<std::uint64_t> seed,
                                          const GivenControllers& controllers) {
  if (seed) require_seeds({*seed});
  return interruptible([&] { return std::make_shared<SimulationHandle>(*model, stage, duration, seed, controllers); });
}

}  // namespace

void add_simulation(py::module_& module) {
  add_saved(module);
  py::class_<SimulationHandle, std::shared_ptr<SimulationHandle>>(module, "Simulation",
                                                                  "A dynamic analysis that goes on step by step.")
      .def(py::init(&started), py::arg("model"), py::kw_only(), py::arg("stage") = "", py::arg("duration") = py::none(),
           py::arg("seed") = py::none(), py::arg("controllers") = GivenControllers())
      .def("step", &take_step)
      .def("advance", &advance_to, py::arg("until"))
      .def(
          "command",
          [](const Handle& handle, const std::string& machine, const py::object& answer) {
            handle->command(machine, command_of(answer, set_tension_class()));
          },
          py::arg("machine"), py::arg("command"))
      .def_property_readonly("time", [](const Handle& handle) { return handle->simulation().time(); })
      .def_property_readonly("end", [](const Handle& handle) { return handle->simulation().end(); })
      .def_property_readonly("next_row", [](const Handle& handle) { return handle->simulation().next_row(); })
      .def_property_readonly("finished", [](const Handle& handle) { return handle->simulation().finished(); })
      .def_property_readonly("last_step", [](const Handle& handle) { return handle->simulation().now().step; })
      .def_property_readonly("steps", [](const Handle& handle) { return handle->simulation().report().steps; })
      .def_property_readonly("wall_time", [](const Handle& handle) { return handle->simulation().report().wall_time; })
      .def_property_readonly("elevation", [](const Handle& handle) { return handle->simulation().now().elevation; })
      .def_property_readonly("mooring_names", [](const Handle& handle) { return handle->simulation().moorings(); })
      .def_property_readonly("line_names", [](const Handle& handle) { return line_names(handle->simulation()); })
      .def_property_readonly("notes",
                             [](const Handle& handle) {
                               const Simulation& simulation = handle->simulation();
                               return py::make_tuple(
                                   texts(simulation.controllers().assumptions()),
                                   to_python(findings_json(simulation.controllers().findings(simulation.system()))));
                             })
      .def("state", [](const Handle& handle) { return state_of(*handle); })
      .def("reactions", [](const Handle& handle) { return reactions_of(*handle); })
      .def("vessel", [](const Handle& handle) { return vessel_of(*handle); })
      .def("energy", [](const Handle& handle) { return energy_of(*handle); })
      .def("quasi_static",
           [](const Handle& handle) { return moored_quasi_statically(*handle->simulation().now().assembly); })
      .def(
          "mooring", [](const Handle& handle, std::size_t line) { return mooring_of(*handle, line); }, py::arg("line"))
      .def(
          "line", [](const Handle& handle, std::size_t line) { return line_of(*handle, line); }, py::arg("line"))
      .def(
          "machine", [](const Handle& handle, const std::string& name) { return machine_of(*handle, name); },
          py::arg("name"))
      .def("save", [](const Handle& handle) { return std::make_shared<SavedSimulation>(handle->save()); })
      .def(
          "restore", [](const Handle& handle, const Saved& saved) { handle->restore(*saved); }, py::arg("saved"));
}

}  // namespace overbend
