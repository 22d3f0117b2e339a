/// Static results of pipe as a line: nodes with stresses, ends, stretches on the bed.
#pragma once

#include "results/lift_results.h"
#include "statics/solver/lines_setup.h"
#include "system/assembly.h"

namespace overbend {

/// Solved line: its unknowns, six per node, and the assembly evaluated at them.
struct SolvedLine {
  const LineAssembly& assembly;
  const std::vector<double>& q;

  const Line& line() const { return assembly.line(); }
  Vec3 place(std::size_t node) const;
  Vec3 tangent(std::size_t node) const;  ///< Unit vector.
  LinePlace at_node(std::size_t node) const;
  LinePlace at_arc(double s) const;
};

/// All lines of a model in equilibrium; `assembly` is evaluated at `state`.
struct SolvedLines {
  const Model& model;
  const LinesSetup& setup;
  const Assembly& assembly;
  const SystemState& state;

  /// `number`: index of the line in the model; must not be a wire.
  SolvedLine line(std::size_t number) const;
};

/// True if an end of a line of the system is held; a weld holds a formerly free end.
bool is_held(const System& system, int line, LineEnd which);

/// Forces and moments at a node. `force`: force of the part towards the second end on the part towards the first, on
/// one side of attachments at the node [N].
LiftedNode lifted_node(const SolvedLine& line, std::size_t node, const Vec3& force);

/// Results of the lines that contain pipe, in the order of the model.
std::vector<LiftedLine> recover_pipe_lines(const SolvedLines& lines);

}  // namespace overbend
