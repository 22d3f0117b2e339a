/// Moving mesh of the pipe: nodes are added at the guide as the tensioner pays out and removed as it hauls in, elements
/// are refined where the pipe reaches zones of fine mesh, and laid pipe is dropped. See docs/theory/conveyor.md.
#pragma once

#include <vector>

#include "dynamics/integrator/dynamics.h"
#include "system/line_resize.h"
#include "system/system.h"

namespace overbend {

/// A piece of pipe above the tensioner, by its initial distance above it [m].
struct PieceAbove {
  int section = 0;
  double from = 0.0, to = 0.0;
};

/// Returns the piece of pipe that continues the pipe's layout above the tensioner: coated pipe and field joints in turn
/// if the model distinguishes them; segments end at the tensioner.
PieceAbove piece_above(const Model& model, double above);

/// Feeds and removes pipe between steps. Lengths are unstressed.
class Conveyor {
 public:
  /// For the pipe of `system` in its initial state. `element`: maximum length of added elements, default: that of the
  /// top element [m]. `model` must outlive this.
  Conveyor(const Model& model, const System& system, std::optional<double> element = {});

  /// True if the tensioner has travelled by an element in either direction.
  bool due(const System& system, const SystemState& state) const;
  /// Adds and removes pipe as due and adapts the mesh. `guide`: its motion at `state`. Assembly and stepper must be
  /// rebuilt afterwards. Allocates.
  void act(System& system, SystemState& state, const EndMotion& guide);

  /// Length added at the guide so far, less the length removed there [m].
  double fed() const { return fed_; }
  /// Tensioner travel that has been converted to elements: together with the present travel the total stretched payout
  /// [m].
  double travelled() const { return travelled_; }
  /// Length dropped at the anchor end [m].
  double dropped() const { return dropped_; }
  /// Returns the planned element length at a distance from the tensioner, from the initial mesh [m].
  double planned(double from_top) const;

  /// Includes the pipe's mesh and the position of its anchor.
  std::vector<double> save(const System& system) const;
  /// Restores the mesh of the pipe of `system`.
  void restore(const std::vector<double>& saved, System& system);

 private:
  ElementKind element_kind(int section) const;
  double next_length() const;
  void feed(System& system, SystemState& state, const EndMotion& guide);
  void haul(System& system, SystemState& state);
  void drop_laid(System& system, SystemState& state);
  void refine(Line& line, LineState& state) const;
  void coarsen(Line& line, LineState& state) const;

  const Model* model_;
  LaidPipe pipe_;
  double element_;
  /// Planned element lengths by the distance of their upper ends from the tensioner [m].
  std::vector<double> plan_from_, plan_length_;
  double fine_until_ = 0.0;  ///< Distance from the tensioner beyond which elements may be merged [m].
  double fed_ = 0.0, travelled_ = 0.0, dropped_ = 0.0;
};

}  // namespace overbend
