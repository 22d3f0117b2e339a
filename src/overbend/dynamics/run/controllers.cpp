#include "dynamics/run/controllers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/shown_unit.h"
#include "dynamics/integrator/dynamic_checkpoint.h"
#include "dynamics/machines/giving_ends.h"
#include "dynamics/machines/mooring_winch.h"
#include "dynamics/setup/mooring_lines.h"

namespace overbend {
namespace {

constexpr double kSameInstant = 1e-9;       ///< [s]
constexpr double kShortestInterval = 1e-3;  ///< [s]
constexpr double kOfInterval = 1.25;        ///< No step is longer than this.
constexpr double kNeverHappened = 1e300;    ///< In a checkpoint, in place of a time.

std::string quoted(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "'" : ", '") + name + "'";
  return list;
}

/// Of the winch where a line has one, else of the tensioner.
TensionerLaw& machine_law(System& system, const CommandedMachine& machine) {
  Attachment& held = system.attachments[machine.attachment];
  return held.winch ? held.winch->tension : *held.tensioner;
}

const TensionerLaw& machine_law(const System& system, const CommandedMachine& machine) {
  const Attachment& held = system.attachments[machine.attachment];
  return held.winch ? held.winch->tension : *held.tensioner;
}

double speed_of(const Attachment& held, const AttachmentState& at) {
  return held.winch ? at.way.rate : at.travel.v;
}

const MooringLineDescription& mooring_line(const Model& model, const std::string& name) {
  const std::vector<MooringLineDescription>& lines = model.description.moorings->lines;
  return *std::find_if(lines.begin(), lines.end(), [&](const MooringLineDescription& l) { return l.name == name; });
}

/// The winch of a line as one that takes commands.
void ready_winch(const Model& model, const std::string& name, System& system, std::size_t attachment) {
  const WinchDescription* const described = winch_named_by(*model.description.moorings, mooring_line(model, name));
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

/// The attachment of the fairlead of a mooring line.
std::size_t fairlead_of(const std::string& name, const std::vector<std::string>& moorings, const System& system) {
  if (std::ranges::find(moorings, name) == moorings.end()) {
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
  machine.words = "the tensioner";
  machine.attachment = pipe.tensioner;
  return machine;
}

/// Place and motion of the vessel's freedoms, and of the line's end along the line.
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

double line_length(const Line& line, const GivenWay& way) {
  return line.mesh.total_length() + (way.last_element > 0.0 ? way.last_element - line.mesh.length.back() : 0.0);
}

/// `paid_out`: by the tensioner [m].
MachineReading reading_of(const Assembly& assembly, const SystemState& state, const CommandedMachine& machine,
                          double paid_out) {
  const Attachment& held = assembly.system().attachments[machine.attachment];
  const AttachmentState& at = state.attachments[machine.attachment];
  const TensionerLaw& law = machine_law(assembly.system(), machine);
  MachineReading seen{};
  seen.time = state.time;
  seen.tension = at.machine.tension;
  seen.speed = speed_of(held, at);
  seen.set_tension = law.mode == TensionerMode::locked ? 0.0 : law.wanted;
  seen.paid_out = held.winch ? at.way.moved : paid_out;
  seen.length =
      held.winch ? line_length(assembly.system().lines[static_cast<std::size_t>(held.line)], at.way) : paid_out;
  read_motion(assembly, state, machine.attachment, seen);
  return seen;
}

using ReadingNumbers = std::array<double, sizeof(MachineReading) / sizeof(double)>;

/// What is seen at a time up to that of `now`; of `now` itself at its instant and where nothing was seen before.
MachineReading between(const MachineReading& before, const MachineReading& now, double time) {
  MachineReading seen = now;
  if (time < now.time - kSameInstant && before.time < time) {
    const double share = (time - before.time) / (now.time - before.time);
    const auto first = std::bit_cast<ReadingNumbers>(before);
    auto last = std::bit_cast<ReadingNumbers>(now);
    for (std::size_t i = 0; i < last.size(); ++i) last[i] = first[i] + share * (last[i] - first[i]);
    seen = std::bit_cast<MachineReading>(last);
  }
  seen.time = time;
  return seen;
}

/// Why a command cannot be obeyed; empty where it can.
std::string obstacle_to(const MachineCommand& command, const TensionerLaw& law, bool winch) {
  switch (command.kind) {
    case MachineCommand::Kind::leave:
      return "";
    case MachineCommand::Kind::speed:
      if (!std::isfinite(command.value)) return fmt::format("a speed of {} m/s is not a number", command.value);
      return law.velocity > 0.0 ? "" : "a speed is asked for, but the machine has none: give tensioner.velocity";
    case MachineCommand::Kind::tension:
      if (!(command.value > 0.0) || !std::isfinite(command.value)) {
        return fmt::format("a set tension of {} N is not a positive number", command.value);
      }
      if (law.mode != TensionerMode::locked) return "";
      return winch ? "a tension is asked for, but the winch keeps none: give it mode: tension"
                   : "a tension is asked for, but the tensioner is locked: give tensioner.mode and tensioner.velocity";
  }
  return "";
}

std::optional<double> happened(double saved) {
  return saved < kNeverHappened ? std::optional<double>(saved) : std::nullopt;
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
  std::vector<std::string> given;
  for (const ControllerUse& use : uses) {
    if (std::find(given.begin(), given.end(), use.machine) != given.end()) {
      throw std::invalid_argument("there are two controllers for '" + use.machine + "'");
    }
    given.push_back(use.machine);
    if (!(use.interval >= kShortestInterval) || !std::isfinite(use.interval)) {
      throw std::invalid_argument(fmt::format("the interval of the controller of '{}' is {} s; {} s is the least",
                                              use.machine, use.interval, kShortestInterval));
    }
    const bool tensioner = use.machine == kTensionerMachine && pipe;
    if (!tensioner) {
      CommandedMachine winch;
      winch.name = use.machine;
      winch.words = "the winch of mooring line '" + use.machine + "'";
      winch.attachment = fairlead_of(use.machine, moorings, system);
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

double Controllers::longest_step() const {
  double least = std::numeric_limits<double>::infinity();
  for (const CommandedMachine& machine : machines_) {
    if (machine.controller != nullptr) least = std::min(least, machine.interval);
  }
  return kOfInterval * least;
}

void Controllers::begin(const Assembly& assembly, SystemState& state) const {
  for (const CommandedMachine& machine : machines_) {
    const Attachment& held = assembly.system().attachments[machine.attachment];
    if (!held.winch) continue;
    const LineAssembly& line = assembly.line(static_cast<std::size_t>(held.line));
    state.attachments[machine.attachment].machine.tension = tension_to_take(held, line);
  }
}

std::optional<StaticFailure> Controllers::ask(const Assembly& assembly, double paid_out, System& system,
                                              SystemState& state) {
  for (CommandedMachine& machine : machines_) {
    const AttachmentState& at = state.attachments[machine.attachment];
    if (machine.controller == nullptr || at.parted) continue;
    if (at.machine.state == TensionerState::at_limit && !machine.stopped_at) machine.stopped_at = state.time;
    const MachineReading now = reading_of(assembly, state, machine, paid_out);
    while (machine.asked_at() <= state.time + kSameInstant) {
      const MachineReading seen = between(machine.before, now, machine.asked_at());
      ++machine.next;
      try {
        command(machine.name, machine.controller->command(seen), system, state);
      } catch (const std::exception& fault) {
        return StaticFailure{kControllerOf + machine.words + " failed", at_time(seen.time), fault.what(), true};
      }
    }
    machine.before = now;
  }
  return std::nullopt;
}

void Controllers::command(const std::string& name, const MachineCommand& command, System& system, SystemState& state) {
  const auto machine =
      std::find_if(machines_.begin(), machines_.end(), [&](const CommandedMachine& m) { return m.name == name; });
  if (machine == machines_.end()) {
    throw std::invalid_argument("'" + name + "' takes no commands: name it among the controllers when the run begins");
  }
  const Attachment& held = system.attachments[machine->attachment];
  TensionerLaw& law = machine_law(system, *machine);
  const std::string obstacle = obstacle_to(command, law, held.winch.has_value());
  if (!obstacle.empty()) throw std::invalid_argument(obstacle);
  AttachmentState& at = state.attachments[machine->attachment];
  if (command.kind == MachineCommand::Kind::speed) {
    machine->fastest_asked = std::max(machine->fastest_asked, std::abs(command.value));
    command_speed(at.machine, command.value);
    return;
  }
  leave_to_law(law, speed_of(held, at), at.machine);
  if (command.kind == MachineCommand::Kind::tension) set_wanted_tension(law, command.value);
}

Assumptions Controllers::assumptions() const {
  Assumptions list;
  for (const CommandedMachine& machine : machines_) {
    if (machine.controller == nullptr) continue;
    list.push_back(
        {AssumptionRank::other, fmt::format("A controller from outside, asked every {:.6g} s, drove {}: it is not part "
                                            "of the model file, which alone does not give these results again.",
                                            machine.interval, machine.words)});
  }
  return list;
}

Findings Controllers::findings(const System& system) const {
  Findings list;
  for (const CommandedMachine& machine : machines_) {
    const TensionerLaw& law = machine_law(system, machine);
    if (machine.fastest_asked > law.velocity * (1.0 + 1e-9)) {
      list.push_back(
          Finding{FindingCode::controller_limited,
                  fmt::format("{} was asked for up to {}: it goes at {} at most", machine.words,
                              shown_digits(machine.fastest_asked, "m/s", 3), shown_digits(law.velocity, "m/s", 3))}
              .on(machine.words));
    }
    if (machine.stopped_at && system.attachments[machine.attachment].winch) {
      list.push_back(Finding{FindingCode::controller_limited,
                             fmt::format("{} came to the end of its range, {} either way, {}", machine.words,
                                         shown(law.limit, "m", 2), at_time(*machine.stopped_at))}
                         .on(machine.words)
                         .at_time(*machine.stopped_at));
    }
  }
  for (const CommandedMachine& machine : machines_) {
    if (!machine.forgot_at) continue;
    list.push_back(Finding{FindingCode::controller_limited,
                           fmt::format("the run was taken up {} with a controller of {} that remembers nothing of "
                                       "before: it goes on as it would have only where it needs no memory",
                                       at_time(*machine.forgot_at), machine.words)}
                       .on(machine.words));
  }
  return list;
}

void Controllers::save(const System& system, DynamicCheckpoint& checkpoint) const {
  std::vector<double> numbers;
  for (const CommandedMachine& machine : machines_) {
    const TensionerLaw& law = machine_law(system, machine);
    numbers.insert(numbers.end(), {static_cast<double>(machine.next), machine.fastest_asked,
                                   machine.stopped_at.value_or(kNeverHappened),
                                   machine.forgot_at.value_or(kNeverHappened), law.wanted, law.low, law.high});
    const auto before = std::bit_cast<ReadingNumbers>(machine.before);
    numbers.insert(numbers.end(), before.begin(), before.end());
    if (machine.controller != nullptr) checkpoint.arrays.push_back({memory_name(machine), machine.controller->save()});
  }
  checkpoint.arrays.push_back({"controllers", std::move(numbers)});
}

void Controllers::restore(const DynamicCheckpoint& checkpoint, System& system) {
  constexpr std::size_t kOwn = 7, kNumbers = kOwn + std::tuple_size_v<ReadingNumbers>;
  const std::vector<double>& numbers = checkpoint_array(checkpoint, "controllers");
  if (numbers.size() != kNumbers * machines_.size()) {
    throw std::runtime_error("the checkpoint is of a run with other controllers");
  }
  for (std::size_t i = 0; i < machines_.size(); ++i) {
    CommandedMachine& machine = machines_[i];
    const double* const v = numbers.data() + kNumbers * i;
    machine.next = std::llround(v[0]);
    machine.fastest_asked = v[1];
    machine.stopped_at = happened(v[2]);
    machine.forgot_at = happened(v[3]);
    TensionerLaw& law = machine_law(system, machine);
    law.wanted = v[4];
    law.low = v[5];
    law.high = v[6];
    ReadingNumbers before{};
    std::copy_n(v + kOwn, before.size(), before.begin());
    machine.before = std::bit_cast<MachineReading>(before);
    if (machine.controller == nullptr) continue;
    const std::vector<double>& memory = checkpoint_array(checkpoint, memory_name(machine));
    machine.controller->restore(memory);
    if (memory.empty()) machine.forgot_at = checkpoint.time;
  }
}

}  // namespace overbend
