#include "dynamics/run/controllers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/bit_cast.h"
#include "base/ranges.h"
#include "base/shown_unit.h"
#include "dynamics/integrator/dynamic_checkpoint.h"
#include "dynamics/machines/end_payout.h"
#include "dynamics/machines/mooring_winch.h"
#include "dynamics/setup/mooring_lines.h"

namespace overbend {
namespace {

constexpr double kSameInstant = 1e-9;        ///< [s]
constexpr double kMinInterval = 1e-3;        ///< [s]
constexpr double kMaxStepOfInterval = 1.25;  ///< Maximum step over the minimum controller interval.
constexpr double kUnsetTime = 1e300;         ///< Saved in place of a time that is not set.

std::string quoted(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "'" : ", '") + name + "'";
  return list;
}

/// Law of the winch if the line has one, else of the tensioner.
TensionerLaw& machine_law(System& system, const CommandedMachine& machine) {
  Attachment& held = system.attachments[machine.attachment];
  return held.winch ? held.winch->tension : *held.tensioner;
}

const TensionerLaw& machine_law(const System& system, const CommandedMachine& machine) {
  const Attachment& held = system.attachments[machine.attachment];
  return held.winch ? held.winch->tension : *held.tensioner;
}

double payout_speed(const Attachment& held, const AttachmentState& state) {
  return held.winch ? state.payout.rate : state.travel.v;
}

const MooringLineDescription& mooring_line(const Model& model, const std::string& name) {
  const std::vector<MooringLineDescription>& lines = model.description.moorings->lines;
  return *std::find_if(lines.begin(), lines.end(), [&](const MooringLineDescription& l) { return l.name == name; });
}

/// Prepares the winch of a line for commands.
void ready_winch(const Model& model, const std::string& name, System& system, std::size_t attachment) {
  const WinchDescription* const described = find_winch(*model.description.moorings, mooring_line(model, name));
  if (described == nullptr) {
    throw std::invalid_argument("mooring line '" + name + "' has no winch to control: give moorings.lines[" + name +
                                "].winch");
  }
  Attachment& held = system.attachments[attachment];
  const WinchLaw law = winch_law(*described);
  WinchLaw& winch = held.winch ? *held.winch : held.winch.emplace(law);
  winch.tension.velocity = law.tension.velocity;
  winch.tension.acceleration = law.tension.acceleration;
  winch.tension.limit = winch_range(system.lines[static_cast<std::size_t>(held.line)]);
}

/// Attachment of the fairlead of a mooring line.
std::size_t find_fairlead(const std::string& name, const std::vector<std::string>& moorings, const System& system) {
  if (ranges::find(moorings, name) == moorings.end()) {
    std::vector<std::string> machines;
    if (find_laid_pipe(system)) machines.push_back(kTensionerMachine);
    machines.insert(machines.end(), moorings.begin(), moorings.end());
    throw std::invalid_argument("there is no machine '" + name + "' to control; there " +
                                (machines.empty() ? "is none" : "are " + quoted(machines)));
  }
  for (const std::size_t line : find_lines(system, LineRole::mooring)) {
    if (system.lines[line].name != name) continue;
    if (const std::optional<std::size_t> fairlead = find_attachment(system, line, LineEnd::last)) return *fairlead;
  }
  throw std::invalid_argument("the winch of mooring line '" + name +
                              "' cannot be controlled: its lines are quasi-static; leave out moorings.model");
}

CommandedMachine tensioner_machine(const LaidPipe& pipe) {
  CommandedMachine machine;
  machine.name = kTensionerMachine;
  machine.label = "the tensioner";
  machine.attachment = pipe.tensioner;
  return machine;
}

/// Reads position and motion of the vessel's freedoms, and the speed of the line's end along the line.
void read_motion(const Assembly& assembly, const SystemState& state, std::size_t attachment, MachineReading& seen) {
  const RigidMotion& vessel = assembly.surroundings().bodies[kVessel];
  std::copy(vessel.freedoms.begin(), vessel.freedoms.end(), seen.vessel);
  std::copy(vessel.velocity.begin(), vessel.velocity.end(), seen.vessel_velocity);
  std::copy(vessel.omega.begin(), vessel.omega.end(), seen.vessel_velocity + 3);
  const Attachment& held = assembly.system().attachments[attachment];
  const LineState& line = state.lines[static_cast<std::size_t>(held.line)];
  const Vec3 along(Eigen::Map<const Vec3>(line.q.data() + line.q.size() - 3));
  seen.guide_speed = assembly.surroundings().ends[attachment].velocity.dot(along.normalized());
}

double line_length(const Line& line, const PayoutState& payout) {
  return line.mesh.total_length() + (payout.last_element > 0.0 ? payout.last_element - line.mesh.length.back() : 0.0);
}

/// `paid_out`: payout of the tensioner [m].
MachineReading make_reading(const Assembly& assembly, const SystemState& state, const CommandedMachine& machine,
                            double paid_out) {
  const Attachment& held = assembly.system().attachments[machine.attachment];
  const AttachmentState& attachment = state.attachments[machine.attachment];
  const TensionerLaw& law = machine_law(assembly.system(), machine);
  MachineReading seen{};
  seen.time = state.time;
  seen.tension = attachment.machine.tension;
  seen.speed = payout_speed(held, attachment);
  seen.set_tension = law.mode == TensionerMode::locked ? 0.0 : law.wanted;
  seen.paid_out = held.winch ? attachment.payout.moved : paid_out;
  seen.length = held.winch
                    ? line_length(assembly.system().lines[static_cast<std::size_t>(held.line)], attachment.payout)
                    : paid_out;
  read_motion(assembly, state, machine.attachment, seen);
  return seen;
}

using ReadingNumbers = std::array<double, sizeof(MachineReading) / sizeof(double)>;

/// Reading interpolated at a time up to that of `current`; `current` itself at its time or without a previous reading.
MachineReading between(const MachineReading& before, const MachineReading& current, double time) {
  MachineReading seen = current;
  if (time < current.time - kSameInstant && before.time < time) {
    const double share = (time - before.time) / (current.time - before.time);
    const auto first = overbend::bit_cast<ReadingNumbers>(before);
    auto last = overbend::bit_cast<ReadingNumbers>(current);
    for (std::size_t i = 0; i < last.size(); ++i) last[i] = first[i] + share * (last[i] - first[i]);
    seen = overbend::bit_cast<MachineReading>(last);
  }
  seen.time = time;
  return seen;
}

/// Reason why a command cannot be executed; empty if it can.
std::string find_command_error(const MachineCommand& command, const TensionerLaw& law, bool winch) {
  switch (command.kind) {
    case MachineCommand::Kind::leave:
      return "";
    case MachineCommand::Kind::speed:
      if (!std::isfinite(command.value)) return fmt::format("a speed of {} m/s is not a number", command.value);
      return law.velocity > 0.0 ? "" : "a speed was requested, but the machine has none: give tensioner.velocity";
    case MachineCommand::Kind::tension:
      if (!(command.value > 0.0) || !std::isfinite(command.value)) {
        return fmt::format("a set tension of {} N is not a positive number", command.value);
      }
      if (law.mode != TensionerMode::locked) return "";
      return winch ? "a tension was requested, but the winch keeps none: give it mode: tension"
                   : "a tension was requested, but the tensioner is locked: give tensioner.mode and tensioner.velocity";
  }
  return "";
}

std::optional<double> saved_time(double saved) {
  return saved < kUnsetTime ? std::optional<double>(saved) : std::nullopt;
}

std::string memory_name(const CommandedMachine& machine) {
  return "controller/" + machine.name;
}

std::string at_time(double time) {
  return fmt::format("at t = {:.6g} s", time);
}

}  // namespace

Controllers::Controllers(const Model& model, const std::vector<ControllerUse>& uses,
                         const std::vector<std::string>& moorings, double start, System& system) {
  const std::optional<LaidPipe> pipe = find_laid_pipe(system);
  if (pipe) machines_.push_back(tensioner_machine(*pipe));
  std::vector<std::string> used_machines;
  for (const ControllerUse& use : uses) {
    if (std::find(used_machines.begin(), used_machines.end(), use.machine) != used_machines.end()) {
      throw std::invalid_argument("there are two controllers for '" + use.machine + "'");
    }
    used_machines.push_back(use.machine);
    if (!(use.interval >= kMinInterval) || !std::isfinite(use.interval)) {
      throw std::invalid_argument(fmt::format("the interval of the controller of '{}' is {} s; the minimum is {} s",
                                              use.machine, use.interval, kMinInterval));
    }
    const bool tensioner = use.machine == kTensionerMachine && pipe;
    if (!tensioner) {
      CommandedMachine winch;
      winch.name = use.machine;
      winch.label = "the winch of mooring line '" + use.machine + "'";
      winch.attachment = find_fairlead(use.machine, moorings, system);
      ready_winch(model, use.machine, system, winch.attachment);
      machines_.push_back(winch);
    }
    CommandedMachine& machine = tensioner ? machines_.front() : machines_.back();
    machine.controller = use.controller;
    machine.interval = use.interval;
    machine.next = static_cast<std::int64_t>(std::ceil((start - kSameInstant) / use.interval));
  }
}

bool Controllers::active() const {
  return std::any_of(machines_.begin(), machines_.end(), [](const CommandedMachine& m) { return m.controller; });
}

double Controllers::max_allowed_step() const {
  double min_interval = std::numeric_limits<double>::infinity();
  for (const CommandedMachine& machine : machines_) {
    if (machine.controller != nullptr) min_interval = std::min(min_interval, machine.interval);
  }
  return kMaxStepOfInterval * min_interval;
}

void Controllers::begin(const Assembly& assembly, SystemState& state) const {
  for (const CommandedMachine& machine : machines_) {
    const Attachment& held = assembly.system().attachments[machine.attachment];
    if (!held.winch) continue;
    const LineAssembly& line = assembly.line(static_cast<std::size_t>(held.line));
    state.attachments[machine.attachment].machine.tension = held_end_load(held, line);
  }
}

std::optional<StaticFailure> Controllers::ask(const Assembly& assembly, double paid_out, System& system,
                                              SystemState& state) {
  for (CommandedMachine& machine : machines_) {
    const AttachmentState& attachment = state.attachments[machine.attachment];
    if (machine.controller == nullptr || attachment.parted) continue;
    if (attachment.machine.state == TensionerState::at_limit && !machine.stopped_at) machine.stopped_at = state.time;
    const MachineReading current = make_reading(assembly, state, machine, paid_out);
    while (machine.next_call_time() <= state.time + kSameInstant) {
      const MachineReading seen = between(machine.before, current, machine.next_call_time());
      ++machine.next;
      try {
        command(machine.name, machine.controller->command(seen), system, state);
      } catch (const std::exception& error) {
        return StaticFailure{kControllerMessagePrefix + machine.label + " failed", at_time(seen.time), error.what(),
                             true};
      }
    }
    machine.before = current;
  }
  return std::nullopt;
}

void Controllers::command(const std::string& name, const MachineCommand& command, System& system, SystemState& state) {
  const auto machine =
      std::find_if(machines_.begin(), machines_.end(), [&](const CommandedMachine& m) { return m.name == name; });
  if (machine == machines_.end()) {
    throw std::invalid_argument("'" + name +
                                "' takes no commands: name it among the controllers at the start of the run");
  }
  const Attachment& held = system.attachments[machine->attachment];
  TensionerLaw& law = machine_law(system, *machine);
  const std::string problem = find_command_error(command, law, held.winch.has_value());
  if (!problem.empty()) throw std::invalid_argument(problem);
  AttachmentState& attachment = state.attachments[machine->attachment];
  if (command.kind == MachineCommand::Kind::speed) {
    machine->max_requested_speed = std::max(machine->max_requested_speed, std::abs(command.value));
    command_speed(attachment.machine, command.value);
    return;
  }
  return_to_law(law, payout_speed(held, attachment), attachment.machine);
  if (command.kind == MachineCommand::Kind::tension) set_target_tension(law, command.value);
}

Assumptions Controllers::assumptions() const {
  Assumptions list;
  for (const CommandedMachine& machine : machines_) {
    if (machine.controller == nullptr) continue;
    list.push_back(
        {AssumptionRank::other, fmt::format("An external controller, called every {:.6g} s, commanded {}. It is not "
                                            "part of the model file, which alone does not reproduce these results.",
                                            machine.interval, machine.label)});
  }
  return list;
}

Findings Controllers::findings(const System& system) const {
  Findings list;
  for (const CommandedMachine& machine : machines_) {
    const TensionerLaw& law = machine_law(system, machine);
    if (machine.max_requested_speed > law.velocity * (1.0 + 1e-9)) {
      list.push_back(Finding{
          FindingCode::controller_limited,
          fmt::format("{} received speed commands of up to {}; its maximum speed is {}", machine.label,
                      shown_digits(machine.max_requested_speed, "m/s", 3), shown_digits(law.velocity, "m/s", 3))}
                         .on(machine.label));
    }
    if (machine.stopped_at && system.attachments[machine.attachment].winch) {
      list.push_back(Finding{FindingCode::controller_limited,
                             fmt::format("{} reached the end of its range, {} in either direction, {}", machine.label,
                                         shown(law.limit, "m", 2), at_time(*machine.stopped_at))}
                         .on(machine.label)
                         .at_time(*machine.stopped_at));
    }
  }
  for (const CommandedMachine& machine : machines_) {
    if (!machine.memory_lost_at) continue;
    list.push_back(Finding{FindingCode::controller_limited,
                           fmt::format("the run was resumed {} with a controller of {} without its earlier memory: "
                                       "it continues as before only if the controller needs no memory",
                                       at_time(*machine.memory_lost_at), machine.label)}
                       .on(machine.label));
  }
  return list;
}

void Controllers::save(const System& system, DynamicCheckpoint& checkpoint) const {
  std::vector<double> numbers;
  for (const CommandedMachine& machine : machines_) {
    const TensionerLaw& law = machine_law(system, machine);
    numbers.insert(numbers.end(), {static_cast<double>(machine.next), machine.max_requested_speed,
                                   machine.stopped_at.value_or(kUnsetTime), machine.memory_lost_at.value_or(kUnsetTime),
                                   law.wanted, law.low, law.high});
    const auto before = overbend::bit_cast<ReadingNumbers>(machine.before);
    numbers.insert(numbers.end(), before.begin(), before.end());
    if (machine.controller != nullptr) checkpoint.arrays.push_back({memory_name(machine), machine.controller->save()});
  }
  checkpoint.arrays.push_back({"controllers", std::move(numbers)});
}

void Controllers::restore(const DynamicCheckpoint& checkpoint, System& system) {
  constexpr std::size_t kOwn = 7, kNumbers = kOwn + std::tuple_size_v<ReadingNumbers>;
  const std::vector<double>& numbers = checkpoint_array(checkpoint, "controllers");
  if (numbers.size() != kNumbers * machines_.size()) {
    throw std::runtime_error("the checkpoint belongs to a run with other controllers");
  }
  for (std::size_t i = 0; i < machines_.size(); ++i) {
    CommandedMachine& machine = machines_[i];
    const double* const v = numbers.data() + kNumbers * i;
    machine.next = std::llround(v[0]);
    machine.max_requested_speed = v[1];
    machine.stopped_at = saved_time(v[2]);
    machine.memory_lost_at = saved_time(v[3]);
    TensionerLaw& law = machine_law(system, machine);
    law.wanted = v[4];
    law.low = v[5];
    law.high = v[6];
    ReadingNumbers before{};
    std::copy_n(v + kOwn, before.size(), before.begin());
    machine.before = overbend::bit_cast<MachineReading>(before);
    if (machine.controller == nullptr) continue;
    const std::vector<double>& memory = checkpoint_array(checkpoint, memory_name(machine));
    machine.controller->restore(memory);
    if (memory.empty()) machine.memory_lost_at = checkpoint.time;
  }
}

}  // namespace overbend
