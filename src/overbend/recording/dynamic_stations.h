/// Tension, moment, stress and strain at the nodes of a moving line, every step.
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
  std::vector<double> external_pressure;  ///< Of the water, waves included [Pa].
  std::vector<double> x, y, z;            ///< W [m]

  void resize(std::size_t nodes);
};

/// Constants of the recovery.
class NodeRecovery {
 public:
  NodeRecovery(const Model& model, const Line& line);

  /// From the state that `line` evaluated last, `water` as it was given then. Tension and moment are those of cuts:
  /// what the line above a node exerts on what is below follows from the balance of the element below, inertia and
  /// water included, as in statics. So they are right where the section changes and the strain of neighbouring elements
  /// is not. Where a roller pushes inside an element, the moment under it goes to the nearer node if it is larger
  /// there. The curvature of steel that yields is that of the shape. A cable has tension alone: its moments, stresses
  /// and strain are 0. Nothing is allocated.
  void recover(const LineState& state, const LineAssembly& line, const std::vector<double>& water, NodeValues& values);

  // Of the state recovered last, at every node, W.
  const VectorColumns& moments() const { return bend_; }      ///< Bending moment [N m].
  const VectorColumns& tangents() const { return tangent_; }  ///< Unit.
  const std::vector<int>& sections() const { return section_; }

 private:
  void take_cuts(const LineState& state, const std::vector<double>& cuts, NodeValues& values);
  void find_pressures(const std::vector<double>& water, NodeValues& values) const;
  void linear_curvatures(const SectionRun& run, NodeValues& values) const;
  void shape_curvatures(const LineState& state, NodeValues& values);
  void moments_under_rollers(const LineState& state, const LineAssembly& line, NodeValues& values);
  void lay_straight(const SectionRun& run, NodeValues& values);
  void elastic_stresses(const SectionRun& run, NodeValues& values) const;
  void yielding_stresses(const SectionRun& run, const LineState& state, NodeValues& values) const;
  Vec3 moment_under(const LineState& state, const LineAssembly& line, const RollerContact& contact) const;
  Vec3 shape_bend(const LineState& state, const RollerContact& contact) const;

  const Model* model_;
  const Line* line_;
  RecoverKernel recover_;
  std::vector<int> section_;  ///< Of every node.
  std::vector<SectionRun> runs_;
  VectorColumns bend_, tangent_;
  std::vector<const RollerContact*> carrying_;
};

}  // namespace overbend
