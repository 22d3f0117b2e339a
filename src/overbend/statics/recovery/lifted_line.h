/// What a line that is pipe does at rest: nodes with their stresses, ends, stretches on the bed.
#pragma once

#include "results/lift_results.h"
#include "statics/solver/lines_setup.h"
#include "system/assembly.h"

namespace overbend {

/// A line as it is solved: its unknowns, six per node, and the assembly evaluated at them.
struct SolvedLine {
  const LineAssembly& assembly;
  const std::vector<double>& q;

  const Line& line() const { return assembly.line(); }
  Vec3 place(std::size_t node) const;
  Vec3 tangent(std::size_t node) const;  ///< Unit vector.
  LinePlace at_node(std::size_t node) const;
  LinePlace at_arc(double s) const;
};

/// All lines of a model at rest; `assembly` is evaluated at `state`.
struct SolvedLines {
  const Model& model;
  const LinesSetup& setup;
  const Assembly& assembly;
  const SystemState& state;

  /// By the number of the line in the model; it must not be a wire.
  SolvedLine line(std::size_t number) const;
};

/// Whether anything holds an end of a line of the system; a weld holds one that was free.
bool is_held(const System& system, int line, LineEnd which);

/// Forces and moments at a node; `force` is that of the part towards the second end on the part towards the first, on
/// one side of what pulls at the node [N].
LiftedNode lifted_node(const SolvedLine& line, std::size_t node, const Vec3& force);

/// The lines that have pipe in them, in the order of the model.
std::vector<LiftedLine> recover_pipe_lines(const SolvedLines& lines);

}  // namespace overbend
