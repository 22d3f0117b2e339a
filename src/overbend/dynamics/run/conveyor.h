/// The pipe's mesh on the move: nodes put in at the guide as the tensioner pays out, taken out again as it hauls in,
/// refined where pipe comes to where it has to be fine, dropped where it is laid and done with. See
/// docs/theory/conveyor.md.
#pragma once

#include <vector>

#include "dynamics/integrator/dynamics.h"
#include "system/line_resize.h"
#include "system/system.h"

namespace overbend {

/// A piece of pipe above the tensioner, by how far it was above it at the start [m].
struct PieceAbove {
  int section = 0;
  double from = 0.0, to = 0.0;
};

/// Of the pipe's build, carried on: coated pipe and field joints in turn where the model has them apart; segments end
/// at the tensioner.
PieceAbove piece_above(const Model& model, double above);

/// Acts between steps alone. Lengths are unstressed.
class Conveyor {
 public:
  /// For the pipe of `system`, as it is at the start. `element`: the longest that is put in; that at the top where not
  /// given [m]. The model must outlive it.
  Conveyor(const Model& model, const System& system, std::optional<double> element = {});

  /// Whether the machine has travelled by an element either way.
  bool due(const System& system, const SystemState& state) const;
  /// Puts in and takes out what is due and sees to the rest of the mesh. `guide` as it is at the state. Assembly and
  /// stepper have to be made anew. Allocates.
  void act(System& system, SystemState& state, const EndMotion& guide);

  /// Put in at the guide so far, less what was taken out again [m].
  double fed() const { return fed_; }
  /// Travel of the machine that this took over: with its own travel all that was paid out, stretched [m].
  double travelled() const { return travelled_; }
  /// Dropped at the far end [m].
  double dropped() const { return dropped_; }
  /// Size of elements by the distance from the tensioner, as the mesh was at the start [m].
  double planned(double from_top) const;

  /// With the pipe's mesh and the place of its anchor.
  std::vector<double> save(const System& system) const;
  /// Brings the pipe of `system` to the mesh that it had.
  void restore(const std::vector<double>& saved, System& system);

 private:
  ElementKind kind_of(int section) const;
  double next_length() const;
  void feed(System& system, SystemState& state, const EndMotion& guide);
  void haul(System& system, SystemState& state);
  void drop_laid(System& system, SystemState& state);
  void refine(Line& line, LineState& state) const;
  void coarsen(Line& line, LineState& state) const;

  const Model* model_;
  LaidPipe pipe_;
  double element_;
  std::vector<double> plan_from_, plan_length_;  ///< Elements by the distance of their upper ends from the tensioner.
  double fine_until_ = 0.0;  ///< Distance from the tensioner beyond which pipe may be coarsened [m].
  double fed_ = 0.0, travelled_ = 0.0, dropped_ = 0.0;
};

}  // namespace overbend
