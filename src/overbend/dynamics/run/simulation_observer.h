/// Observers of a simulation: recorders, live pages, controllers.
#pragma once

#include <cstdint>

#include "dynamics/integrator/impact_tracker.h"
#include "mechanics/move_profile.h"
#include "results/dynamic_sink.h"
#include "system/assembly.h"

namespace overbend {

/// Of a vessel that is moved ahead while its tensioner pays out.
struct MoveInstant {
  bool moves = false;           ///< Whether the model has it move at all.
  WayPoint way;                 ///< Of its mean place, as planned.
  Vec3 ahead_W = Vec3::Zero();  ///< That way in W [m].
  double paid_out = 0.0;        ///< By the tensioner since the start [m].
  double joints = 0.0;          ///< Put in above the tensioner, as pipe joints [-].
};

/// One instant. The assembly is evaluated at the state: its contacts, cuts and surroundings belong to it.
struct Instant {
  const SystemState* state = nullptr;
  const Assembly* assembly = nullptr;
  const AttachmentState* tensioner = nullptr;  ///< Of `state`.
  double step = 0.0;                           ///< That led here [s].
  double elevation = 0.0;                      ///< Of the water at the stern shoe's mean place [m].
  double drift = 0.0;                          ///< Of energy, relative.
  MoveInstant move;
  std::size_t pipe_line = 0;  ///< Of the pipe that is laid, where there is one.

  const LineAssembly& pipe_assembly() const { return assembly->line(pipe_line); }
  const LineState& pipe() const { return state->lines[pipe_line]; }
  const std::vector<RollerContact>& contacts() const { return pipe_assembly().contacts().contacts(); }
  const RigidMotion& vessel() const { return assembly->surroundings().bodies[kVessel]; }
  /// At the nodes of the pipe, as Surroundings::water.
  const std::vector<double>& water() const { return assembly->surroundings().water[pipe_line]; }
};

/// References are valid during a call only. Whatever an observer remembers between calls belongs in a checkpoint.
class SimulationObserver {
 public:
  virtual ~SimulationObserver() = default;
  /// Once, when it is added; at the beginning of a run the instant is the static state.
  virtual void begun(const Instant&) {}
  /// After every accepted step.
  virtual void stepped(const Instant&) {}
  /// An impact that ended with the step; before stepped().
  virtual void impact(const EndedImpact&) {}
  /// At every row of output, after stepped(); row 0 is that of t = 0.
  virtual void row(const Instant&, std::int64_t /*number*/) {}
  virtual void save(DynamicCheckpoint&) const {}
  virtual void restore(const DynamicCheckpoint&) {}
};

}  // namespace overbend
