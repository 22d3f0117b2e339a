/// Seabed as given in the model file: a plane, a profile in the lay plane, or depths over an area. SI.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// Point of the seabed profile.
struct ProfilePoint {
  double x = 0.0;      ///< Distance astern of the stern shoe, in the lay plane [m].
  double depth = 0.0;  ///< Depth below the mean water level [m].
};

/// Depths over an area from a file: scattered, or on a regular grid.
struct Bathymetry {
  /// World frame; a grid is stored row by row with east varying fastest [m].
  std::vector<double> east, north, depth;
  int columns = 0, rows = 0;  ///< Size of a regular grid; both 0: scattered.
};

/// Meaning of the values of a bathymetry file.
enum class BathymetryValues {
  depth,      ///< Positive below the mean water level.
  elevation,  ///< Heights: negative below the mean water level.
};

/// Position and orientation of the model in the coordinates of a bathymetry file.
struct MapOrigin {
  double east = 0.0, north = 0.0;  ///< Coordinates of midship [m].
  std::optional<double> lat, lon;  ///< For files in degrees: geographic position of midship, WGS 84 [rad].
  double azimuth = 0.0;            ///< Azimuth, in the map, of the model's north [rad].
};

/// Relation between normal force of the seabed and penetration.
enum class SoilModel {
  linear,      ///< Force = stiffness * penetration.
  hyperbolic,  ///< Softens towards a bearing capacity; same curve for loading and unloading (Kondner 1963).
  bilinear,    ///< `stiffness` up to the bearing force, a fraction of it beyond.
};

struct SeabedDescription {
  double stiffness = 0.0;                             ///< Normal force per length and penetration [N/m2].
  double friction_axial = 0.0;                        ///< Coulomb coefficient [-].
  double friction_lateral = 0.0;                      ///< Coulomb coefficient [-].
  double damping = 0.0;                               ///< Normal damping per length on approach [N s/m2].
  double slope = 0.0;                                 ///< Slope of the seabed, falling towards `slope_towards` [rad].
  double slope_towards = 0.0;                         ///< Azimuth towards which the seabed falls [rad].
  std::vector<ProfilePoint> profile;                  ///< By increasing x; empty: none.
  std::string bathymetry_file;                        ///< Empty if there is none.
  MapOrigin bathymetry_origin;                        ///< Midship and north of the model in the file.
  std::optional<BathymetryValues> bathymetry_values;  ///< Empty: as the file states, or by the sign of all its values.
  std::optional<Bathymetry> bathymetry;               ///< Contents of the file; empty if it is not read.
  SoilModel soil = SoilModel::linear;
  std::optional<double> bearing_force;  ///< Nonlinear soil: force per length at which it softens [N/m].
};

}  // namespace overbend
