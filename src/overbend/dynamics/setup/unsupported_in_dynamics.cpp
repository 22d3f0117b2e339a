#include "dynamics/setup/unsupported_in_dynamics.h"

#include <fmt/format.h>
#include <algorithm>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "dynamics/integrator/dynamic_clock.h"
#include "dynamics/setup/initial_jump.h"
#include "model/lay_stage.h"
#include "model/site/wave_groups.h"
#include "model/vessel/mooring_queries.h"
#include "statics/solver/lines_setup.h"
#include "statics/solver/unsupported_statics.h"

namespace overbend {
namespace {

constexpr double kMaxInitialJump = 0.1;  ///< Maximum initial jump of the stern shoe, or of a line end, at t = 0 [m].

StaticFailure make_input_error(std::string key, std::string what, std::string why) {
  return {std::move(what), "", std::move(why), true, std::move(key)};
}

/// Quasi-static mooring lines only act on a hull and follow prescribed lengths; features that need lines of elements
/// are rejected by name.
std::optional<StaticFailure> unsupported_quasi_static_moorings(const Description& d) {
  const auto reject = [](const std::string& what) {
    return make_input_error("moorings.model", "quasi-static mooring lines " + what, "leave out moorings.model");
  };
  if (d.vessel.motion != VesselMotion::coupled) {
    return reject("have no effect on a vessel with prescribed motion");
  }
  for (const MooringLineDescription& line : d.moorings->lines) {
    if (line.fails_at || line.anchor_holding.slides) {
      return reject("cannot part or drag an anchor: '" + line.name + "'");
    }
  }
  for (const WinchDescription& winch : d.moorings->winches) {
    const bool by_itself = winch.mode == WinchMode::length && !winch.program.empty();
    if (winch.mode == WinchMode::tension || winch.mode == WinchMode::speed || by_itself) {
      return reject("only follow the lengths of the operation: winch '" + winch.name + "'");
    }
  }
  return std::nullopt;
}

/// Mooring features that are unsupported in dynamics.
std::optional<StaticFailure> unsupported_moorings(const Description& d) {
  const MooringsDescription& moorings = *d.moorings;
  if (moorings.model == MooringModel::quasi_static) {
    if (std::optional<StaticFailure> reason = unsupported_quasi_static_moorings(d)) return reason;
  }
  if (d.operation.type == OperationType::anchor_move) {
    return make_input_error("operation.type", "moving an anchor is not supported in dynamic analysis",
                            "use overbend static for its stages");
  }
  return std::nullopt;
}

/// A floating hull needs its hydrodynamic coefficients and a horizontal restraint.
std::optional<StaticFailure> floating_hull_error(const Description& d) {
  if (!d.vessel.coupled || !d.vessel.coupled->data) {
    return make_input_error("vessel.motion.coupled", "the floating hull has no hydrodynamic coefficients",
                            "give their files");
  }
  if (!finds_vessel_position(d) && d.lines.empty()) {
    return make_input_error("vessel.motion.coupled", "the floating hull has no horizontal restraint",
                            "give moorings, lines or station_keeping");
  }
  return std::nullopt;
}

/// A prescribed motion without build-up whose value at t = 0 differs from the static position of the vessel or line
/// ends.
std::optional<StaticFailure> initial_jump_error(const Model& model) {
  const auto reject = [](const char* what, const std::string& why) {
    return make_input_error("analysis.dynamic.build_up", what, "without build-up " + why);
  };
  const double shoe =
      model.description.has_pipe || finds_vessel_position(model.description) ? initial_shoe_jump(model) : 0.0;
  if (shoe > kMaxInitialJump) {
    return reject(
        "the vessel motion starts with a jump",
        fmt::format("the stern shoe jumps by {} from its static position and loads the suspended lines impulsively; "
                    "give some wave periods",
                    shown_digits(shoe, "m", 3)));
  }
  const double end = initial_line_end_jump(model, dynamic_options(model));
  if (end <= kMaxInitialJump) return std::nullopt;
  return reject("the motion of the line ends starts with a jump",
                fmt::format("an end jumps by {} from its static position and loads its line impulsively; "
                            "give some periods",
                            shown_digits(end, "m", 3)));
}

/// A motion record that is shorter than the run: the vessel would stop abruptly at its end and load the suspended
/// lines.
std::optional<StaticFailure> motion_record_error(const std::string& key, const VesselDescription& vessel,
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
  return make_input_error(key + ".motion.history", "the record of the vessel's motion does not cover the run",
                          std::move(why));
}

/// A motion whose file is missing or too short.
std::optional<StaticFailure> motion_file_error(const std::string& key, const VesselDescription& vessel,
                                               const DynamicOptions& run) {
  if ((vessel.motion == VesselMotion::raos && !vessel.raos) ||
      (vessel.motion == VesselMotion::history && !vessel.history)) {
    return make_input_error(key + ".motion", "the " + key + " motion cannot be used",
                            "the file " + vessel.motion_file + " could not be read");
  }
  return vessel.motion == VesselMotion::history ? motion_record_error(key, vessel, run) : std::nullopt;
}

/// In dynamics the seabed friction follows the motion, and the pulling winch is not among the machines of a run.
std::optional<StaticFailure> unsupported_dragging(const Description& d) {
  if (!is_dragged(d)) return std::nullopt;
  return make_input_error(
      "operation.type", "a pipe dragged along the seabed by a winch is not supported in dynamic analysis",
      "use overbend static for its stages; in dynamics friction would have to follow the motion of the winch");
}

/// A straight wire has no attachment of its own with prescribed motion; a wire with weight on the pipe has no mass yet.
std::optional<StaticFailure> unsupported_wires(const Description& d) {
  const auto heavy = ranges::find_if(d.lines, [](const auto& line) { return !is_weightless(line); });
  if (d.has_pipe && heavy != d.lines.end()) {
    return make_input_error("lines", "a line with weight on the pipe is not supported in dynamic analysis yet",
                            "line '" + heavy->name + "': give it a type without weight");
  }
  const auto on_hull = ranges::find_if(d.lines, [](const FreeLineDescription& line) {
    return line.first.kind == LineEndKind::body || line.second.kind == LineEndKind::body;
  });
  if (d.has_pipe && d.vessel.motion == VesselMotion::coupled && on_hull != d.lines.end()) {
    return make_input_error("lines",
                            "a line between the pipe and a floating hull is not supported in dynamic analysis yet",
                            "line '" + on_hull->name + "': use another vessel.motion, or a fixed end");
  }
  const auto on_other = ranges::find_if(d.lines, [](const FreeLineDescription& line) {
    const auto is_on_other_body = [](const LineEndDescription& end) {
      return end.kind == LineEndKind::body && !is_on_vessel(end);
    };
    return is_on_other_body(line.first) || is_on_other_body(line.second);
  });
  if (d.has_pipe && on_other != d.lines.end()) {
    return make_input_error(
        "lines",
        "a line between the pipe and a body other than the vessel is not supported in dynamic analysis "
        "yet",
        "line '" + on_other->name + "': attach its other end to the vessel or a fixed point");
  }
  if (!d.has_pipe && d.vessel.motion == VesselMotion::coupled && has_linked_lines(d)) {
    return make_input_error(
        "lines", "connected lines and weightless wires on a floating hull are not supported in dynamic analysis yet",
        "give the wires a weight, or the vessel a prescribed motion");
  }
  for (const FreeLineDescription& line : d.lines) {
    const bool linked = d.has_pipe || has_linked_lines(d);
    const bool swings = line.first.period > 0.0 || line.second.period > 0.0;
    if (!linked || !swings || !is_weightless(line) || has_pipe_section(line)) continue;
    return make_input_error("lines", "a weightless wire with a moving end is not supported in dynamic analysis yet",
                            "line '" + line.name + "': give its type a weight, or attach its end to the vessel");
  }
  return std::nullopt;
}

/// A vessel motion that is not defined over the whole run.
std::optional<StaticFailure> motion_error(const Model& model) {
  const Description& d = model.description;
  const VesselDescription& vessel = d.vessel;
  if (finds_vessel_position(d) && d.operation.type == OperationType::pull_ahead && !d.operation.loads.empty()) {
    return make_input_error("operation.loads", "loads of a pull-ahead are not supported in dynamic analysis",
                            "give them under vessel.loads, or omit them in a model with a pipe");
  }
  if (has_mooring_lines(d)) {
    if (std::optional<StaticFailure> reason = unsupported_moorings(d)) return reason;
  }
  if (vessel.motion == VesselMotion::coupled) {
    return floating_hull_error(d);
  }
  if (d.operation.type == OperationType::pull_ahead && d.operation.acceleration_time <= 0.0) {
    return make_input_error("operation.acceleration_time", "the vessel needs time to reach its speed",
                            "an immediate speed loads the pipe impulsively; give some seconds");
  }
  return motion_file_error("vessel", vessel, dynamic_options(model));
}

/// The same for the bodies other than the vessel.
std::optional<StaticFailure> body_motion_error(const Model& model) {
  const std::vector<BodyDescription>& bodies = model.description.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string key = fmt::format("bodies[{}]", i);
    if (std::optional<StaticFailure> reason = motion_file_error(key, bodies[i].hull, dynamic_options(model))) {
      return reason;
    }
  }
  return std::nullopt;
}

/// A group of waves whose file is missing.
std::optional<StaticFailure> wave_file_error(const WaveGroups& groups) {
  for (const WavesDescription& waves : groups) {
    const bool no_spectrum = waves.type == WaveType::user && waves.spectrum.empty();
    const bool no_record = waves.type == WaveType::elevation && waves.record.elevation.empty();
    const bool no_state = !waves.spectrum_file.empty() && waves.type != WaveType::user && waves.hs == 0.0;
    if (!no_spectrum && !no_record && !no_state) continue;
    return make_input_error(
        waves.key + (no_record ? ".elevation_file" : ".spectrum_file"), "the sea cannot be generated",
        "the file " + (no_record ? waves.elevation_file : waves.spectrum_file) + " could not be read");
  }
  return std::nullopt;
}

}  // namespace

StaticFailure missing_dynamic_analysis() {
  return make_input_error("analysis.dynamic", "the model has no dynamic analysis",
                          "give its duration, for example 10800 s");
}

std::optional<StaticFailure> unsupported_in_dynamics(const Model& model) {
  const Description& d = model.description;
  if (d.has_pipe) {
    if (std::optional<StaticFailure> reason = unsupported_in_statics(d)) return reason;
    if (std::optional<StaticFailure> reason = unsupported_dragging(d)) return reason;
  }
  if (std::optional<StaticFailure> reason = unsupported_wires(d)) return reason;
  if (!d.dynamics) return missing_dynamic_analysis();
  if (std::optional<StaticFailure> reason = motion_error(model)) return reason;
  if (std::optional<StaticFailure> reason = body_motion_error(model)) return reason;
  if (std::optional<StaticFailure> reason = wave_file_error(d.environment.waves)) return reason;
  if (std::optional<StaticFailure> reason = initial_jump_error(model)) return reason;
  if (d.tensioner.range_low && d.tensioner.tension &&
      (*d.tensioner.tension < *d.tensioner.range_low || *d.tensioner.tension > *d.tensioner.range_high)) {
    return make_input_error("tensioner.range", "the range does not contain tensioner.tension",
                            "the tensioner would move from the start");
  }
  return std::nullopt;
}

}  // namespace overbend
