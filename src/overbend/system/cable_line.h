/// A cable, chain, flexible or pipe as a line of the system: segments with clumps and buoys at nodes, without rollers
/// and yielding. Common to mooring lines and free lines.
#pragma once

#include <optional>
#include <vector>

#include "model/description/line_description.h"
#include "model/model.h"
#include "system/graded_mesh.h"
#include "system/line.h"

namespace overbend {

/// Parts of a cable from its first to its last end. Every segment has a length.
struct CableParts {
  std::vector<LineSegmentDescription> segments;
  std::vector<LinePointDescription> points;
  std::vector<double> attached = {};  ///< Arc lengths at which other lines are attached [m].
  double length() const;              ///< Unstressed length [m].
  bool has_pipe() const;
};

/// Input of the mesh of a cable.
struct CableMesh {
  std::optional<double> touchdown;  ///< Arc length of the touchdown, if any [m].
  std::optional<double> element;    ///< Maximum element length, if given [m].
  /// Minimum length of the last element, unless a segment or point ends within it [m].
  double last = 0.0;
  std::vector<FineStretch> fine = {};  ///< Further zones of short elements, such as the wave zone.
};

/// Returns the node at an arc length for which the mesh was made.
int node_at(const LineMesh& mesh, double s);
/// Returns the element length that resolves the bending of pipe at touchdown: a sixth of the decay length of bending on
/// the seabed, (4 EI / k)^(1/4) (Hetenyi 1946) [m].
double pipe_element(const Model& model, const CableParts& parts);

/// Mesh rule: elements of a twentieth of the length, down to a fortieth within a tenth of the length around touchdown
/// and to the sizes of the fine zones; nodes at ends of segments and at points, each followed by a joint of 1e-5 of the
/// length. Some 20 to 30 elements give tension within 0.01 % and stiffness within 0.05 % of the elastic catenary; more
/// elements give nothing beyond the effect of the seabed stiffness.
LineMesh cable_mesh(const CableParts& parts, const CableMesh& wanted);
/// Returns the zone of short elements around a touchdown, for touchdowns other than `wanted.touchdown`.
FineStretch make_touchdown_stretch(const CableParts& parts, const CableMesh& wanted, double touchdown);

/// Returns the environment of a cable between two points: the model's seabed, water and current. The seabed has the
/// model's stiffness, but the cable sinks in by at most a centimetre. Friction acts along the line from end to end and
/// across it, with the model's elastic friction stiffness, which determines how much of a tension variation reaches the
/// anchor. The axis of the cable, not its underside, is at the height of the seabed, as in a catenary; thinner parts of
/// a line with several thicknesses lie deeper by the difference of their radii. Pipe lies on its underside with the
/// model's seabed stiffness. Points into `model`, which must outlive it.
LineEnvironment cable_environment(const Model& model, const CableParts& parts, const Vec3& from, const Vec3& to);

/// Returns the line along the direction from `from` to `to`. Its force scale is its weight in air, points included.
Line cable_line(const Model& model, const CableParts& parts, const CableMesh& mesh, const Vec3& from, const Vec3& to);

/// Sets the unstressed length of a line [m], in proportion for every element.
void set_length(Line& line, double length);

}  // namespace overbend
