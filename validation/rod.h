/// A single rod with any ends, loads and rollers, on the engine's element kernel, contact and block solver: for
/// problems that are no lay.
#pragma once

#include <vector>

#include "statics/equations/static_system.h"

namespace overbend::validation {

/// Properties of the rod, constant along its length.
struct RodPipe {
  double EA = 0.0, EI = 0.0;  ///< [N], [N m2]
  double weight = 0.0;        ///< [N/m]
  double radius = 0.01;       ///< Outer [m].
};

/// Unknowns of a node.
enum Dof { kRx, kRy, kRz, kTx, kTy, kTz };

class Rod {
 public:
  /// A straight rod from `start` in the unit vector `direction`, in elements of the given lengths.
  Rod(const RodPipe& pipe, const std::vector<double>& lengths, const Vec3& start, const Vec3& direction);

  LineState state;                    ///< Positions and tangents.
  LineEnvironment surrounds;          ///< No water, no bed unless set.
  std::vector<double> dead;           ///< Dead loads by unknown [N], [N m].
  Vec3 end_moment = Vec3::Zero();     ///< On the last node, follows no direction [N m].
  std::vector<PlacedRoller> rollers;  ///< Act on the whole rod.

  int nodes() const { return static_cast<int>(lengths_.size()) + 1; }
  double s(int node) const;
  Vec3 position(int node) const;
  Vec3 tangent(int node) const;
  void hold(int node, Dof dof) { held_[static_cast<std::size_t>(6 * node + dof)] = 1; }
  /// Holds position and tangent.
  void clamp(int node);
  /// Leaves the plane y = 0 out.
  void hold_in_plane();

  /// Newton's method to the loads set, from the present state: full steps, limited in length, until a step no longer
  /// turns anything or the residual is 1e-12 of the largest force. Throws std::runtime_error where it does not settle.
  void settle();

  /// Force on the node by what holds it [N]; moments in the tangent's unknowns.
  Vec3 reaction(int node);
  /// Bending moment vector at an end of an element, by the balance of the element [N m].
  Vec3 moment_at(int node) const;
  double roller_force(std::size_t roller) const { return contacts_[roller].normal; }
  double roller_gap(std::size_t roller) const { return -contacts_[roller].penetration; }
  /// Moment where a roller pushes.
  Vec3 moment_at_roller(std::size_t roller) const;

 private:
  void evaluate(bool with_tangent);
  void add_rollers(bool with_tangent);
  void add_end_moment();
  ElementVector element_residual(int element) const;

  RodPipe pipe_;
  std::vector<double> lengths_;
  LineElements elements_;
  std::vector<char> held_;
  std::vector<double> residual_;
  BlockTridiagonal tangent_;
  std::vector<RollerContact> contacts_;
};

/// `count` elements of equal length.
std::vector<double> equal_lengths(double length, int count);

}  // namespace overbend::validation
