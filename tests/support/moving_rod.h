/// A single rod in motion, with any ends, rollers and surroundings: for problems in time that are no lay.
#pragma once

#include <fmt/core.h>

#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "dynamics/integrator/time_step.h"
#include "system/assembly.h"

namespace overbend::testing {

/// Properties of the rod, one for its whole length. Dry and weightless unless said.
struct RodMaterial {
  double EA = 0.0, EI = 0.0;                        ///< [N], [N m2]
  double mass = 0.0;                                ///< [kg/m]
  double weight = 0.0, buoyancy = 0.0;              ///< [N/m]
  double radius = 0.01;                             ///< Outer [m].
  double drag_normal = 0.0;                         ///< rho/2 Cd D [kg/m2]
  double displaced_mass = 0.0, added_normal = 0.0;  ///< [kg/m]
};

inline Line& first_rod(System& system) {
  return system.lines.front();
}
inline const Line& first_rod(const System& system) {
  return system.lines.front();
}
inline Attachment& first_end(System& system) {
  return system.attachments[0];
}
inline Attachment& last_end(System& system) {
  return system.attachments[1];
}
inline void hold(Attachment& end, bool place, bool direction) {
  end.hold_place = place;
  end.hold_direction = direction;
}
inline void hold_ends(System& system, bool place, bool direction) {
  hold(first_end(system), place, direction);
  hold(last_end(system), place, direction);
}

/// `count` elements of equal length, free at both ends, a body without rollers, nothing around.
inline System rod_system(const RodMaterial& material, double length, int count) {
  System system;
  system.bodies.resize(1);
  system.attachments.resize(2);
  last_end(system).end = LineEnd::last;
  system.lines.resize(1);
  Line& line = first_rod(system);
  const double h = length / count;
  line.mesh.s.push_back(0.0);
  for (int i = 1; i <= count; ++i) {
    line.mesh.s.push_back(i * h);
    line.mesh.length.push_back(h);
    line.mesh.section.push_back(0);
  }
  LineElements& e = line.elements;
  e.count = count;
  const std::size_t padded = (static_cast<std::size_t>(count) + kLanes - 1) / kLanes * kLanes;
  const auto fill = [&](AlignedDoubles& values, double value, double beyond) {
    values.assign(padded, beyond);
    std::fill_n(values.begin(), count, value);
  };
  fill(e.length, h, 1.0);
  fill(e.radius, material.radius, 1.0);
  fill(e.compression, 1.0, 1.0);
  fill(e.damping, 0.0, 0.0);
  const std::pair<AlignedDoubles*, double> constants[] = {{&e.EA, material.EA},
                                                          {&e.EI, material.EI},
                                                          {&e.weight, material.weight},
                                                          {&e.buoyancy, material.buoyancy},
                                                          {&e.drag_normal, material.drag_normal},
                                                          {&e.drag_axial, 0.0},
                                                          {&e.pressure_constant, 0.0},
                                                          {&e.pressure_slope, 0.0},
                                                          {&e.pressure_external, 0.0},
                                                          {&e.mass, material.mass},
                                                          {&e.displaced_mass, material.displaced_mass},
                                                          {&e.added_normal, material.added_normal},
                                                          {&e.added_axial, 0.0},
                                                          {&e.drag_on_bed, 0.0}};
  for (const auto& [values, value] : constants) {
    fill(*values, value, 0.0);
  }
  system.surroundings = [](double, Surroundings&) {};
  return system;
}

/// A cell that leaves nothing out, so that every roller is looked for along the whole rod.
inline ContactCells endless_cells() {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  return {{-kFar, kFar, kFar}, {{-kFar, kFar, kFar}}};
}

/// A roller across x, its axis along y, under a rod of `pipe_radius` at z = 0 which it just touches at `x`.
inline BodyRoller roller_under(double x, double pipe_radius, const ContactLaw& law) {
  BodyRoller roller;
  roller.radius = 0.1;
  roller.half_face = 5.0;
  roller.center_V = Vec3(x, 0.0, -pipe_radius - roller.radius);
  roller.law = law;
  return roller;
}

/// Unknowns of a straight rod from `start` in a unit vector, evenly stretched.
inline std::vector<double> straight(const System& system, const Vec3& start, const Vec3& direction,
                                    double stretch = 0.0) {
  std::vector<double> q;
  for (const double s : first_rod(system).mesh.s) {
    const Vec3 r = start + (1.0 + stretch) * s * direction;
    const Vec3 t = (1.0 + stretch) * direction;
    q.insert(q.end(), {r.x(), r.y(), r.z(), t.x(), t.y(), t.z()});
  }
  return q;
}

inline Vec3 place(const std::vector<double>& values, int node) {
  return Eigen::Map<const Vec3>(values.data() + 6 * node);
}

/// Adds a velocity to every node: a rigid translation.
inline void push(SystemState& state, const Vec3& velocity) {
  std::vector<double>& v = state.lines.front().v;
  for (std::size_t i = 0; i < v.size(); i += 6) {
    for (std::size_t k = 0; k < 3; ++k) {
      v[i + k] += velocity(static_cast<int>(k));
    }
  }
}

inline double stored(const InstantEnergy& e) {
  return e.line.kinetic + e.line.strain + e.line.gravity + e.line.seabed + e.contact;
}

/// The rod with its integrator. Set `state`, call `begin`, then `step` or `run`.
class MovingRod {
 public:
  MovingRod(System system, const std::vector<double>& q, const StepSettings& settings = {})
      : system_(std::move(system)),
        assembly_(system_),
        stepper_(assembly_, settings),
        state(state_at_rest(system_, {q}, 0.0)) {
    next_ = state;
  }
  MovingRod(const MovingRod&) = delete;
  MovingRod& operator=(const MovingRod&) = delete;

  Assembly& assembly() { return assembly_; }
  const std::vector<RollerContact>& contacts() const { return assembly_.line(0).contacts().contacts(); }
  LineState& line_now() { return state.lines.front(); }
  const LineState& line_now() const { return state.lines.front(); }
  int last() const { return first_rod(system_).mesh.nodes() - 1; }
  Vec3 r(int node) const { return place(line_now().q, node); }
  Vec3 v(int node) const { return place(line_now().v, node); }
  InstantEnergy energy() const { return assembly_.energy(state); }

  /// Accelerations of the state set, true and algorithmic.
  void begin() {
    assembly_.set_time(state.time, state);
    if (!assembly_.find_accelerations(state)) {
      throw std::runtime_error("the mass is singular");
    }
    line_now().algorithmic_acceleration = line_now().acc;
    for (AttachmentState& end : state.attachments) {
      end.guide.algorithmic_acceleration = end.guide.acc;
    }
  }

  void step(double h) {
    const StepReport report = stepper_.step(state, h, next_);
    if (!report.converged()) {
      throw std::runtime_error(fmt::format("no balance after {} s: residual {}", state.time, report.residual));
    }
    std::swap(state, next_);
  }

  /// `count` steps; `after` sees every state.
  template <class After>
  void run(double h, int count, const After& after) {
    for (int i = 0; i < count; ++i) {
      step(h);
      after();
    }
  }
  void run(double h, int count) {
    run(h, count, [] {});
  }

 private:
  System system_;
  Assembly assembly_;
  TimeStepper stepper_;
  SystemState next_;

 public:
  SystemState state;
};

}  // namespace overbend::testing
