/// Stress and strain of the steel beyond yield, under a load that only grows.
#pragma once

#include <vector>

#include "model/description/section_description.h"

namespace overbend {

/// Plastic strain over equivalent stress: (yield_strain - SMYS/E) (s/SMYS)^n [ramberg1943], or straight from point to
/// point of a test, which a bilinear law is a case of.
struct PlasticStrain {
  double coefficient = 0.0, exponent = 0.0, reference = 1.0;  ///< Of the power law; without points only.
  std::vector<CurvePoint> points;                             ///< Plastic strain (x) over stress (y), rising.
  double beyond = 0.0;                                        ///< Slope after the last point [1/Pa].

  struct Value {
    double value, slope;  ///< [-], [1/Pa]
  };
  Value at(double stress) const;
};

/// Of a law in stress and strain; otherwise of the stress-strain data given in addition (moment_ramberg_osgood).
PlasticStrain plastic_strain(const SteelDescription& steel);

/// Axial stress of a fibre over its axial strain while the hoop stress stays: deformation theory of plasticity
/// (Hencky 1924) with von Mises' equivalent stress s_e^2 = s^2 - s s_h + s_h^2,
///     strain = (s - nu s_h)/E + plastic(s_e)/s_e (s - s_h/2),
/// tabulated, with cubic interpolation. Radial stress is neglected.
class FibreCurve {
 public:
  FibreCurve(const SteelDescription& steel, const PlasticStrain& plastic, double hoop_stress, double largest_strain);

  struct Value {
    double stress, modulus;  ///< [Pa]
  };
  Value at(double strain) const;

 private:
  double largest_;
  std::vector<double> tension_, tension_slope_, compression_, compression_slope_;  ///< At largest_ (j/n)^2.
};

}  // namespace overbend
