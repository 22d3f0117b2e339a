/// Floating hull: the keys `vessel.motion.coupled`, `vessel.hydrostatics`, `vessel.loads` and `station_keeping`. SI;
/// points in the vessel frame V.
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

/// Damping of one mode in addition to radiation: `ratio` of critical damping, or coefficients.
struct ModeDampingDescription {
  std::string mode;                 ///< surge, sway, heave, roll, pitch, yaw.
  std::optional<double> ratio;      ///< Fraction of critical damping [-].
  std::optional<double> linear;     ///< [N s/m] or [N m s]
  std::optional<double> quadratic;  ///< [N s2/m2] or [N m s2]
};

/// `ufc`: coefficients of UFC 4-159-03 from the hull's dimensions.
enum class HullCurrentModel { none, strips, table, ufc };
enum class CurrentRelativeTo { water, earth };
/// Direction convention of a table of current or wind coefficients: direction of the flow, to or from, measured from
/// the bow or the stern.
enum class CoefficientAxes { to_from_bow, from_bow, from_stern_ocimf };

struct CoefficientRow {
  double angle = 0.0;  ///< [rad]
  double cx = 0.0, cy = 0.0, cz = 0.0;
};

struct HullCurrentDescription {
  HullCurrentModel form = HullCurrentModel::strips;
  bool stated = false;        ///< True if the model gives the current load; a current without it is an error.
  double transverse = 0.8;    ///< C_y of the strips, on length and draught [-].
  double longitudinal = 0.5;  ///< C_x [-].
  CurrentRelativeTo relative_to = CurrentRelativeTo::water;
  std::string table_file;
  std::optional<CoefficientAxes> axes;
  std::optional<double> frontal_area, lateral_area, length;  ///< References of the table's coefficients [m2, m2, m].
  std::vector<CoefficientRow> table;
};

struct WindAreaDescription {
  std::string name;
  double area = 0.0;                 ///< [m2]
  Vec3 centre = Vec3::Zero();        ///< [m]
  double shape = 1.0, height = 1.0;  ///< Coefficients C_s, C_h [-].
  bool frontal = false;              ///< True: the area faces the bow; false: the side.
};

struct WindDescription {
  double speed = 0.0;          ///< [m/s]
  double from = 0.0;           ///< Azimuth [rad].
  double air_density = 1.226;  ///< [kg/m3]
  std::vector<WindAreaDescription> areas;
  std::string table_file;  ///< CSV table of coefficients, replaces the areas.
  std::optional<CoefficientAxes> axes;
  std::optional<double> frontal_area, lateral_area, length;  ///< References of the table's coefficients [m2, m2, m].
  std::vector<CoefficientRow> table;
};

struct CoupledHullDescription {
  std::string hydrodynamics;             ///< Stem of the WAMIT files (.1 .3 .8 .hst) or a netCDF file.
  std::optional<HydrodynamicData> data;  ///< Contents of the files; empty if they are not read.
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
  double low_frequency_period = 40.0;  ///< Corner period of the low-pass filter of position and heading [s].
  /// Offset from equilibrium from which a dynamic analysis releases the hull: forward, to port, up; starboard down, bow
  /// down, bow to port [m, rad].
  Vec3 release_offset = Vec3::Zero(), release_rotation = Vec3::Zero();
};

/// Hydrostatic stiffness without hydrodynamic files; balanced in the nominal pose without lines and pipe.
struct HydrostaticsDescription {
  double heave = 0.0;              ///< [N/m]
  double roll = 0.0, pitch = 0.0;  ///< [N m/rad]
};

/// Constant load given by the user: its direction is fixed in the axes of the nominal pose, its point moves with the
/// hull.
struct VesselLoadDescription {
  std::string name;
  Vec3 at = Vec3::Zero(), force = Vec3::Zero(), moment = Vec3::Zero();  ///< Axes of the nominal pose [m, N, N m].
};

/// Dynamic positioning: spring, damper and thrust limit on the low-frequency motion; surge, sway and yaw.
struct StationKeepingDescription {
  Vec3 stiffness = Vec3::Zero();       ///< [N/m, N/m, N m/rad]
  Vec3 damping = Vec3::Zero();         ///< [N s/m, N s/m, N m s/rad]
  Vec3 limit = Vec3::Constant(1e300);  ///< [N, N, N m]
};

}  // namespace overbend
