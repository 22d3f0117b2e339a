/// Tension, moment, stress and strain at the nodes of a moving line at every step.
#pragma once

#include <vector>

#include "model/model.h"
#include "recording/node_recovery_kernel.h"
#include "recording/section_runs.h"
#include "recording/vector_columns.h"
#include "system/assembly.h"

namespace overbend {

/// Values at all nodes, one array per quantity.
struct NodeValues {
  std::vector<double> effective_tension, bending_moment, bending_stress, von_mises, strain;
  std::vector<double> vertical_moment;    ///< Sagging positive [N m].
  std::vector<double> curvature;          ///< Magnitude [1/m].
  std::vector<double> external_pressure;  ///< Pressure of the water, including waves [Pa].
  std::vector<double> x, y, z;            ///< W [m]

  void resize(std::size_t nodes);
};

/// Recovers the values at the nodes.
class NodeRecovery {
 public:
  NodeRecovery(const Model& model, const Line& line);

  /// Recovers the values from the state that `line` evaluated last, with the `water` of that evaluation. Tension and
  /// moment are those of cuts: the force of the line above a node follows from the balance of the element below,
  /// including inertia and water, as in statics. They are therefore correct where the section changes, unlike the
  /// strain of neighbouring elements. If a roller acts inside an element, the moment under it is assigned to the nearer
  /// node if it is larger there. The curvature of yielding steel is that of the shape. A cable has tension only: its
  /// moments, stresses and strain are 0. Allocates nothing.
  void recover(const LineState& state, const LineAssembly& line, const std::vector<double>& water, NodeValues& values);

  // Last recovered state, at every node, W.
  const VectorColumns& moments() const { return bend_; }      ///< Bending moment [N m].
  const VectorColumns& tangents() const { return tangent_; }  ///< Unit.
  const std::vector<int>& sections() const { return section_; }

 private:
  void take_cuts(const LineState& state, const std::vector<double>& cuts, NodeValues& values);
  void find_pressures(const std::vector<double>& water, NodeValues& values) const;
  void linear_curvatures(const SectionRun& run, NodeValues& values) const;
  void shape_curvatures(const LineState& state, NodeValues& values);
  void moments_under_rollers(const LineState& state, const LineAssembly& line, NodeValues& values);
  void set_without_bending(const SectionRun& run, NodeValues& values);
  void elastic_stresses(const SectionRun& run, NodeValues& values) const;
  void yielding_stresses(const SectionRun& run, const LineState& state, NodeValues& values) const;
  Vec3 moment_under(const LineState& state, const LineAssembly& line, const RollerContact& contact) const;
  Vec3 shape_bend(const LineState& state, const RollerContact& contact) const;

  const Model* model_;
  const Line* line_;
  RecoverKernel recover_;
  std::vector<int> section_;  ///< Section of every node.
  std::vector<SectionRun> runs_;
  VectorColumns bend_, tangent_;
  std::vector<const RollerContact*> carrying_;
};

}  // namespace overbend
