/// The far end of a lay: it slides along the bed, on a shaped one turning with it, or is led to an anchor by a cable at
/// its own height, under a force that is an unknown of the equilibrium.
#pragma once

#include <optional>

#include "model/lay_route.h"
#include "system/line_assembly.h"

namespace overbend {

/// Whether statics look for the line on which this model's pipe was laid: it lies where friction keeps it, and no cable
/// leads its far end to an anchor.
bool lays_steadily(const Model& model);

class FarEnd {
 public:
  /// `model` must outlive this.
  FarEnd(const Model& model, const LayRoute& route, double distance);

  /// Of the force, away from the vessel.
  const Vec3& direction() const { return direction_; }
  const HeldDirections& held() const { return held_; }
  bool lays_steadily() const { return lays_steadily_; }
  /// What the line is held along at a distance along the route; none where it may turn there.
  std::optional<Vec3> held_direction(double distance) const;

  /// Brings the end to a state: on a route that bends its directions are those of the place, and a line that is laid
  /// steadily lies on the route through it.
  void follow(const LineState& state, LineAssembly& line);
  /// Adds the force to the residual, with its derivative to the tangent.
  void add_force(const LineState& state, bool with_tangent, LineAssembly& line);
  /// How the residual changes with the force, held directions removed.
  Vec3 column() const;

 private:
  void hold(double distance);
  void turn(const LineState& state, bool with_tangent, LineAssembly& line);

  const BedSurface* surface_;
  LayRoute route_;
  bool cable_, lays_steadily_;
  Vec3 direction_ = Vec3::UnitX();
  HeldDirections held_;
};

}  // namespace overbend
