/// Far end of a lay. It slides along the bed and turns with a shaped bed, or a cable leads it to an anchor at constant
/// height; its force is an unknown of the equilibrium.
#pragma once

#include <optional>

#include "model/lay_route.h"
#include "system/line_assembly.h"

namespace overbend {

/// True if statics search for the line on which the pipe of this model was laid: lateral friction holds the pipe, and
/// no cable leads its far end to an anchor.
bool lays_steadily(const Model& model);

class FarEnd {
 public:
  /// `model` must outlive this object.
  FarEnd(const Model& model, const LayRoute& route, double distance);

  /// Direction of the force, away from the vessel.
  const Vec3& direction() const { return direction_; }
  const HeldDirections& held() const { return held_; }
  bool lays_steadily() const { return lays_steadily_; }
  /// Direction in which the line is held at a distance along the route; nullopt if it may turn there.
  std::optional<Vec3> held_direction(double distance) const;

  /// Updates the end for a state: on a curved route its directions are those at its place, and a line in steady laying
  /// lies on the route offset through it.
  void update(const LineState& state, LineAssembly& line);
  /// Adds the force to the residual and its derivative to the tangent.
  void add_force(const LineState& state, bool with_tangent, LineAssembly& line);
  /// Derivative of the residual with respect to the force, held directions removed.
  Vec3 column() const;

 private:
  void hold(double distance);
  void turn(const LineState& state, bool with_tangent, LineAssembly& line);

  const SeabedSurface* surface_;
  LayRoute route_;
  bool cable_, lays_steadily_;
  Vec3 direction_ = Vec3::UnitX();
  HeldDirections held_;
};

}  // namespace overbend
