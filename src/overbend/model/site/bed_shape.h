/// Heights of a sea bed that is not a plane: a profile along one direction, or a regular grid. C1 everywhere inside.
///
/// A profile is the monotone piecewise cubic through its points (Fritsch and Carlson 1980, slopes by the weighted
/// harmonic mean of Fritsch and Butland 1984, end slopes as scipy's PCHIP has them), constant across. A grid is bicubic
/// Hermite with such slopes along its rows and columns. Both are level beyond their ends.
#pragma once

#include <memory>
#include <vector>

#include "model/description/seabed_description.h"

namespace overbend {

struct BedShape {
  double origin[2] = {0.0, 0.0};  ///< World place from which a profile's x counts [m].
  double along[2] = {1.0, 0.0};   ///< Horizontal unit vector along a profile, W.
  std::vector<double> x;          ///< Knots: of a profile along it, of a grid east [m].
  std::vector<double> y;          ///< Knots north; empty: a profile [m].
  std::vector<double> z;          ///< Heights at the knots, x running fastest [m].
  std::vector<double> zx, zy;     ///< Slopes there; of a profile `zx` alone.
  std::vector<double> zxy;        ///< Twist there [1/m].
  double highest = 0.0;           ///< No place is higher [m].
};

/// Height at a place with its derivatives in world x and y.
struct BedPoint {
  double z = 0.0, zx = 0.0, zy = 0.0, zxx = 0.0, zxy = 0.0, zyy = 0.0;
};

BedPoint bed_point(const BedShape& shape, double x, double y);

/// The same into six doubles, for kernels, which know the shape by its address alone.
void bed_values(const BedShape* shape, double x, double y, double* six);

/// Of at least two points by increasing x; `origin` and `along` are two doubles each.
std::shared_ptr<const BedShape> profile_shape(const std::vector<ProfilePoint>& points, const double* origin,
                                              const double* along);

/// Of a regular grid, or of scattered depths, which a regular grid of about as many points takes up: each of its points
/// has the weighted least-squares plane through the nearest nine depths (weights 1/distance^2), no higher and no lower
/// than these.
std::shared_ptr<const BedShape> grid_shape(const Bathymetry& depths);

}  // namespace overbend
