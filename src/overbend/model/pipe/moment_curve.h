/// Bending moment of the pipe over its curvature, under a load that only grows.
#pragma once

#include <vector>

#include "model/pipe/steel_curve.h"

namespace overbend {

/// What acts on the wall beside bending.
struct WallLoads {
  double wall_tension = 0.0;  ///< True wall tension [N].
  double hoop_stress = 0.0;   ///< Mean over the wall, tension positive [Pa].
};

struct MomentPoint {
  double moment = 0.0;      ///< [N m]
  double mid_strain = 0.0;  ///< Of the axis; grows beyond the elastic strain as the neutral axis moves [-].
};

/// Second moment of area of a pipe [m4].
double second_moment(double outside_diameter, double wall_thickness);

/// Integrates stress over the wall, closed ring of fibres: radial Gauss points times angles. The strain of the axis is
/// found so that the stresses carry the wall tension.
class WallIntegral {
 public:
  WallIntegral(const SteelDescription& steel, const WallLoads& loads, double largest_curvature, int angles = 48,
               int rings = 2);
  /// `guess` of the strain of the axis: that of a smaller curvature.
  MomentPoint at(double curvature, double guess = 0.0) const;

 private:
  struct Fibre {
    double y, area;
  };
  double wall_tension_;
  FibreCurve curve_;
  std::vector<Fibre> fibres_;  ///< Of the half on one side of the plane of bending, areas doubled.
};

/// First yield by the plain formula: M_y = 2 I SMYS / D, and its curvature.
struct FirstYield {
  double moment, curvature;
};
FirstYield first_yield(const SteelDescription& steel);

/// kappa/kappa_y = M/M_y + A (M/M_y)^B, the form of OFFPIPE.
struct MomentRambergOsgood {
  double coefficient = 0.0, exponent = 0.0;
  double largest_error = 0.0;  ///< Of the moment, relative, over the range of the fit.
};

/// Moment of that law at a curvature, both relative to first yield.
double relative_moment(const MomentRambergOsgood& law, double relative_curvature);

/// Fit to the wall's integral without tension and pressure, from first yield to four times its curvature: least squares
/// in the logarithm of the plastic part.
MomentRambergOsgood fit_moment_law(const SteelDescription& steel);

}  // namespace overbend
