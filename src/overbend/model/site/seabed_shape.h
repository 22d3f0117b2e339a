/// Heights of a seabed that is not a plane: a profile along one direction, or a regular grid. C1 everywhere inside.
///
/// A profile is the monotone piecewise cubic through its points (Fritsch and Carlson 1980, slopes by the weighted
/// harmonic mean of Fritsch and Butland 1984, end slopes as in scipy's PCHIP), constant across. A grid is bicubic
/// Hermite with such slopes along its rows and columns. Both are level beyond their ends.
#pragma once

#include <memory>
#include <vector>

#include "model/description/seabed_description.h"

namespace overbend {

struct SeabedShape {
  double origin[2] = {0.0, 0.0};  ///< World position of x = 0 of a profile [m].
  double along[2] = {1.0, 0.0};   ///< Horizontal unit vector along a profile, W.
  std::vector<double> x;          ///< Knots: along a profile, or east for a grid [m].
  std::vector<double> y;          ///< Knots north; empty: a profile [m].
  std::vector<double> z;          ///< Heights at the knots, x running fastest [m].
  std::vector<double> zx, zy;     ///< Slopes at the knots; for a profile only `zx`.
  std::vector<double> zxy;        ///< Twist at the knots [1/m].
  double highest = 0.0;           ///< Upper bound of all heights [m].
};

/// Height at a position with its derivatives in world x and y.
struct SeabedPoint {
  double z = 0.0, zx = 0.0, zy = 0.0, zxx = 0.0, zxy = 0.0, zyy = 0.0;
};

SeabedPoint bed_point(const SeabedShape& shape, double x, double y);

/// The same written to six doubles, for kernels, which know only the address of the shape.
void bed_values(const SeabedShape* shape, double x, double y, double* six);

/// Returns the shape of a profile of at least two points by increasing x; `origin` and `along` are two doubles each.
std::shared_ptr<const SeabedShape> profile_shape(const std::vector<ProfilePoint>& points, const double* origin,
                                                 const double* along);

/// Returns the shape of a regular grid, or of scattered depths, which are interpolated on a regular grid of about as
/// many points: at each of its points the weighted least-squares plane through the nearest nine depths (weights
/// 1/distance^2), limited to their range.
std::shared_ptr<const SeabedShape> grid_shape(const Bathymetry& depths);

}  // namespace overbend
