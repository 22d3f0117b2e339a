/// The sea bed as the model file describes it: a plane, a profile in the lay plane, or depths over an area. SI.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// A point of the profile of the bed.
struct ProfilePoint {
  double x = 0.0;      ///< Astern of the stern shoe, in the lay plane [m].
  double depth = 0.0;  ///< Below the mean water level [m].
};

/// Depths over an area, as a file gives them: scattered, or on a regular grid.
struct Bathymetry {
  std::vector<double> east, north, depth;  ///< World frame; of a grid row by row, east running fastest [m].
  int columns = 0, rows = 0;               ///< Of a regular grid; both 0: scattered.
};

/// How the bed's normal force grows with penetration.
enum class SoilModel {
  linear,      ///< stiffness times penetration.
  hyperbolic,  ///< Softens towards a bearing capacity, on one curve down and up (Kondner 1963).
  bilinear,    ///< Up to `embedment_force` by `stiffness`, beyond it by a fraction of it.
};

struct SeabedDescription {
  double stiffness = 0.0;                          ///< Normal force per length and penetration [N/m2].
  double friction_axial = 0.0;                     ///< Coulomb coefficient [-].
  double friction_lateral = 0.0;                   ///< Coulomb coefficient [-].
  double damping = 0.0;                            ///< Normal damping per length on approach [N s/m2].
  double slope = 0.0;                              ///< Fall of the bed in the direction `slope_towards` [rad].
  double slope_towards = 0.0;                      ///< Azimuth in which the bed falls [rad].
  std::vector<ProfilePoint> profile;               ///< By increasing x; empty: none.
  std::string bathymetry_file;                     ///< Empty: none.
  double midship_east = 0.0, midship_north = 0.0;  ///< Of midship, in the coordinates of the file [m].
  std::optional<Bathymetry> bathymetry;            ///< Its content, when it is there to be read.
  SoilModel soil = SoilModel::linear;
  std::optional<double> bearing_force;  ///< Of soil that is not linear: per length, at which it softens [N/m].
};

}  // namespace overbend
