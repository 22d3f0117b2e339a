/// Lines other than the pipe: mooring lines and free lines between two ends. SI.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/ranges.h"
#include "base/vec.h"
#include "model/description/section_description.h"

namespace overbend {

/// Core of a six-strand wire rope.
enum class RopeCore { wire, fibre };
/// Links of chain of grade R4.
enum class ChainLink { studless, studlink };

/// Properties of a cable, chain or flexible. Weights are per unstressed length.
struct LineTypeDescription {
  std::string name;
  std::string made_from;                ///< Origin of the numbers: "given", "wire rope, 64 mm, wire core" ...
  double diameter = 0.0;                ///< Nominal [m].
  double volume_diameter = 0.0;         ///< Diameter of a cylinder with the displaced volume [m].
  double weight_in_air = 0.0;           ///< [N/m]
  double weight_submerged = 0.0;        ///< Negative if the line floats [N/m].
  double axial_stiffness = 0.0;         ///< EA [N]
  double bending_stiffness = 0.0;       ///< EI [N m2]
  std::optional<bool> compression;      ///< Carries compression; see bears_compression().
  std::optional<double> breaking_load;  ///< MBL [N]
  double drag_diameter = 0.0;           ///< Reference diameter of the drag coefficients [m].
  double drag_normal = 1.2, drag_axial = 0.0;
  double added_mass_normal = 1.0, added_mass_axial = 0.0;  ///< Relative to the displaced water [-].
  std::optional<double> friction;                          ///< Coulomb friction on the seabed [-].
};

struct LineSegmentDescription {
  std::string name;
  std::optional<double> length;  ///< Unstressed [m]; that of the first segment may follow from a tension.
  LineTypeDescription type;
  std::optional<SectionDescription> section = {};  ///< Pipe section from which the numbers of `type` follow.
};

enum class PointKind { clump, buoy };
enum class BuoyShape { sphere, cylinder };

/// Clump weight or buoy on a line, or at the end of a tether on it.
struct LinePointDescription {
  std::string name;
  PointKind kind = PointKind::clump;
  double at = 0.0;          ///< Unstressed length from the line's first end (fairlead, or the first of `ends`) [m].
  double mass = 0.0;        ///< [kg]
  double net_force = 0.0;   ///< Upward force under water, buoyancy less weight; negative for a clump [N].
  double volume = 0.0;      ///< Displaced volume [m3].
  double drag_area = 0.0;   ///< C_d A [m2]
  double added_mass = 0.0;  ///< [kg]
  BuoyShape shape = BuoyShape::sphere;
  double height = 0.0;     ///< Height of a cylinder; the diameter of a sphere follows from the volume [m].
  double tether = 0.0;     ///< Length of an inextensible tether; 0: fixed to the line [m].
  bool by_weight = false;  ///< Given by weight and buoyancy; resolve_lines() converts these to mass and net force.
};

/// Body name of the lay vessel in line ends.
inline constexpr const char* kVesselName = "vessel";

enum class LineEndKind { fixed, body, bed, water, free, line };

/// Attachment of a line end.
struct LineEndDescription {
  LineEndKind kind = LineEndKind::fixed;
  Vec3 at = Vec3::Zero();          ///< W for fixed, bed and water; body frame for body [m].
  std::string body = kVesselName;  ///< Name of the body, for `body`.
  std::string line;                ///< Name of the line, for `line`.
  double arc_length = 0.0;         ///< Unstressed length from the first end of that line [m].
  bool clamped = false;            ///< True if the direction is fixed as well as the position.
  Vec3 direction = Vec3::Zero();   ///< Direction of the line at a clamped end; frame as `at`.
  /// Prescribed motion of a fixed end about `at`: amplitude along W axes, period and phase of a harmonic motion.
  Vec3 amplitude = Vec3::Zero();
  double period = 0.0, phase = 0.0;  ///< amplitude * sin(2 pi t / period + phase) [s, rad].
};

/// Free line between two ends. Segment lengths count from the first end.
struct FreeLineDescription {
  std::string name;
  LineEndDescription first, second;
  std::vector<LineSegmentDescription> segments;
  std::vector<LinePointDescription> points;
  std::optional<double> element;  ///< Element length [m].
  std::optional<Vec3> start;      ///< Initial position of a free end before any lifting: x and y, W [m].
};

/// Returns true if a line end is on the lay vessel.
inline bool is_on_vessel(const LineEndDescription& end) {
  return end.kind == LineEndKind::body && end.body == kVesselName;
}

/// Returns true if a segment of the line is pipe.
inline bool has_pipe_section(const FreeLineDescription& line) {
  return ranges::any_of(line.segments, [](const auto& segment) { return segment.section.has_value(); });
}

/// Returns true if an end of the line is free or attached to another line.
inline bool is_linked(const FreeLineDescription& line) {
  const auto linked = [](const LineEndDescription& end) {
    return end.kind == LineEndKind::line || end.kind == LineEndKind::free;
  };
  return linked(line.first) || linked(line.second);
}

/// Returns the unstressed length of all segments [m].
inline double unstressed_length(const FreeLineDescription& line) {
  double sum = 0.0;
  for (const LineSegmentDescription& segment : line.segments) sum += segment.length.value_or(0.0);
  return sum;
}

/// Returns EA of the segments in series [N].
inline double axial_stiffness(const FreeLineDescription& line) {
  double compliance = 0.0;
  for (const LineSegmentDescription& segment : line.segments) {
    compliance += segment.length.value_or(0.0) / segment.type.axial_stiffness;
  }
  return unstressed_length(line) / compliance;
}

/// Returns true if the line is a straight wire: one type, without weight and bending stiffness.
inline bool is_weightless(const FreeLineDescription& line) {
  return line.points.empty() && ranges::all_of(line.segments, [](const auto& segment) {
           return segment.type.weight_in_air == 0.0 && segment.type.weight_submerged == 0.0 &&
                  segment.type.bending_stiffness == 0.0;
         });
}

}  // namespace overbend
