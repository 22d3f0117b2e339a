#include "dynamics/setup/dynamic_obstacle.h"

#include <fmt/format.h>
#include <algorithm>

#include "base/shown_unit.h"
#include "dynamics/integrator/dynamic_clock.h"
#include "dynamics/setup/start_leap.h"
#include "model/lay_stage.h"
#include "model/vessel/station.h"
#include "statics/solver/lines_setup.h"
#include "statics/solver/static_obstacle.h"

namespace overbend {
namespace {

constexpr double kLargestLeap = 0.1;  ///< Of the stern shoe, or the end of a line, at t = 0 [m].

StaticFailure refused(const char* key, std::string what, std::string why) {
  return {std::move(what), "", std::move(why), true, key};
}

/// Quasi-static lines pull at a hull and follow lengths; what takes a line of elements is said by name.
std::optional<StaticFailure> quasi_static_obstacle(const Description& d) {
  const auto refuse = [](const std::string& what) {
    return refused("moorings.model", "quasi-static mooring lines " + what, "leave out moorings.model");
  };
  if (d.vessel.motion != VesselMotion::coupled) {
    return refuse("have nothing to pull at where the vessel's motion is told");
  }
  for (const MooringLineDescription& line : d.moorings->lines) {
    if (line.fails_at || line.anchor_holding.slides) {
      return refuse("cannot part or drag an anchor: '" + line.name + "'");
    }
  }
  for (const WinchDescription& winch : d.moorings->winches) {
    const bool by_itself = winch.mode == WinchMode::length && !winch.program.empty();
    if (winch.mode == WinchMode::tension || winch.mode == WinchMode::speed || by_itself) {
      return refuse("follow the lengths of the operation alone: winch '" + winch.name + "'");
    }
  }
  return std::nullopt;
}

/// What is asked of mooring lines that a dynamic analysis does not do.
std::optional<StaticFailure> mooring_obstacle(const Description& d) {
  const MooringsDescription& moorings = *d.moorings;
  if (moorings.model == MooringModel::quasi_static) {
    if (std::optional<StaticFailure> obstacle = quasi_static_obstacle(d)) return obstacle;
  }
  if (d.operation.type == OperationType::anchor_move) {
    return refused("operation.type", "an anchor cannot be moved in time", "overbend static has its stages");
  }
  return std::nullopt;
}

/// A hull that floats free needs its coefficients, and something that holds its place.
std::optional<StaticFailure> coupled_obstacle(const Description& d) {
  if (!d.vessel.coupled || !d.vessel.coupled->data) {
    return refused("vessel.motion.coupled", "the hull that floats free has no hydrodynamic coefficients",
                   "name their files");
  }
  if (!has_station(d) && d.lines.empty()) {
    return refused("vessel.motion.coupled", "nothing holds the hull that floats free in its place",
                   "give moorings, lines or station_keeping");
  }
  return std::nullopt;
}

/// A prescribed motion that is there in full at once, away from where statics leave the vessel or the ends of lines.
std::optional<StaticFailure> leap_obstacle(const Model& model) {
  const auto refuse = [](const char* what, const std::string& why) {
    return refused("analysis.dynamic.build_up", what, "without build-up " + why);
  };
  const double shoe = model.description.has_pipe || has_station(model.description) ? leap_at_start(model) : 0.0;
  if (shoe > kLargestLeap) {
    return refuse(
        "the vessel cannot be at once where its motion has it",
        fmt::format("the stern shoe leaps by {} from where statics have it, and strikes what hangs on it; give "
                    "some wave periods",
                    shown_digits(shoe, "m", 3)));
  }
  const double end = line_leap_at_start(model, dynamic_options(model));
  if (end <= kLargestLeap) return std::nullopt;
  return refuse("the ends of the lines cannot be at once where their motion has them",
                fmt::format("an end leaps by {} from where statics have it, and jerks its line; give some periods",
                            shown_digits(end, "m", 3)));
}

/// A record that ends before the run does. The vessel would stop dead there, and strike what hangs on it.
std::optional<StaticFailure> record_obstacle(const std::string& key, const VesselDescription& vessel,
                                             const DynamicOptions& run) {
  const double first = vessel.history->time.front(), last = vessel.history->time.back();
  const double end = end_of_run(run.duration, run.output_step);
  if (first <= 0.0 && last >= end * (1.0 - 1e-9)) return std::nullopt;
  std::string why = fmt::format("{} goes from t = {:g} s to {:g} s, the run from 0 s to {:g} s", vessel.motion_file,
                                first, last, end);
  if (end > run.duration * (1.0 + 1e-9)) {
    why += fmt::format(
        ": it ends with the first row of output (analysis.dynamic.output_step, {:g} s) at or after its duration of "
        "{:g} s",
        run.output_step, run.duration);
  }
  return refused((key + ".motion.history").c_str(), "the record of the vessel's motion does not cover the run",
                 std::move(why));
}

/// A motion without the file that it is in, or with one that ends too early.
std::optional<StaticFailure> file_obstacle(const std::string& key, const VesselDescription& vessel,
                                           const DynamicOptions& run) {
  if ((vessel.motion == VesselMotion::raos && !vessel.raos) ||
      (vessel.motion == VesselMotion::history && !vessel.history)) {
    return refused((key + ".motion").c_str(), "the " + key + " motion cannot be used",
                   "the file " + vessel.motion_file + " could not be read");
  }
  return vessel.motion == VesselMotion::history ? record_obstacle(key, vessel, run) : std::nullopt;
}

/// In time the friction of the bed has no direction of its own, and the winch that pulls is no machine of the run.
std::optional<StaticFailure> dragging_obstacle(const Description& d) {
  if (!is_dragged(d)) return std::nullopt;
  return refused("operation.type", "a pipe dragged along the seabed by a winch cannot be run in time",
                 "overbend static has its stages; in time friction would have to follow the motion of the winch");
}

/// A straight wire has no attachment of its own that could swing; one with weight on the pipe has no mass yet.
std::optional<StaticFailure> wire_obstacle(const Description& d) {
  const auto heavy = std::ranges::find_if(d.lines, [](const auto& line) { return !is_weightless(line); });
  if (d.has_pipe && heavy != d.lines.end()) {
    return refused("lines", "a line with weight on the pipe cannot be run in time yet",
                   "line '" + heavy->name + "': give it a type without weight");
  }
  const auto on_hull = std::ranges::find_if(d.lines, [](const FreeLineDescription& line) {
    return line.first.kind == LineEndKind::body || line.second.kind == LineEndKind::body;
  });
  if (d.has_pipe && d.vessel.motion == VesselMotion::coupled && on_hull != d.lines.end()) {
    return refused("lines", "a line between the pipe and a hull that floats free cannot be run in time yet",
                   "line '" + on_hull->name + "': give another vessel.motion, or an end that is fixed");
  }
  const auto on_other = std::ranges::find_if(d.lines, [](const FreeLineDescription& line) {
    const auto other = [](const LineEndDescription& end) {
      return end.kind == LineEndKind::body && !is_on_vessel(end);
    };
    return other(line.first) || other(line.second);
  });
  if (d.has_pipe && on_other != d.lines.end()) {
    return refused("lines", "a line between the pipe and a body besides the vessel cannot be run in time yet",
                   "line '" + on_other->name + "': give its other end to the vessel or a fixed place");
  }
  if (!d.has_pipe && d.vessel.motion == VesselMotion::coupled && has_linked_lines(d)) {
    return refused("lines",
                   "lines that hold each other and wires without weight on a hull that floats free cannot be run in "
                   "time yet",
                   "give the wires a weight, or the vessel a motion");
  }
  for (const FreeLineDescription& line : d.lines) {
    const bool linked = d.has_pipe || has_linked_lines(d);
    const bool swings = line.first.period > 0.0 || line.second.period > 0.0;
    if (!linked || !swings || !is_weightless(line) || has_pipe_section(line)) continue;
    return refused("lines", "a wire without weight whose end moves by itself cannot be run in time yet",
                   "line '" + line.name + "': give its type a weight, or its end to the vessel");
  }
  return std::nullopt;
}

/// A motion that cannot be followed over the whole run.
std::optional<StaticFailure> motion_obstacle(const Model& model) {
  const Description& d = model.description;
  const VesselDescription& vessel = d.vessel;
  if (has_station(d) && d.operation.type == OperationType::pull_ahead && !d.operation.loads.empty()) {
    return refused("operation.loads", "loads of a pull-ahead act in statics alone",
                   "give them under vessel.loads, or leave them out where there is a pipe");
  }
  if (has_mooring_lines(d)) {
    if (std::optional<StaticFailure> obstacle = mooring_obstacle(d)) return obstacle;
  }
  if (vessel.motion == VesselMotion::coupled) {
    return coupled_obstacle(d);
  }
  if (d.operation.type == OperationType::pull_ahead && d.operation.acceleration_time <= 0.0) {
    return refused("operation.acceleration_time", "the vessel cannot be at its speed at once",
                   "a told motion without time to reach its speed strikes the pipe; give some seconds");
  }
  return file_obstacle("vessel", vessel, dynamic_options(model));
}

/// The same of the bodies besides the vessel.
std::optional<StaticFailure> bodies_obstacle(const Model& model) {
  const std::vector<BodyDescription>& bodies = model.description.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string key = fmt::format("bodies[{}]", i);
    if (std::optional<StaticFailure> obstacle = file_obstacle(key, bodies[i].hull, dynamic_options(model))) {
      return obstacle;
    }
  }
  return std::nullopt;
}

/// A sea without the file that it is in.
std::optional<StaticFailure> sea_obstacle(const WavesDescription& waves) {
  if (waves.type != WaveType::user || !waves.spectrum.empty()) return std::nullopt;
  return refused("environment.waves.spectrum_file", "the sea cannot be generated",
                 "the file " + waves.spectrum_file + " could not be read");
}

}  // namespace

StaticFailure without_dynamics() {
  return refused("analysis.dynamic", "the model says nothing of a dynamic analysis",
                 "give its duration, for example 10800 s");
}

std::optional<StaticFailure> dynamic_obstacle(const Model& model) {
  const Description& d = model.description;
  if (d.has_pipe) {
    if (std::optional<StaticFailure> obstacle = static_obstacle(d)) return obstacle;
    if (std::optional<StaticFailure> obstacle = dragging_obstacle(d)) return obstacle;
  }
  if (std::optional<StaticFailure> obstacle = wire_obstacle(d)) return obstacle;
  if (!d.dynamics) return without_dynamics();
  if (std::optional<StaticFailure> obstacle = motion_obstacle(model)) return obstacle;
  if (std::optional<StaticFailure> obstacle = bodies_obstacle(model)) return obstacle;
  if (std::optional<StaticFailure> obstacle = sea_obstacle(d.environment.waves)) return obstacle;
  if (std::optional<StaticFailure> obstacle = leap_obstacle(model)) return obstacle;
  if (d.tensioner.range_low && d.tensioner.tension &&
      (*d.tensioner.tension < *d.tensioner.range_low || *d.tensioner.tension > *d.tensioner.range_high)) {
    return refused("tensioner.range", "the range does not contain tensioner.tension",
                   "the tensioner would move from the start");
  }
  return std::nullopt;
}

}  // namespace overbend
