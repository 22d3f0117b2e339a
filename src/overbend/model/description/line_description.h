/// Lines besides the pipe: mooring lines, and lines that stand by themselves between two ends. SI.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "model/description/section_description.h"

namespace overbend {

/// Of a six-strand wire rope.
enum class RopeCore { wire, fibre };
/// Of chain of grade R4.
enum class ChainLink { studless, studlink };

/// A cable, chain or flexible by its numbers. Weights are per unstressed length.
struct LineTypeDescription {
  std::string name;
  std::string made_from;                ///< How the numbers came about: "given", "wire rope, 64 mm, wire core" ...
  double diameter = 0.0;                ///< Nominal [m].
  double volume_diameter = 0.0;         ///< Of a cylinder with the displaced volume [m].
  double weight_in_air = 0.0;           ///< [N/m]
  double weight_submerged = 0.0;        ///< Negative where the line floats [N/m].
  double axial_stiffness = 0.0;         ///< EA [N]
  double bending_stiffness = 0.0;       ///< EI [N m2]
  std::optional<bool> compression;      ///< Whether it bears compression; see bears_compression().
  std::optional<double> breaking_load;  ///< MBL [N]
  double drag_diameter = 0.0;           ///< Of the drag coefficients [m].
  double drag_normal = 1.2, drag_axial = 0.0;
  double added_mass_normal = 1.0, added_mass_axial = 0.0;  ///< On the displaced water [-].
  std::optional<double> friction;                          ///< On the bed [-].
};

struct LineSegmentDescription {
  std::string name;
  std::optional<double> length;  ///< Unstressed [m]; the first segment's may follow from a tension.
  LineTypeDescription type;
  std::optional<SectionDescription> section = {};  ///< Of pipe, from which the numbers of `type` follow.
};

enum class PointKind { clump, buoy };
enum class BuoyShape { sphere, cylinder };

/// A clump weight or a buoy at a place of a line, or at the end of a tether there.
struct LinePointDescription {
  std::string name;
  PointKind kind = PointKind::clump;
  double at = 0.0;    ///< Unstressed length from the line's first end given (fairlead, or the first of `ends`) [m].
  double mass = 0.0;  ///< [kg]
  double net_force = 0.0;   ///< Upwards under water: buoyancy less weight; a clump's is negative [N].
  double volume = 0.0;      ///< Of displaced water [m3].
  double drag_area = 0.0;   ///< C_d A [m2]
  double added_mass = 0.0;  ///< [kg]
  BuoyShape shape = BuoyShape::sphere;
  double height = 0.0;     ///< Of a cylinder; a sphere's diameter follows from the volume [m].
  double tether = 0.0;     ///< Length of an inextensible tether; 0: fixed to the line [m].
  bool by_weight = false;  ///< Given by weight and buoyancy, until resolve_lines() makes mass and net force of them.
};

/// Word for the lay vessel where an end of a line names its body.
inline constexpr const char* kVesselName = "vessel";

enum class LineEndKind { fixed, body, bed, water, free, line };

/// What holds an end of a line.
struct LineEndDescription {
  LineEndKind kind = LineEndKind::fixed;
  Vec3 at = Vec3::Zero();          ///< W for fixed, on the bed and in the water; frame of the body for body [m].
  std::string body = kVesselName;  ///< Of body: its name.
  std::string line;                ///< Of line: the one it is on.
  double arc_length = 0.0;         ///< There, unstressed, from that line's first end [m].
  bool clamped = false;            ///< Direction held as well as place.
  Vec3 direction = Vec3::Zero();   ///< Of the line there, if clamped; frame as `at`.
  /// Prescribed motion of a fixed end about `at`: amplitude along W axes, period and phase of a harmonic motion.
  Vec3 amplitude = Vec3::Zero();
  double period = 0.0, phase = 0.0;  ///< amplitude * sin(2 pi t / period + phase) [s, rad].
};

/// A line alone between two ends. Lengths of segments run from the first end.
struct FreeLineDescription {
  std::string name;
  LineEndDescription first, second;
  std::vector<LineSegmentDescription> segments;
  std::vector<LinePointDescription> points;
  std::optional<double> element;  ///< Length of its elements [m].
  std::optional<Vec3> start;      ///< Place of a free end before anything is lifted: x and y, W [m].
};

/// Whether an end of a line is on the lay vessel.
inline bool is_on_vessel(const LineEndDescription& end) {
  return end.kind == LineEndKind::body && end.body == kVesselName;
}

/// Whether pipe is in a line.
inline bool has_pipe_section(const FreeLineDescription& line) {
  return std::ranges::any_of(line.segments, [](const auto& segment) { return segment.section.has_value(); });
}

/// Whether an end of a line is on another line, or free.
inline bool is_linked(const FreeLineDescription& line) {
  const auto linked = [](const LineEndDescription& end) {
    return end.kind == LineEndKind::line || end.kind == LineEndKind::free;
  };
  return linked(line.first) || linked(line.second);
}

/// Unstressed, of all segments [m].
inline double unstressed_length(const FreeLineDescription& line) {
  double sum = 0.0;
  for (const LineSegmentDescription& segment : line.segments) sum += segment.length.value_or(0.0);
  return sum;
}

/// EA of a line whose segments stretch one after the other [N].
inline double axial_stiffness(const FreeLineDescription& line) {
  double compliance = 0.0;
  for (const LineSegmentDescription& segment : line.segments) {
    compliance += segment.length.value_or(0.0) / segment.type.axial_stiffness;
  }
  return unstressed_length(line) / compliance;
}

/// Whether a line is a straight wire: all of one type that weighs nothing and does not bend.
inline bool is_weightless(const FreeLineDescription& line) {
  return line.points.empty() && std::ranges::all_of(line.segments, [](const auto& segment) {
           return segment.type.weight_in_air == 0.0 && segment.type.weight_submerged == 0.0 &&
                  segment.type.bending_stiffness == 0.0;
         });
}

}  // namespace overbend
