/// Static results of connected lines: pipe, the wires attached to it, and the weld between two of them. SI; frame W,
/// arc lengths from a line's first end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace overbend {

/// A position along a line.
struct LinePlace {
  double arc_length = 0.0;
  Vec3 place = Vec3::Zero();
  double inclination = 0.0;  ///< Inclination of the axis towards the second end, positive downwards [rad].
};

/// A bending moment and its position; in the vertical plane sagging is positive [N m].
struct MomentPlace {
  double value = 0.0;
  LinePlace location;
};

/// A stretch in contact with the seabed [m].
struct BedStretch {
  double from = 0.0, to = 0.0;
};

/// An end of a line.
struct LiftedEnd {
  bool free = false;
  LinePlace location;
  double tension = 0.0;           ///< Effective [N].
  double horizontal_force = 0.0;  ///< Outward horizontal force on the end [N].
  double vertical_force = 0.0;    ///< Upward vertical force on the end [N].
};

/// A node of a line with bending stiffness. If the tension jumps (attachments, clumps, buoys) or the section changes,
/// two nodes have the same position: the side of the first end, then that of the second.
struct LiftedNode {
  LinePlace location;
  int segment = 0;                          ///< Number of the segment on this side, from 0.
  double tension = 0.0;                     ///< Effective [N].
  double shear = 0.0;                       ///< Force of the second side on the first, normal to the axis, up [N].
  double sagging = 0.0, sideways = 0.0;     ///< Bending moments [N m].
  double stress = 0.0, yield_stress = 0.0;  ///< Bending stress and yield stress of the steel; 0 without steel [Pa].
  double von_mises = 0.0;                   ///< Maximum over the section [Pa].
  double strain = 0.0;                      ///< Maximum magnitude of the longitudinal strain at the outer fibre [-].
};

/// A line that contains pipe.
struct LiftedLine {
  std::string name;
  LiftedEnd first, second;
  MomentPlace sagging, hogging, bending;         ///< Maxima; `hogging` is positive, `bending` a magnitude.
  double bending_stress = 0.0, von_mises = 0.0;  ///< Maxima [Pa].
  double max_tension = 0.0, min_tension = 0.0;   ///< Effective [N].
  std::vector<BedStretch> on_bed;
  std::optional<LinePlace> lift_off;    ///< Lift-off from the seabed nearest to a free end, else to the first end.
  double suspended_length = 0.0;        ///< Length without seabed contact [m].
  std::vector<double> water_crossings;  ///< Arc lengths at which the axis crosses the water surface [m].
  std::vector<LiftedNode> nodes;
};

/// A line attached to another: its forces and the state of that line at the attachment.
struct LiftedWire {
  std::string name, on;                                         ///< Name of the line, and name of the line that it is
                                                                ///< attached to.
  double length = 0.0;                                          ///< Unstressed [m].
  double tension_upper = 0.0, tension_lower = 0.0;              ///< [N]
  Vec3 force = Vec3::Zero();                                    ///< On the line that it is attached to [N].
  double from_vertical_upper = 0.0, from_vertical_lower = 0.0;  ///< [rad]
  std::optional<double> utilisation;                            ///< Upper tension over breaking load.
  LinePlace location;                                           ///< Position on that line.
  double moment = 0.0;                                          ///< Moment of that line at the attachment, sagging
                                                                ///< positive [N m].
  double tension_before = 0.0, tension_after = 0.0;  ///< Effective tension of that line, on the sides of its first and
                                                     ///< second end [N].
  double shear_before = 0.0, shear_after = 0.0;      ///< [N]
};

/// Offset of two ends that are to be joined: second minus first.
struct WeldGap {
  double dx = 0.0, dy = 0.0, dz = 0.0;  ///< [m]
  double angle = 0.0;                   ///< Change of direction, positive for sagging [rad].
};

/// Force of the second line on the first.
struct Weld {
  LinePlace location;
  double tension = 0.0, shear = 0.0, moment = 0.0;  ///< Axial and normal (up) to the first line's axis; moment positive
                                                    ///< for sagging [N], [N m].
};

struct LiftResults {
  std::vector<LiftedLine> lines;
  std::vector<LiftedWire> davits;
  std::optional<WeldGap> gap;
  std::optional<Weld> join;
  double residual = 0.0;
  int iterations = 0;
};

}  // namespace overbend
