/// From the model to the first guess of a static solution, and the reasons for which there can be none.
#pragma once

#include <optional>
#include <string>

#include "statics/equations/static_system.h"
#include "statics/initial_shape/lay_shape.h"
#include "statics/solver/statics.h"
#include "system/line_mesh.h"

namespace overbend {

struct StartingPoint {
  LayShape shape;
  MeshZones zones;
  EquilibriumTarget target;
  double tail = 0.0;  ///< Laid length behind touchdown [m].
  std::optional<StaticFailure> failure;
  bool shaped = true;  ///< Whether there is a shape; see point_beside.
};

/// What the model wants of the line: the tension at the tensioner, or else the place of the anchor.
EquilibriumTarget wanted_of(const Description& description);

/// Tension of the guess whose line of pipe.length has its far end at the distance pipe.anchor [N].
double tension_for_anchor(const Model& model, const LayPlane& plane);

/// Horizontal distance of the far end of a line of given length that hangs as `shape` [m]; 0 where there is no shape.
double shape_distance(const LayShape& shape, double length);

StartingPoint starting_point(const Model& model, const LayPlane& plane);

/// The same beside a solution on a mesh that the model fits: where the shape of the guess decides nothing, on a level
/// bed and a straight route, it is left out and the zones are those of the solution's mesh.
StartingPoint point_beside(const Model& model, const LayPlane& plane, const StaticSolution& solution);

/// Why a guess is none, or why its line may have no equilibrium; nothing where it says nothing.
std::optional<StaticFailure> shape_failure(const LayShape& shape);

/// The guess at the nodes of the system's mesh.
LineState sample_shape(const StaticSystem& system, const LayShape& shape);

/// Length from the tensioner to the last roller that the pipe passes [m]; from the contacts of the last evaluation.
double support_end(const StaticSystem& system);

/// A box that the pipe lies beside.
struct BoxLeft {
  std::string name;
  double off_end = 0.0;  ///< Beyond the end of its bottom roller [m].
  bool sided = false;    ///< Whether it has side rollers, over which the pipe has climbed.
};

/// The first, seen from the tensioner, in the state evaluated last; nothing where the pipe lies over all boxes, or
/// so far away that the state means nothing.
std::optional<BoxLeft> first_box_left(const Model& model, const StaticSystem& system);
/// How many boxes it lies beside, in that state.
int boxes_left(const Model& model, const StaticSystem& system);
/// Name of the first box, seen from the tensioner, under whose bottom rollers the pipe lies without having run off
/// their ends: no way leads there but through the rollers.
std::optional<std::string> box_above_pipe(const Model& model, const StaticSystem& system, const LineState& state);
/// How far, and whether something should have held the pipe.
std::string off_end_words(const BoxLeft& left);

/// A pipe that touches none of its supports is not held by them: says so. Uses the contacts of the last evaluation.
std::optional<StaticFailure> check_supports(const Model& model, const StaticSystem& system);

/// A line folded within one element is in balance with itself only: a cubic has no such turn, and no pipe stands so.
/// `q`: six per node, from the anchor.
std::optional<StaticFailure> check_folds(const LineMesh& mesh, const std::vector<double>& q);

/// A pipe below its rollers is no lay on them: the search went through them.
std::optional<StaticFailure> check_above_rollers(const Model& model, const StaticSystem& system,
                                                 const LineState& state);

/// A mesh beyond what is built says so before it is.
std::optional<StaticFailure> too_many_elements(const Model& model, const MeshZones& zones);

/// The line balances only with the far end pushed: `least` is the tension at the top where that begins [N].
StaticFailure compressed_at_seabed(double tension, double least);

StaticFailure never_touches(const Model& model, double length);

}  // namespace overbend
