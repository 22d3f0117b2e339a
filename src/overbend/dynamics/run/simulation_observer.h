/// Observers of a simulation: recorders, live pages, controllers.
#pragma once

#include <cstdint>

#include "dynamics/integrator/impact_tracker.h"
#include "mechanics/move_profile.h"
#include "results/dynamic_sink.h"
#include "system/assembly.h"

namespace overbend {

/// Progress of a vessel that moves ahead while its tensioner pays out.
struct MoveInstant {
  bool moves = false;           ///< True if the model has the vessel move.
  MoveState planned;            ///< Planned displacement and speed of the mean position.
  Vec3 ahead_W = Vec3::Zero();  ///< Planned displacement in W [m].
  double paid_out = 0.0;        ///< Payout of the tensioner since the start [m].
  double joints = 0.0;          ///< Pipe added above the tensioner, in joints [-].
};

/// One instant. The assembly has been evaluated at the state: contacts, cuts and surroundings belong to it.
struct Instant {
  const SystemState* state = nullptr;
  const Assembly* assembly = nullptr;
  const AttachmentState* tensioner = nullptr;  ///< Part of `state`.
  double step = 0.0;                           ///< Step that led here [s].
  double elevation = 0.0;                      ///< Water elevation at the mean position of the stern shoe [m].
  double drift = 0.0;                          ///< Relative energy drift.
  MoveInstant move;
  std::size_t pipe_line = 0;  ///< Index of the laid pipe, if any.

  const LineAssembly& pipe_assembly() const { return assembly->line(pipe_line); }
  const LineState& pipe() const { return state->lines[pipe_line]; }
  const std::vector<RollerContact>& contacts() const { return pipe_assembly().contacts().contacts(); }
  const RigidMotion& vessel() const { return assembly->surroundings().bodies[kVessel]; }
  /// Waves at the nodes of the pipe, as in Surroundings::water.
  const std::vector<double>& water() const { return assembly->surroundings().water[pipe_line]; }
};

/// References are valid during a call only. Anything that an observer remembers between calls must be in its
/// checkpoint.
class SimulationObserver {
 public:
  virtual ~SimulationObserver() = default;
  /// Called once when added; at the beginning of a run the instant is the static state.
  virtual void begun(const Instant&) {}
  /// Called after every accepted step.
  virtual void stepped(const Instant&) {}
  /// Called for an impact that ended with the step, before stepped().
  virtual void impact(const EndedImpact&) {}
  /// Called at every output step, after stepped(); row 0 is at t = 0.
  virtual void row(const Instant&, std::int64_t /*number*/) {}
  virtual void save(DynamicCheckpoint&) const {}
  virtual void restore(const DynamicCheckpoint&) {}
};

}  // namespace overbend
