// Simulations advanced step by step.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>

#include "base/bit_cast.h"
#include "dynamics/machines/mooring_tension.h"
#include "python/background_work.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/python_errors.h"
#include "python/simulation_handle.h"
#include "python/to_python.h"
#include "recording/line_recorder.h"
#include "runstore/checksum.h"
#include "study/run/case.h"

namespace overbend {
namespace {

namespace py = pybind11;
using Handle = Given<SimulationHandle>;
using Saved = Given<SavedSimulation>;

/// Returns (values, units, description, frame).
py::tuple described_values(const py::object& values, const char* units, const char* description,
                           const char* frame = "") {
  return py::make_tuple(values, units, description, frame);
}

py::array read_only(py::array array) {
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Returns the values at the nodes starting at `first`.
py::array along(const std::vector<double>& values, std::size_t first) {
  return read_only(py::array_t<double>(static_cast<py::ssize_t>(values.size() - first), values.data() + first));
}

/// Returns three of the six unknowns of each node as rows, starting at `part` (0 or 3).
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

py::dict state_dict(const SimulationHandle& handle) {
  const Simulation& simulation = handle.simulation();
  const NodeValues values = handle.values();
  const std::size_t first = handle.first_node();
  const LineState& pipe = simulation.present().pipe();
  py::dict state;
  state["s"] =
      described_values(along(handle.pipe().mesh.s, first), "m", "Unstressed arc length from the anchor of the line");
  state["position"] = described_values(vectors(pipe.q, first, 0), "m", "Position of the pipe axis", "W");
  state["tangent"] =
      described_values(vectors(pipe.q, first, 3), "1", "Derivative of the position with respect to s", "W");
  state["velocity"] = described_values(vectors(pipe.v, first, 0), "m/s", "Velocity of the pipe axis", "W");
  state["acceleration"] = described_values(vectors(pipe.acc, first, 0), "m/s2", "Acceleration of the pipe axis", "W");
  state["effective_tension"] = described_values(along(values.effective_tension, first), "N", "Effective tension");
  state["bending_moment"] =
      described_values(along(values.bending_moment, first), "N m", "Magnitude of the bending moment");
  state["curvature"] = described_values(along(values.curvature, first), "1/m", "Magnitude of the curvature");
  state["bending_stress"] = described_values(along(values.bending_stress, first), "Pa", "Bending stress of the steel");
  state["von_mises"] = described_values(along(values.von_mises, first), "Pa", "Von Mises stress of the steel");
  state["strain"] = described_values(along(values.strain, first), "1", "Maximum longitudinal strain of the steel");
  return state;
}

/// Returns names and resultant forces of the roller boxes, and the normal forces of all rollers [N].
py::tuple reactions_tuple(const SimulationHandle& handle) {
  const Instant instant = handle.simulation().present();
  const Supports& supports = handle.model().supports;
  py::list names, sizes, forces, normals, boxes;
  std::vector<Vec3> force(supports.boxes.size(), Vec3::Zero());
  for (std::size_t i = 0; i < supports.rollers.size(); ++i) {
    const RollerContact& contact = instant.contacts()[i];
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

py::dict vessel_dict(const SimulationHandle& handle) {
  const RigidMotion& vessel = handle.simulation().present().vessel();
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

py::dict energy_dict(const SimulationHandle& handle) {
  const EnergyBalance& e = handle.simulation().energy();
  py::dict entries;
  entries["kinetic"] = e.kinetic;
  entries["strain"] = e.strain;
  entries["gravity"] = e.gravity;
  entries["contact"] = e.contact;
  entries["seabed"] = e.seabed;
  entries["work_of_water"] = e.fluid;
  entries["work_of_rollers"] = e.rollers;
  entries["work_of_top"] = e.top;
  entries["work_of_anchor"] = e.anchor;
  entries["contact_loss"] = e.contact_loss;
  entries["friction_loss"] = e.friction_loss;
  entries["seabed_loss"] = e.seabed_loss;
  entries["yielding_loss"] = e.yielding_loss;
  entries["line_loss"] = e.line_loss;
  entries["bodies"] = e.bodies.value_or(0.0);
  entries["work_on_bodies"] = e.on_bodies.value_or(0.0);
  entries["error"] = e.error;
  entries["throughput"] = e.throughput;
  return entries;
}

constexpr const char* kStateNames[kTensionerStates] = {"hold", "delay", "pay_out", "haul_in", "at_limit"};

/// Returns the tensions of a mooring line by its index [N].
py::dict mooring_dict(const SimulationHandle& handle, std::size_t line) {
  checked_index(line, handle.simulation().moorings().size(), "mooring lines");
  const Instant instant = handle.simulation().present();
  py::dict entries;
  entries["tension"] = mooring_tension(*instant.assembly, *instant.state, line, LineEnd::last);
  entries["anchor_tension"] = mooring_tension(*instant.assembly, *instant.state, line, LineEnd::first);
  return entries;
}

/// Returns the tensions at the ends of a separate line by its index [N].
py::dict line_dict(const SimulationHandle& handle, std::size_t line) {
  const Simulation& simulation = handle.simulation();
  checked_index(line, simulation.lines().size(), "lines");
  const FollowedLine& followed = simulation.lines()[line];
  const Instant instant = simulation.present();
  py::dict entries;
  entries["first_tension"] = end_tension(*instant.assembly, *instant.state, followed, LineEnd::first);
  entries["second_tension"] = end_tension(*instant.assembly, *instant.state, followed, LineEnd::last);
  return entries;
}

std::vector<std::string> line_names(const Simulation& simulation) {
  std::vector<std::string> names;
  for (const FollowedLine& line : simulation.lines()) names.push_back(line.name);
  return names;
}

/// Returns the state of the tensioner, or of the winch of a mooring line with elements.
py::dict machine_dict(const SimulationHandle& handle, const std::string& name) {
  const Simulation& simulation = handle.simulation();
  const std::size_t attachment = handle.find_machine_attachment(name);
  const Instant instant = simulation.present();
  const Attachment& held = simulation.system().attachments[attachment];
  const AttachmentState& state = instant.state->attachments[attachment];
  const bool tensioner = name == kTensionerMachine;
  const TensionerLaw& law = held.winch ? held.winch->tension : *held.tensioner;
  py::dict entries;
  if (tensioner) {
    entries["tension"] = simulation.tension();
    entries["paid_out"] = instant.move.paid_out;
    entries["speed"] = state.travel.v;
  } else {
    entries =
        mooring_dict(handle, static_cast<std::size_t>(held.line) - first_line(simulation.system(), LineRole::mooring));
    entries["paid_out"] = state.payout.moved;
    entries["speed"] = state.payout.rate;
  }
  entries["set_tension"] = law.mode == TensionerMode::locked ? 0.0 : law.wanted;
  entries["commanded_speed"] = state.machine.commanded && !state.machine.returning
                                   ? py::object(py::float_(*state.machine.commanded))
                                   : py::object(py::none());
  entries["state"] = kStateNames[static_cast<std::size_t>(state.machine.state)];
  return entries;
}

/// Raises the exception of the user's controller unchanged; other failures as ControllerError or NoSolution.
[[noreturn]] void raise_failure(const SimulationHandle& handle, const SolveError& error) {
  const StaticFailure& failure = error.failure();
  if (!failure.input) throw error;
  raise_controller_exception(handle.controllers(), failure.what + " (" + failure.where + ")");
  raise_controller_error(failure.what, failure.where, failure.why);
}

void advance_to(const Handle& handle, double until) {
  if (std::isnan(until)) throw std::invalid_argument("until: found nan, expected a time [s]");
  std::atomic<bool> stop = false;
  try {
    run_in_background([&] { run_with_gil_calls([&] { handle->advance(until, stop); }); }, stop, {});
  } catch (const SolveError& error) {
    raise_failure(*handle, error);
  }
}

/// Also runs in its own thread, so that Ctrl-C does not interrupt controllers.
bool take_step(const Handle& handle) {
  std::atomic<bool> stop = false;
  bool stepped = false;
  try {
    run_in_background([&] { run_with_gil_calls([&] { stepped = handle->step(); }); }, stop, {});
  } catch (const SolveError& error) {
    raise_failure(*handle, error);
  }
  return stepped;
}

py::dict arrays_dict(const Saved& saved) {
  py::dict arrays;
  for (const DynamicCheckpoint::Array& array : saved->state.arrays) {
    arrays[py::str(array.name)] =
        py::array_t<double>(static_cast<py::ssize_t>(array.values.size()), array.values.data());
  }
  return arrays;
}

/// Returns the checksum of all numbers of a state, to detect modified states.
std::uint64_t state_checksum(const SavedSimulation& saved) {
  std::uint64_t sum = add_to_checksum(kChecksumStart, overbend::bit_cast<std::uint64_t>(saved.state.time));
  for (const DynamicCheckpoint::Array& array : saved.state.arrays) {
    sum = add_to_checksum(sum, array.values.size());
    for (const double value : array.values) sum = add_to_checksum(sum, overbend::bit_cast<std::uint64_t>(value));
  }
  return sum;
}

py::tuple pickled_state(const Saved& saved) {
  return py::make_tuple(saved->input, saved->state.time, arrays_dict(saved), state_checksum(*saved));
}

std::shared_ptr<SavedSimulation> unpickled_state(const py::tuple& pickled) {
  if (pickled.size() != 4) {
    throw py::value_error("this is not a state of a simulation, or it was saved by another version");
  }
  auto saved = std::make_shared<SavedSimulation>();
  saved->input = pickled[0].cast<std::string>();
  saved->state.time = pickled[1].cast<double>();
  for (const auto& [name, values] : pickled[2].cast<py::dict>()) {
    saved->state.arrays.push_back({name.cast<std::string>(), values.cast<std::vector<double>>()});
  }
  if (pickled[3].cast<std::uint64_t>() != state_checksum(*saved)) {
    throw py::value_error("the state of the simulation is damaged: its checksum is wrong");
  }
  return saved;
}

void add_saved(py::module_& module) {
  py::class_<SavedSimulation, std::shared_ptr<SavedSimulation>>(module, "SavedSimulation",
                                                                "A saved state of a simulation.")
      .def_property_readonly("time", [](const Saved& saved) { return saved->state.time; })
      .def_property_readonly("arrays", &arrays_dict)
      .def(py::pickle(&pickled_state, &unpickled_state));
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
                                                                  "A dynamic analysis advanced step by step.")
      .def(py::init(&started), py::arg("model"), py::kw_only(), py::arg("stage") = "", py::arg("duration") = py::none(),
           py::arg("seed") = py::none(), py::arg("controllers") = GivenControllers())
      .def("step", &take_step)
      .def("advance", &advance_to, py::arg("until"))
      .def(
          "command",
          [](const Handle& handle, const std::string& machine, const py::object& answer) {
            handle->command(machine, convert_command(answer, set_tension_class()));
          },
          py::arg("machine"), py::arg("command"))
      .def_property_readonly("time", [](const Handle& handle) { return handle->simulation().time(); })
      .def_property_readonly("end", [](const Handle& handle) { return handle->simulation().end(); })
      .def_property_readonly("next_row", [](const Handle& handle) { return handle->simulation().next_row(); })
      .def_property_readonly("finished", [](const Handle& handle) { return handle->simulation().finished(); })
      .def_property_readonly("last_step", [](const Handle& handle) { return handle->simulation().present().step; })
      .def_property_readonly("steps", [](const Handle& handle) { return handle->simulation().report().steps; })
      .def_property_readonly("wall_time", [](const Handle& handle) { return handle->simulation().report().wall_time; })
      .def_property_readonly("elevation", [](const Handle& handle) { return handle->simulation().present().elevation; })
      .def_property_readonly("mooring_names", [](const Handle& handle) { return handle->simulation().moorings(); })
      .def_property_readonly("line_names", [](const Handle& handle) { return line_names(handle->simulation()); })
      .def_property_readonly("notes",
                             [](const Handle& handle) {
                               const Simulation& simulation = handle->simulation();
                               return py::make_tuple(
                                   texts(simulation.controllers().assumptions()),
                                   to_python(findings_json(simulation.controllers().findings(simulation.system()))));
                             })
      .def("state", [](const Handle& handle) { return state_dict(*handle); })
      .def("reactions", [](const Handle& handle) { return reactions_tuple(*handle); })
      .def("vessel", [](const Handle& handle) { return vessel_dict(*handle); })
      .def("energy", [](const Handle& handle) { return energy_dict(*handle); })
      .def("quasi_static",
           [](const Handle& handle) { return moored_quasi_statically(*handle->simulation().present().assembly); })
      .def(
          "mooring", [](const Handle& handle, std::size_t line) { return mooring_dict(*handle, line); },
          py::arg("line"))
      .def(
          "line", [](const Handle& handle, std::size_t line) { return line_dict(*handle, line); }, py::arg("line"))
      .def(
          "machine", [](const Handle& handle, const std::string& name) { return machine_dict(*handle, name); },
          py::arg("name"))
      .def("save", [](const Handle& handle) { return std::make_shared<SavedSimulation>(handle->save()); })
      .def(
          "restore", [](const Handle& handle, const Saved& saved) { handle->restore(*saved); }, py::arg("saved"));
}

}  // namespace overbend
