/// Constant data of a line.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mechanics/line_elements.h"
#include "system/line_mesh.h"
#include "system/line_points.h"
#include "system/wire.h"
#include "system/yielding.h"

namespace overbend {

/// First and last node: of a pipe at the anchor and at the tensioner. `inner`: a node between them.
enum class LineEnd { first, last, inner };

/// Function of a line in the analysis.
enum class LineRole {
  pipe,     ///< Laid by a tensioner, over rollers.
  mooring,  ///< Holds the vessel.
  free      ///< Between two ends of its own.
};

/// Constant data of one line.
struct Line {
  std::string name;
  LineRole role = LineRole::free;
  LineMesh mesh;
  LineElements elements;
  LineEnvironment environment;
  YieldingElements yielding;
  std::vector<LinePoint> points;                         ///< Clumps and buoys.
  std::vector<LineWire> wires;                           ///< Wires that hold it between its ends.
  bool on_rollers = true;                                ///< True if it may touch the rollers of bodies.
  std::shared_ptr<const std::vector<RoutePiece>> route;  ///< Referenced by `environment` for a route with bends.
  double force_scale = 1.0;                              ///< Reference for residual forces: the weight in air [N].
};

/// Returns the pipe of a model on a mesh, without levels of yielding. Points into `model`, which must outlive the line.
Line pipe_line(const Model& model, LineMesh mesh, const LayRoute& route);

/// Returns the nominal position of a line end, W: on a body with the vessel at its mean pose, on the seabed at its
/// height there.
Vec3 end_place(const Model& model, const LineEndDescription& end);

/// Returns the weight in air of the elements at or beyond arc length `from` [N].
double weight_from(const LineMesh& mesh, const LineElements& elements, double from);

}  // namespace overbend
