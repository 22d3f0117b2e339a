/// Tension, moment, stress and strain at the nodes of a moving line, every step.
#pragma once

#include <vector>

#include "analysis/dynamic_line.h"
#include "model/model.h"

namespace overbend {

/// Values at all nodes, one array per quantity.
struct NodeValues {
  std::vector<double> effective_tension, bending_moment, bending_stress, von_mises, strain;
  std::vector<double> vertical_moment;  ///< Sagging positive [N m].
  std::vector<double> curvature;        ///< Magnitude [1/m].
  std::vector<double> x, y, z;          ///< W [m]

  void resize(std::size_t nodes);
};

/// Constants of the recovery.
class NodeRecovery {
 public:
  NodeRecovery(const Model& model, const DynamicLine& line);

  /// From the state evaluated last. The moment at a node is the mean of those of the cubics on both sides, with the
  /// fixed-end moments of the roller forces inside the elements added: exact for small bending between nodes. Where a
  /// roller pushes inside an element, the moment under it goes to the nearer node if it is larger there. What yielding
  /// takes off comes from the nearest Gauss points. Nothing is allocated.
  void recover(const DynamicState& state, const std::vector<MovingContact>& contacts,
               const std::vector<Vec3>& plastic_moment, NodeValues& values);

  // Of the state recovered last, at every node, W.
  const std::vector<Vec3>& moments() const { return bend_; }      ///< Bending moment [N m].
  const std::vector<Vec3>& tangents() const { return tangent_; }  ///< Unit.
  const std::vector<int>& sections() const { return section_; }

 private:
  void bending_moments(const DynamicState& state, const std::vector<MovingContact>& contacts,
                       const std::vector<Vec3>& plastic_moment, NodeValues& values);

  const Model* model_;
  const DynamicLine* line_;
  std::vector<int> section_;  ///< Of every node.
  std::vector<Vec3> bend_;    ///< EI times the curvature vector at every node, in the end its moment [N m].
  std::vector<Vec3> tangent_;
};

}  // namespace overbend
