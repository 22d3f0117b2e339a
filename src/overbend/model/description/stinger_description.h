/// A stinger in sections on hinges: what it weighs, what carries it, what stops it. Frame S, SI.
///
/// Angles are positive when the tip goes down from where the section is drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// A place in the vertical plane of the stinger, frame S: x astern, z up [m].
struct StingerPoint {
  double x = 0.0, z = 0.0;
};

/// Weight of the structure and its buoyancy, at points fixed in the section.
struct StingerBodyDescription {
  double weight = 0.0;                       ///< In air [N].
  StingerPoint at;                           ///< Where it acts [m].
  double buoyancy = 0.0;                     ///< Constant: of what stays under water [N].
  std::optional<StingerPoint> buoyancy_at;   ///< Where that acts; with the weight where not given [m].
  std::optional<double> radius_of_gyration;  ///< About `at`; of an even rod from hinge to tip where not given [m].
  double added_mass = 0.0;                   ///< Of the water that goes with it, at `buoyancy_at` [kg].
  double drag_area = 0.0;                    ///< Cd A of motion across it, at `buoyancy_at` [m2].
};

/// A round tank, straight from one point to the other.
struct StingerTankDescription {
  std::string name;
  StingerPoint from, to;
  double y = 0.0;                       ///< Across, to starboard [m].
  double diameter = 0.0;                ///< [m]
  double weight = 0.0;                  ///< Empty, acts at mid-length [N].
  double ballast = 0.0;                 ///< Fraction of its volume that is flooded [-].
  double drag = 1.0, added_mass = 1.0;  ///< Coefficients across the axis [-].
};

/// A tower's wire or a strut as a spring between the barge and the section.
struct StingerSpringDescription {
  std::string name;
  StingerPoint on_barge, on_stinger;  ///< The second goes with the section.
  double stiffness = 0.0;             ///< [N/m]
  double pretension = 0.0;            ///< As drawn [N].
  bool wire = true;                   ///< Pulls only.
};

/// A stop on either side, or one.
struct StingerLimits {
  double up = 0.0, down = 0.0;  ///< Least and largest angle [rad].
};

/// What turns about one hinge. The first hangs on the barge, each other on the one before it.
struct StingerSectionDescription {
  std::string name;
  StingerPoint hinge;
  std::optional<double>
      angle;  ///< Held there by the ship; of a section with weight or tanks: it finds its angle [rad].
  std::optional<StingerBodyDescription> body;
  std::vector<StingerTankDescription> tanks;
  std::vector<StingerSpringDescription> springs;
  std::optional<StingerLimits> limits;
  double stop_stiffness = 1e9;  ///< Of a stop in motion, as a moment [N m/rad].
  double hinge_friction = 0.0;  ///< Moment that the hinge bears before it turns [N m].

  /// Whether the forces on it decide its angle.
  bool floats() const { return body.has_value() || !tanks.empty(); }
};

/// Angles of the sections under a name, as a ship keeps them in its table of settings.
struct StingerSettingDescription {
  std::string name;
  std::vector<double> angles;  ///< Of the sections from the barge astern [rad].
};

/// Boxes on an arc of constant radius, of which none is typed.
struct BoxRowDescription {
  int count = 0;
  double spacing = 0.0;  ///< Along the arc, from box to box [m].
  StingerPoint first;    ///< Where the underside of the pipe rests at the first box [m].
  double incline = 0.0;  ///< Of the arc there, positive when it dips astern [rad].
  double length = 0.0;   ///< Of each box [m].
};

}  // namespace overbend
