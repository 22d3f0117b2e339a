/// Initial shape, mesh zones and target of a static solution, and the reasons why there are none.
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
  bool shaped = true;  ///< False if the shape was not needed; see starting_point_from_solution.
};

/// Target of the line in the model: tension at the tensioner, or distance of the anchor.
EquilibriumTarget find_target(const Description& description);

/// Tension of the initial shape whose line of pipe.length has its far end at the distance pipe.anchor [N].
double tension_for_anchor(const Model& model, const LayPlane& plane);

/// Horizontal distance of the far end of a line of given length suspended as `shape` [m]; 0 if there is no shape.
double shape_distance(const LayShape& shape, double length);

/// Returns the starting point of a model without an initial solution, or the failure.
StartingPoint starting_point(const Model& model, const LayPlane& plane);

/// Same for a solution on a mesh that fits the model: on a level bed and a straight route, where the initial shape is
/// not needed, it is omitted and the zones are those of the solution's mesh.
StartingPoint starting_point_from_solution(const Model& model, const LayPlane& plane, const StaticSolution& solution);

/// Failure of an initial shape, or the reason why its line may have no equilibrium; nullopt if there is none.
std::optional<StaticFailure> shape_failure(const LayShape& shape);

/// State of the initial shape at the nodes of the system's mesh.
LineState sample_shape(const StaticSystem& system, const LayShape& shape);

/// Length from the tensioner to the last roller in contact with the pipe [m]; from the contacts of the last evaluation.
double support_end(const StaticSystem& system);

/// Roller box that the pipe misses.
struct MissedBox {
  std::string name;
  double off_end = 0.0;  ///< Distance of the pipe beyond the end of its bottom roller [m].
  bool sided = false;    ///< True if it has side rollers, over which the pipe has climbed.
};

/// Returns the first such box from the tensioner in the state evaluated last; nullopt if the pipe lies over all boxes,
/// or so far away that the state is meaningless.
std::optional<MissedBox> find_missed_box(const Model& model, const StaticSystem& system);
/// Number of boxes that the pipe misses in that state.
int count_missed_boxes(const Model& model, const StaticSystem& system);
/// Name of the first box from the tensioner whose bottom rollers are above the pipe although it has not run off their
/// ends: a position that can only be reached through the rollers.
std::optional<std::string> box_above_pipe(const Model& model, const StaticSystem& system, const LineState& state);
/// Describes how far the pipe is off its roller, and whether the box has side rollers.
std::string off_end_message(const MissedBox& left);

/// Returns a failure if the pipe touches none of its supports. Uses the contacts of the last evaluation.
std::optional<StaticFailure> check_supports(const Model& model, const StaticSystem& system);

/// Returns a failure if the line is folded within one element: such a line is only in equilibrium with itself, as a
/// cubic cannot represent the turn. `q`: six per node, from the anchor.
std::optional<StaticFailure> check_folds(const LineMesh& mesh, const std::vector<double>& q);

/// Returns a failure if the pipe lies below its rollers: the search passed through them.
std::optional<StaticFailure> check_above_rollers(const Model& model, const StaticSystem& system,
                                                 const LineState& state);

/// Returns a failure if the mesh would exceed the maximum number of elements, before it is built.
std::optional<StaticFailure> too_many_elements(const Model& model, const MeshZones& zones);

/// Failure of a line that is in equilibrium only with compression at the far end; `min_tension`: top tension at which
/// that begins [N].
StaticFailure compressed_at_seabed(double tension, double min_tension);

/// Failure of a line of `length` [m] that ends before it reaches the seabed.
StaticFailure never_touches(const Model& model, double length);

}  // namespace overbend
