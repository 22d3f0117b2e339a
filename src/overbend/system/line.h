/// A line: what stands still of it.
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

/// Of a pipe: at the anchor, at the tensioner. `inner`: a node between them.
enum class LineEnd { first, last, inner };

/// What a line is to the analysis.
enum class LineRole {
  pipe,     ///< Laid by a tensioner, over rollers.
  mooring,  ///< Holds the vessel.
  free      ///< Stands by itself between two ends.
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
  std::vector<LineWire> wires;                           ///< That hold it between its ends.
  bool on_rollers = true;                                ///< Whether it may meet the rollers of bodies.
  std::shared_ptr<const std::vector<RoutePiece>> route;  ///< What `environment` points to, of a route that bends.
  double force_scale = 1.0;  ///< What unbalanced forces are measured against: the weight in air [N].
};

/// The pipe of a model on a mesh, its levels of yielding not chosen yet. Points into `model`, which must outlive the
/// line.
Line pipe_line(const Model& model, LineMesh mesh, const LayRoute& route);

/// Place of an end of a line as drawn, W: of a body with the vessel at its mean pose, on the bed its height there.
Vec3 end_place(const Model& model, const LineEndDescription& end);

/// Weight in air of the elements at or beyond arc length `from` [N].
double weight_from(const LineMesh& mesh, const LineElements& elements, double from);

}  // namespace overbend
