#include "statics/equations/far_end.h"

#include <cmath>

#include "mechanics/ground.h"
#include "model/lay_stage.h"

namespace overbend {

bool lays_steadily(const Model& model) {
  const Description& d = model.description;
  return d.statics.laying == SeabedLayHistory::steady && model.seabed.friction_lateral > 0.0 &&
         model.seabed.stiffness > 0.0 && !cable_at_far_end(d);
}

FarEnd::FarEnd(const Model& model, const LayRoute& route, double distance)
    : surface_(&model.seabed.surface),
      route_(route),
      cable_(cable_at_far_end(model.description)),
      lays_steadily_(overbend::lays_steadily(model)) {
  hold(distance);
}

std::optional<Vec3> FarEnd::held_direction(double distance) const {
  if (cable_ || surface_->shape() != nullptr) return std::nullopt;
  return surface_->along(route_.place(distance), route_.direction(distance));
}

/// Sets the held directions: across the route and, if the end lies on the bed, in the bed's direction.
void FarEnd::hold(double distance) {
  const Vec3 port = route_.port(distance);
  if (cable_) {
    direction_ = route_.direction(distance);
    held_ = {{{port, Vec3::UnitZ(), Vec3::Zero()}, 2}, {}};
    return;
  }
  direction_ = surface_->along(route_.place(distance), route_.direction(distance));
  held_ = {{{port, Vec3::Zero(), Vec3::Zero()}, 1}, {}};
  if (const auto along = held_direction(distance)) held_.tangent = across(*along);
}

void FarEnd::update(const LineState& state, LineAssembly& line) {
  constexpr double kRounding = 1e-9;  // [m] of positions: no side load moves the pipe by so little
  const Vec3 far = Eigen::Map<const Vec3>(state.q.data());
  if (!route_.straight()) hold(route_.distance(far));
  if (!lays_steadily_) return;
  const double aside = route_.offset(far);
  line.set_lateral_offset(std::abs(aside) > kRounding ? aside : 0.0);
}

void FarEnd::add_force(const LineState& state, bool with_tangent, LineAssembly& line) {
  if (line.environment().bed_shape != nullptr && !cable_) turn(state, with_tangent, line);
  for (int i = 0; i < 3; ++i) line.residual()[static_cast<std::size_t>(i)] -= state.far_force * direction_(i);
}

/// Keeps the force tangential to the bed at the end's place.
void FarEnd::turn(const LineState& state, bool with_tangent, LineAssembly& line) {
  const GroundPoint ground = ground_at(line.environment(), Eigen::Map<const Vec3>(state.q.data()));
  direction_ = ground.along_route;
  if (!with_tangent) return;
  const Mat3 turned = along_route_turn(ground);
  double* const diag = line.tangent().diag(0);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) diag[i * kRowWidth + k] -= state.far_force * turned(i, k);
  }
}

Vec3 FarEnd::column() const {
  Vec3 column = -direction_;
  for (const Vec3& d : held_.position) column -= column.dot(d) * d;
  return column;
}

}  // namespace overbend
