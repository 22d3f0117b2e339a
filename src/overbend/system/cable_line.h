/// A cable, chain, flexible or pipe as a line of the system: by its segments, with clumps and buoys at its nodes,
/// without rollers and without yielding. One way for mooring lines and for lines that stand by themselves.
#pragma once

#include <optional>
#include <vector>

#include "model/description/line_description.h"
#include "model/model.h"
#include "system/graded_mesh.h"
#include "system/line.h"

namespace overbend {

/// What a cable consists of, from its first end to its last. Every segment has its length.
struct CableParts {
  std::vector<LineSegmentDescription> segments;
  std::vector<LinePointDescription> points;
  std::vector<double> attached = {};  ///< Arc lengths at which other lines are attached [m].
  double length() const;              ///< Unstressed [m].
  bool has_pipe() const;
};

/// What the mesh of a cable is made for.
struct CableMesh {
  std::optional<double> touchdown;     ///< Arc length at which it leaves the bed, where it does [m].
  std::optional<double> element;       ///< Asked for: all elements at most so long [m].
  double last = 0.0;                   ///< The last element at least so long, if nothing of the line ends there [m].
  std::vector<FineStretch> fine = {};  ///< Where shorter elements are wanted besides, as where waves are felt.
};

/// The node at an arc length that the mesh was made for.
int node_at(const LineMesh& mesh, double s);
/// Element that shows how pipe lays itself on the bed: a sixth of the length over which its bending dies away there,
/// (4 EI / k)^(1/4) (Hetenyi 1946) [m].
double pipe_element(const Model& model, const CableParts& parts);

/// The rule: elements of a twentieth of the length, down to a fortieth within a tenth of the length around touchdown
/// and to what else is wanted; nodes on the ends of segments and at points, a joint of a hundred-thousandth behind
/// each. Some 20 to 30 elements give tension within 0.01 % and stiffness within 0.05 % of the elastic catenary, more of
/// them nothing that the bed's stiffness would not hide.
LineMesh cable_mesh(const CableParts& parts, const CableMesh& wanted);
/// The short elements around a place where a cable leaves the bed, for others than `wanted.touchdown`.
FineStretch stretch_at_touchdown(const CableParts& parts, const CableMesh& wanted, double at);

/// What surrounds a cable between two places: the model's bed, water and current. The bed is as stiff as the model says
/// but never so soft that the cable sinks into it by more than a centimetre. Its friction holds along the line from
/// place to place and across it, by a stick as stiff as the model says of the bed: of that hangs how much of a swing in
/// tension reaches the anchor. The axis of the cable, not its underside, rests at the height of the bed, as in a
/// catenary; thinner parts of one of several thicknesses lie by the difference of their radii deeper. Pipe lies on its
/// underside, and its bed is as stiff as the model says. Points into `model`, which must outlive it.
LineEnvironment cable_environment(const Model& model, const CableParts& parts, const Vec3& from, const Vec3& to);

/// The line, for a course from `from` to `to`. Its force scale is its weight in air with that of its points.
Line cable_line(const Model& model, const CableParts& parts, const CableMesh& mesh, const Vec3& from, const Vec3& to);

/// Gives a line another unstressed length, every element its share of it [m].
void set_length(Line& line, double length);

}  // namespace overbend
