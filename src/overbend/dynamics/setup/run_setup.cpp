#include "dynamics/setup/run_setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/integrator/dynamic_clock.h"
#include "dynamics/integrator/water_field.h"
#include "dynamics/setup/floating_initial_state.h"
#include "dynamics/setup/initial_seabed_friction.h"
#include "dynamics/setup/laid_tail.h"
#include "dynamics/setup/quasi_static_lines.h"
#include "dynamics/setup/stinger_setup.h"
#include "dynamics/setup/winch_programs.h"
#include "model/bodies.h"
#include "moorings/equilibrium.h"
#include "statics/solver/lines_setup.h"

namespace overbend {
namespace {

bool is_quasi_static(const Description& d) {
  return d.moorings && d.moorings->model == MooringModel::quasi_static;
}

void add_moorings(const Model& model, const StaticSolution& start, RunSetup& setup) {
  if (!start.moorings) return;
  setup.mooring_names = mooring_names(*start.moorings);
  if (is_quasi_static(model.description)) return;
  setup.moorings = add_mooring_lines(model, *start.moorings, setup.system);
  set_winch_programs(*start.moorings, winch_programs(start), setup.system);
}

/// Adds wires on the laid pipe.
void add_followed_wires(const System& system, RunSetup& setup) {
  const std::optional<LaidPipe> pipe = find_laid_pipe(system);
  if (!pipe) return;
  const std::vector<LineWire>& wires = system.lines[pipe->line].wires;
  for (std::size_t i = 0; i < wires.size(); ++i) {
    setup.lines.push_back({wires[i].wire.name, static_cast<int>(pipe->line), static_cast<int>(i), wires[i].reversed});
  }
}

/// Adds the bodies other than the vessel after the existing ones.
void add_bodies(const Model& model, RunSetup& setup) {
  setup.first_body = setup.system.bodies.size();
  for (const BodyDescription& body : model.description.bodies) {
    setup.bodies.push_back(make_body_motion(body.hull, body_pose(body), setup.sea));
    setup.system.bodies.emplace_back();
  }
}

/// Adds lines between fixed points and bodies, or on each other, in their equilibrium.
void add_lines(const Model& model, const StaticSolution& start, RunSetup& setup) {
  add_followed_wires(setup.system, setup);
  if (!start.lines) return;
  const LinesSetup& resting = start.lines->setup;
  System& system = setup.system;
  const int first = static_cast<int>(system.lines.size());
  const int shift = static_cast<int>(setup.first_body) - 1;  // offset of the bodies other than the vessel
  const auto moved_on = [shift](int& body) { body += body > static_cast<int>(kVessel) ? shift : 0; };
  setup.swings = end_swings(model.description.lines, resting.lines, system.attachments.size());
  for (Attachment end : resting.system.attachments) {
    end.line += first;
    moved_on(end.body);
    system.attachments.push_back(end);
  }
  system.lines.insert(system.lines.end(), resting.system.lines.begin(), resting.system.lines.end());
  const auto points = resting.system.bodies.begin() + 1 + static_cast<std::ptrdiff_t>(setup.bodies.size());
  system.bodies.insert(system.bodies.end(), points, resting.system.bodies.end());
  for (Wire wire : resting.system.wires) {
    moved_on(wire.first_body);
    moved_on(wire.second_body);
    system.wires.push_back(wire);
  }
  for (std::size_t i = 0; i < resting.lines.size(); ++i) {
    const int line = resting.lines[i] < 0 ? -1 : first + resting.lines[i];
    setup.lines.push_back({model.description.lines[i].name, line, resting.wires[i]});
  }
}

/// Force scale of a hull: from its pipe, else from the lines that hold it, else from its station keeping.
double hull_force_scale(const Description& d, const StaticSolution& start, const RunSetup& setup) {
  if (const std::optional<LaidPipe> pipe = find_laid_pipe(setup.system)) {
    return setup.system.lines[pipe->line].force_scale;
  }
  if (start.moorings) return force_scale(*start.moorings, d.station_keeping);
  double scale = 0.0;
  for (const Line& line : setup.system.lines) scale = std::max(scale, line.force_scale);
  return scale;
}

/// Adds the vessel's motion: prescribed, or that of a floating hull.
void add_motion(const Model& model, const StaticSolution& start, const DynamicOptions& options, RunSetup& setup) {
  const Description& d = model.description;
  if (d.vessel.motion != VesselMotion::coupled) {
    setup.motion = make_vessel_motion(model, setup.sea);
    if (d.vessel.motion == VesselMotion::raos) setup.wave_numbers_ahead = wave_numbers_ahead(setup.motion, setup.sea);
    return;
  }
  setup.hull = std::make_unique<MadeHull>(make_hull(model, setup.sea, options.build_up, start.station_stiffness));
  setup.hull->hull.mean_drift_from_start = d.statics.mean_drift.value_or(true);
  setup.ballast = d.vessel.coupled->ballast;
  FreeBody& body = setup.system.bodies[kVessel].free.emplace(
      free_hull(setup.hull->hull, hull_force_scale(d, start, setup), d.vessel.length));
  if (start.moorings && is_quasi_static(d)) {
    body.springs = quasi_static_lines(*start.moorings, winch_programs(start));
  }
}

void add_move(const Model& model, const StaticSolution& start, RunSetup& setup) {
  const Description& d = model.description;
  if (d.operation.type != OperationType::pull_ahead) return;
  setup.move = start.winches ? start.winches->profile : move_profile(d.operation, 0.0);
  const std::optional<JointDescription>& joint = d.pipe.section.joint;
  setup.joint = joint ? joint->length : std::abs(d.operation.distance);
  if (setup.hull && setup.hull->hull.station_keeping) {
    StationKeeping& keeping = *setup.hull->hull.station_keeping;
    keeping.move = setup.move;
    keeping.ahead_W = level_ahead(model.nominal_pose).head<2>();
  }
  if (const std::optional<LaidPipe> pipe = find_laid_pipe(setup.system)) {  // a track tensioner feeds without limit
    setup.system.attachments[pipe->tensioner].tensioner->limit = std::numeric_limits<double>::infinity();
  }
}

}  // namespace

RunSetup make_setup(const Model& model, const StaticSolution& start, double static_tension,
                    const DynamicOptions& options) {
  RunSetup setup;
  const Description& d = model.description;
  setup.sea = make_sea(d.environment.waves, d.environment.water_depth, options.seed);
  setup.water_place = d.has_pipe ? point_from_ramp(model, model.mean_pose, Vec3::Zero()) : model.mean_pose.p_WV;
  if (d.has_pipe) {
    setup.system = pipe_system(model, start, static_tension);
    setup.rollers = setup.system.bodies[kVessel].rollers;
    add_hinged_stinger(model, setup.sea, options.build_up, setup.system);
  } else {
    setup.system.bodies.emplace_back();  // the vessel
  }
  add_moorings(model, start, setup);
  add_bodies(model, setup);
  add_lines(model, start, setup);
  add_motion(model, start, options, setup);
  add_move(model, start, setup);
  setup.system.build_up = options.build_up;
  setup.interval = water_interval(setup.sea, options.output_step);
  return setup;
}

RunStart make_run_start(const Model& model, const StaticSolution& start, double top_tension,
                        const DynamicOptions& options) {
  const StaticSolution longer = with_laid_tail(model, start, top_tension, options.tail_reach);
  RunSetup setup = make_setup(model, longer, top_tension, options);
  SystemState state = state_at_start(setup, longer, make_clock(options, setup.interval).time());
  return {std::move(setup), std::move(state)};
}

void set_prescribed_motions(const RunSetup& setup, double time, Surroundings& surroundings) {
  if (!setup.hull) {
    const MoveAhead ahead{setup.move ? setup.move->at(time) : MoveState{}, setup.wave_numbers_ahead};
    surroundings.bodies[kVessel] = vessel_motion(setup.motion, ahead, time, half_cosine(time, setup.system.build_up));
  }
  for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
    surroundings.bodies[setup.first_body + i] =
        vessel_motion(setup.bodies[i], time, half_cosine(time, setup.system.build_up));
  }
  set_attachment_motions(setup.system, surroundings);
  swing_ends(setup.swings, time, setup.system.build_up, surroundings.ends);
}

SystemState state_at_start(const RunSetup& setup, const StaticSolution& start, double time) {
  const System& system = setup.system;
  LineShapes shapes;
  const std::optional<LaidPipe> pipe = find_laid_pipe(system);
  if (pipe) shapes.push_back(start.state.q);
  shapes.insert(shapes.end(), setup.moorings.begin(), setup.moorings.end());
  const std::size_t first_line = shapes.size();
  const std::size_t count = start.lines ? start.lines->state.lines.size() : 0;
  for (std::size_t i = 0; i < count; ++i) shapes.push_back(start.lines->state.lines[i].q);
  SystemState state = state_at_rest(system, shapes, time);
  if (pipe) set_initial_memories(system.lines[pipe->line], start, state.lines[pipe->line]);
  for (std::size_t i = 0; i < count; ++i) {
    LineState& line = state.lines[first_line + i];
    if (start.lines->rest.lies_in_bow[i]) {
      line.bed_slip = start.lines->state.lines[i].bed_slip;
    } else {
      set_initial_seabed_friction(system.lines[first_line + i], line);
    }
  }
  return state;
}

std::optional<StaticFailure> solve_initial_equilibrium(RunSetup& setup, const Vec6& release, SystemState& state) {
  System& system = setup.system;
  if (setup.hull) {
    std::optional<StaticFailure> failure = release_hull(system, setup.ballast, setup.hull->hull, release, state);
    for (const std::size_t tensioner : find_tensioners(system)) {
      MotionValues& travel = state.attachments[tensioner].travel;
      Attachment& top = system.attachments[tensioner];
      top.place -= travel.q * top.direction;
      travel = {};
    }
    return failure;
  }
  if (setup.moorings.empty()) return std::nullopt;
  Assembly assembly(system);
  assembly.set_time(state.time, state);
  return solve_mooring_lines(system, assembly.surroundings().bodies, state);
}

}  // namespace overbend
