/// Stress-strain relation of the steel beyond yield under monotonic loading.
#pragma once

#include <vector>

#include "model/description/section_description.h"

namespace overbend {

/// Plastic strain as a function of equivalent stress: (yield_strain - SMYS/E) (s/SMYS)^n [ramberg1943], or piecewise
/// linear through test points, which includes the bilinear law.
struct PlasticStrain {
  double coefficient = 0.0, exponent = 0.0, reference = 1.0;  ///< Power law; without points only.
  std::vector<CurvePoint> points;                             ///< Plastic strain (x) and stress (y), increasing.
  double beyond = 0.0;                                        ///< Slope beyond the last point [1/Pa].

  struct Value {
    double value, slope;  ///< [-], [1/Pa]
  };
  Value at(double stress) const;
};

/// Returns the plastic strain of a stress-strain law, or of the stress-strain data given in addition
/// (moment_ramberg_osgood).
PlasticStrain plastic_strain(const SteelDescription& steel);

/// Axial stress of a fibre as a function of its axial strain at constant hoop stress: deformation theory of plasticity
/// (Hencky 1924) with von Mises' equivalent stress s_e^2 = s^2 - s s_h + s_h^2, strain = (s - nu s_h)/E +
/// plastic(s_e)/s_e (s - s_h/2), tabulated, with cubic interpolation. Radial stress is neglected.
class FibreCurve {
 public:
  FibreCurve(const SteelDescription& steel, const PlasticStrain& plastic, double hoop_stress, double max_strain);

  struct Value {
    double stress, modulus;  ///< [Pa]
  };
  Value at(double strain) const;

 private:
  double max_strain_;
  std::vector<double> tension_, tension_slope_, compression_, compression_slope_;  ///< At largest_ (j/n)^2.
};

}  // namespace overbend
