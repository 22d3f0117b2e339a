/// The hull that floats free: what the model file says under `vessel.motion.coupled`, `vessel.hydrostatics`,
/// `vessel.loads` and `station_keeping`. SI; points in the vessel's frame V.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

enum class Radiation { state_space, convolution };
enum class WaveDrift { none, mean, newman };
enum class WaveDriftDamping { none, aranha };
/// `trim`: constant forces keep draught, heel and trim as given with lines and pipe attached; `as_given`: the hull
/// sinks.
enum class Ballast { trim, as_given };

/// Damping of one mode besides radiation; `ratio` of critical, or coefficients.
struct ModeDampingDescription {
  std::string mode;                 ///< surge, sway, heave, roll, pitch, yaw.
  std::optional<double> ratio;      ///< Of critical damping [-].
  std::optional<double> linear;     ///< [N s/m] or [N m s]
  std::optional<double> quadratic;  ///< [N s2/m2] or [N m s2]
};

/// `ufc`: coefficients of UFC 4-159-03 by the hull's dimensions.
enum class HullCurrentForm { none, strips, table, ufc };
enum class CurrentRelativeTo { water, earth };
/// Direction convention of a table of current or wind coefficients: where the flow goes to (or comes from), counted
/// from the bow or the stern.
enum class CoefficientAxes { to_from_bow, from_bow, from_stern_ocimf };

struct CoefficientRow {
  double angle = 0.0;  ///< [rad]
  double cx = 0.0, cy = 0.0, cz = 0.0;
};

struct HullCurrentDescription {
  HullCurrentForm form = HullCurrentForm::strips;
  bool stated = false;        ///< Whether the model says anything; a current without it is an error.
  double transverse = 0.8;    ///< C_y of the strips [-].
  double longitudinal = 0.5;  ///< C_x [-].
  CurrentRelativeTo relative_to = CurrentRelativeTo::water;
  std::string table_file;
  std::optional<CoefficientAxes> axes;
  std::optional<double> frontal_area, lateral_area, length;  ///< Of the table's coefficients [m2, m2, m].
  std::vector<CoefficientRow> table;
};

struct WindAreaDescription {
  std::string name;
  double area = 0.0;                 ///< [m2]
  Vec3 centre = Vec3::Zero();        ///< [m]
  double shape = 1.0, height = 1.0;  ///< Coefficients C_s, C_h [-].
  bool frontal = false;              ///< Faces the bow; else the side.
};

struct WindDescription {
  double speed = 0.0;          ///< [m/s]
  double from = 0.0;           ///< Azimuth [rad].
  double air_density = 1.226;  ///< [kg/m3]
  std::vector<WindAreaDescription> areas;
  std::string table_file;  ///< In place of areas.
  std::optional<CoefficientAxes> axes;
  std::optional<double> frontal_area, lateral_area, length;  ///< Of the table's coefficients [m2, m2, m].
  std::vector<CoefficientRow> table;
};

struct CoupledHullDescription {
  std::string hydrodynamics;             ///< Stem of the WAMIT files (.1 .3 .8 .hst) or a netCDF file.
  std::optional<HydrodynamicData> data;  ///< Its contents, when it is there to be read.
  double mass = 0.0;                     ///< [kg]
  Vec3 centre_of_gravity = Vec3::Zero();
  Vec3 gyration = Vec3::Zero();  ///< Radii about x, y, z through the centre of gravity [m].
  Ballast ballast = Ballast::trim;
  Radiation radiation = Radiation::state_space;
  WaveDrift wave_drift = WaveDrift::newman;
  WaveDriftDamping wave_drift_damping = WaveDriftDamping::none;
  std::vector<ModeDampingDescription> damping;
  HullCurrentDescription current;
  WindDescription wind;
  double slow_period = 40.0;  ///< Corner of the low-pass of position and heading [s].
  /// Distance from rest at which a dynamic analysis lets the hull go: forward, to port, up; starboard down, bow down,
  /// bow to port [m, rad].
  Vec3 released_shift = Vec3::Zero(), released_turn = Vec3::Zero();
};

/// Restoring by buoyancy alone where there are no hydrodynamic files: balanced as drawn without lines and pipe.
struct HydrostaticsDescription {
  double heave = 0.0;              ///< [N/m]
  double roll = 0.0, pitch = 0.0;  ///< [N m/rad]
};

/// A load of the user: its direction stays along the drawn hull, its point moves with the hull.
struct VesselLoadDescription {
  std::string name;
  Vec3 at = Vec3::Zero(), force = Vec3::Zero(), moment = Vec3::Zero();  ///< Axes of the drawn hull [m, N, N m].
};

/// Dynamic positioning: spring, damper and thrust limit on the slow motion; surge, sway and yaw.
struct StationKeepingDescription {
  Vec3 stiffness = Vec3::Zero();       ///< [N/m, N/m, N m/rad]
  Vec3 damping = Vec3::Zero();         ///< [N s/m, N s/m, N m s/rad]
  Vec3 limit = Vec3::Constant(1e300);  ///< [N, N, N m]
};

}  // namespace overbend
