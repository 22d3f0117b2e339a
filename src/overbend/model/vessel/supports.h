/// Roller boxes, rows and rollers in the ramp/stinger frame S (origin on the stern shoe, X astern, Y starboard, Z up).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "model/description/supports_description.h"

namespace overbend {

struct Description;

enum class RollerPosition { bottom, port, starboard };

inline const char* word(RollerPosition position) {
  switch (position) {
    case RollerPosition::bottom:
      return "bottom";
    case RollerPosition::port:
      return "port";
    case RollerPosition::starboard:
      break;
  }
  return "starboard";
}

/// Roller: a rigid finite cylinder. It touches the pipe only on the side to which its normal points.
struct Roller {
  int box = 0, row = 0;
  RollerPosition position = RollerPosition::bottom;
  Vec3 center_S = Vec3::Zero();   ///< Middle of the axis [m].
  Vec3 axis_S = Vec3::UnitY();    ///< Unit vector along the axis.
  Vec3 normal_S = Vec3::UnitZ();  ///< Unit normal of the face towards the pipe.
  double radius = 0.0;            ///< [m]
  double face = 0.0;              ///< Length [m].
  double stiffness = 0.0;         ///< Contact stiffness [N/m]; 0 = the engine's penalty.
  double friction_axial = 0.0, friction_lateral = 0.0, restitution = 0.0;
  bool is_stiffness_given = false;  ///< True if the stiffness is given in the file.
  RollerStiffness default_stiffness = RollerStiffness::physical;
  double structure_stiffness = 0.0;  ///< [N/m]
  RollerDamping damping = RollerDamping::clipped;
  double tangential_stiffness = 0.0;  ///< [N/m]; 0 = a fraction of the normal stiffness.

  /// Middle of the face: the reference point R_i of the separation, [silva2009] figure 11.
  Vec3 face_middle_S() const { return center_S + radius * normal_S; }
};

struct SupportRow {
  int box = 0;
  Vec3 point_S = Vec3::Zero();  ///< Point of the underside of a centred pipe [m].
  double from_top = 0.0;        ///< Length of pipe from the tensioner to the row, by chords from row to row [m].
  int first_roller = 0, roller_count = 0;
};

struct SupportBox {
  std::string name;
  Structure structure = Structure::ramp;
  Vec3 point_S = Vec3::Zero();       ///< Middle of the box, offset included [m].
  Vec3 curve_S = Vec3::Zero();       ///< As point_S without the offset: on the curve of the structure [m].
  Vec3 direction_S = Vec3::UnitX();  ///< Unit vector along the box, astern.
  Vec3 normal_S = Vec3::UnitZ();     ///< Unit outward (upward) normal.
  double inclination = 0.0;          ///< Positive dipping astern [rad].
  double length = 0.0;               ///< [m]
  int first_row = 0, row_count = 0;
  int section = -1;  ///< Index of the hinged stinger section; -1: fixed to the barge.
};

/// Current position of a stinger section, rotated about its hinge and those before it.
struct StingerSection {
  Vec3 hinge_S = Vec3::Zero();  ///< [m]
  double angle = 0.0;   ///< About its own hinge, positive when the tip goes down from the position as drawn [rad].
  double turned = 0.0;  ///< Total rotation, including the sections before it [rad].
};

struct Supports {
  std::vector<SupportBox> boxes;
  std::vector<SupportRow> rows;
  std::vector<Roller> rollers;
  std::vector<StingerSection> sections;  ///< Sections of a hinged stinger, in the order of the description.
};

/// Returns the inclination (positive dipping astern) of the smooth support curve at each point: tangent of the circle
/// through a point and its two neighbours, at the ends of the circle through the last three. Exact for a ramp and
/// stinger of constant radius. Two points give their chord, one gives `fallback`. Points are (X, Z) in S, running
/// astern.
std::vector<double> curve_inclinations(const std::vector<Eigen::Vector2d>& points, double fallback);

/// Default ratio of tangential to normal stiffness of a roller; limits sticking displacements to millimetres.
inline constexpr double kTangentialStiffnessRatio = 0.1;

/// Length of the rollers that represent a gap spring [m]: the pipe never reaches their ends.
inline constexpr double kGapSpringReach = 20.0;

/// Returns the roller row that represents a gap spring: a bottom roller so wide that the pipe does not leave it and, if
/// the type has side rollers, vertical ones of equal length, which act only to port and starboard. Radii, clearance and
/// stiffness are those of the type; damping and friction are zero.
RollerKindDescription gap_spring(const RollerKindDescription& kind);

/// Places every roller; with SupportContact::gap_springs one gap spring in the middle of each box instead.
/// `pipe_radius` is the coated pipe's radius [m] as a function of the length from the tensioner: side rollers are
/// placed with their clearance from a centred pipe.
Supports place_supports(const Description& description, const std::function<double(double)>& pipe_radius);
/// The same for a pipe of constant radius.
Supports place_supports(const Description& description, double pipe_radius);

}  // namespace overbend
