/// What lines that hold each other do at rest: pipe, the wires on it, and the weld between two of them. SI; W, arc
/// lengths from a line's first end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace overbend {

/// A place along a line.
struct LinePlace {
  double arc_length = 0.0;
  Vec3 place = Vec3::Zero();
  double inclination = 0.0;  ///< Of the axis going towards the second end, positive downwards [rad].
};

/// A bending moment; in the vertical plane sagging is positive [N m].
struct MomentPlace {
  double value = 0.0;
  LinePlace at;
};

/// A stretch that the bed bears [m].
struct BedStretch {
  double from = 0.0, to = 0.0;
};

/// An end of a line.
struct LiftedEnd {
  bool free = false;
  LinePlace at;
  double tension = 0.0;           ///< Effective [N].
  double horizontal_force = 0.0;  ///< With which it is pulled outwards [N].
  double vertical_force = 0.0;    ///< With which it is held up [N].
};

/// A line that bends: a node of it. Where the tension jumps (attachments, clumps, buoys) or the section changes two
/// follow each other at one place: the side of the first end, then that of the second.
struct LiftedNode {
  LinePlace at;
  int segment = 0;                          ///< Of the line, from 0, on this side.
  double tension = 0.0;                     ///< Effective [N].
  double shear = 0.0;                       ///< Force of the second side on the first, square to the axis, up [N].
  double sagging = 0.0, sideways = 0.0;     ///< Bending moments [N m].
  double stress = 0.0, yield_stress = 0.0;  ///< Of bending, and what the steel bears; 0 where there is none [Pa].
  double von_mises = 0.0;                   ///< Largest over the section [Pa].
  double strain = 0.0;                      ///< Largest longitudinal strain magnitude at the outer fibre [-].
};

/// A line with pipe in it.
struct LiftedLine {
  std::string name;
  LiftedEnd first, second;
  MomentPlace sagging, hogging, bending;  ///< The largest; `hogging` counts positive, `bending` is without a sign.
  double bending_stress = 0.0, von_mises = 0.0;       ///< The largest [Pa].
  double largest_tension = 0.0, least_tension = 0.0;  ///< Effective [N].
  std::vector<BedStretch> on_bed;
  std::optional<LinePlace> lift_off;    ///< Of what lies, nearest to a free end, else to the first.
  double suspended_length = 0.0;        ///< That nothing bears [m].
  std::vector<double> water_crossings;  ///< Arc lengths at which the axis crosses the surface [m].
  std::vector<LiftedNode> nodes;
};

/// A line that hangs on another: what it does there.
struct LiftedWire {
  std::string name, on;                                         ///< Its own name, and that of the line it is on.
  double length = 0.0;                                          ///< Unstressed [m].
  double tension_upper = 0.0, tension_lower = 0.0;              ///< [N]
  Vec3 force = Vec3::Zero();                                    ///< On the line it is on [N].
  double from_vertical_upper = 0.0, from_vertical_lower = 0.0;  ///< [rad]
  std::optional<double> utilisation;                            ///< Upper tension over breaking load.
  LinePlace at;                                                 ///< On that line.
  double moment = 0.0;                                          ///< Of that line there, sagging positive [N m].
  double tension_before = 0.0, tension_after = 0.0;  ///< Of that line, towards its first end and its second [N].
  double shear_before = 0.0, shear_after = 0.0;      ///< [N]
};

/// Two ends that are to be joined: second less first.
struct WeldGap {
  double dx = 0.0, dy = 0.0, dz = 0.0;  ///< [m]
  double angle = 0.0;                   ///< By which the direction turns, positive like sagging [rad].
};

/// Force of the second line on the first.
struct Weld {
  LinePlace at;
  double tension = 0.0, shear = 0.0, moment = 0.0;  ///< Along and square to (up) the first line's axis; sagging.
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
