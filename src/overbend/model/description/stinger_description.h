/// Stinger in hinged sections: weight, supports and stops. Frame S, SI. Angles are relative to the position as drawn,
/// positive when the tip goes down.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// Point in the vertical plane of the stinger, frame S: x astern, z up [m].
struct StingerPoint {
  double x = 0.0, z = 0.0;
};

/// Structural weight and buoyancy, acting at points fixed in the section.
struct StingerBodyDescription {
  double weight = 0.0;                      ///< Weight in air [N].
  StingerPoint at;                          ///< Point of application of the weight [m].
  double buoyancy = 0.0;                    ///< Constant buoyancy of the permanently submerged parts [N].
  std::optional<StingerPoint> buoyancy_at;  ///< Point of application of the buoyancy; `at` if not given [m].
  /// About `at`; that of a uniform rod from hinge to tip if not given [m].
  std::optional<double> radius_of_gyration;
  double added_mass = 0.0;  ///< Added mass at `buoyancy_at` [kg].
  double drag_area = 0.0;   ///< C_d A for transverse motion, at `buoyancy_at` [m2].
};

/// Cylindrical tank, straight between two points.
struct StingerTankDescription {
  std::string name;
  StingerPoint from, to;
  double y = 0.0;                       ///< Transverse position, to starboard [m].
  double diameter = 0.0;                ///< [m]
  double weight = 0.0;                  ///< Weight of the empty tank, acts at mid-length [N].
  double ballast = 0.0;                 ///< Flooded fraction of the volume [-].
  double drag = 1.0, added_mass = 1.0;  ///< Transverse coefficients [-].
};

/// Tower wire or strut: spring between the barge and the section.
struct StingerSpringDescription {
  std::string name;
  StingerPoint on_barge, on_stinger;  ///< `on_stinger` moves with the section.
  double stiffness = 0.0;             ///< [N/m]
  double pretension = 0.0;            ///< Tension in the position as drawn [N].
  bool wire = true;                   ///< True: tension only.
};

/// Hinge stops in one or both directions.
struct StingerLimits {
  double up = 0.0, down = 0.0;  ///< Min. and max. angle [rad].
};

/// Section that rotates about a hinge. The first is hinged to the barge, each further one to the section before it.
struct StingerSectionDescription {
  std::string name;
  StingerPoint hinge;
  std::optional<double>
      angle;  ///< Prescribed angle; result of the equilibrium for a section with weight or tanks [rad].
  std::optional<StingerBodyDescription> body;
  std::vector<StingerTankDescription> tanks;
  std::vector<StingerSpringDescription> springs;
  std::optional<StingerLimits> limits;
  double stop_stiffness = 1e9;  ///< Rotational stiffness of a stop in dynamics [N m/rad].
  double hinge_friction = 0.0;  ///< Friction moment that the hinge resists before it rotates [N m].

  /// Returns true if the angle follows from the forces on the section.
  bool floats() const { return body.has_value() || !tanks.empty(); }
};

/// Named set of section angles, as in a ship's table of stinger settings.
struct StingerSettingDescription {
  std::string name;
  std::vector<double> angles;  ///< Section angles from the barge astern [rad].
};

/// Boxes generated on an arc of constant radius.
struct BoxRowDescription {
  int count = 0;
  double spacing = 0.0;  ///< Arc length between boxes [m].
  StingerPoint first;    ///< Point of the underside of the pipe at the first box [m].
  double incline = 0.0;  ///< Inclination of the arc at the first box, positive when it dips astern [rad].
  double length = 0.0;   ///< Length of each box [m].
};

}  // namespace overbend
