/// Bending moment of the pipe as a function of curvature under monotonic loading.
#pragma once

#include <vector>

#include "model/pipe/steel_curve.h"

namespace overbend {

/// Loads on the wall in addition to bending.
struct WallLoads {
  double wall_tension = 0.0;  ///< True wall tension [N].
  double hoop_stress = 0.0;   ///< Mean over the wall, tension positive [Pa].
};

struct MomentPoint {
  double moment = 0.0;      ///< [N m]
  double mid_strain = 0.0;  ///< Axial strain; exceeds the elastic strain as the neutral axis moves [-].
};

/// Returns the second moment of area of a pipe [m4].
double second_moment(double outside_diameter, double wall_thickness);

/// Integral of the stress over the wall, a closed ring of fibres: radial Gauss points times angles. The axial strain is
/// found such that the stresses balance the wall tension.
class WallIntegral {
 public:
  WallIntegral(const SteelDescription& steel, const WallLoads& loads, double max_curvature, int angles = 48,
               int rings = 2);
  /// `guess`: axial strain at a smaller curvature.
  MomentPoint at(double curvature, double guess = 0.0) const;

 private:
  struct Fibre {
    double y, area;
  };
  double wall_tension_;
  FibreCurve curve_;
  std::vector<Fibre> fibres_;  ///< Fibres on one side of the plane of bending, areas doubled.
};

/// First yield: M_y = 2 I SMYS / D, and its curvature.
struct FirstYield {
  double moment, curvature;
};
FirstYield first_yield(const SteelDescription& steel);

/// kappa/kappa_y = M/M_y + A (M/M_y)^B, the form of OFFPIPE.
struct MomentRambergOsgood {
  double coefficient = 0.0, exponent = 0.0;
  double max_error = 0.0;  ///< Max. relative moment error over the range of the fit [-].
};

/// Returns the moment of that law at a curvature, both relative to first yield.
double relative_moment(const MomentRambergOsgood& law, double relative_curvature);

/// Returns the fit to the wall integral without tension and pressure, from first yield to four times its curvature:
/// least squares in the logarithm of the plastic part.
MomentRambergOsgood fit_moment_law(const SteelDescription& steel);

}  // namespace overbend
