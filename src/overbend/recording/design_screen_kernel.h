/// Loops of the design screen over the nodes of a run. Compiled once per instruction set; raw pointers only, see
/// wave_kernel.h. Output arrays overlap no other array.
#pragma once

#include "checks/load_factors.h"

namespace overbend {

/// Vectors at many nodes.
struct VectorsView {
  const double *x, *y, *z;
};

/// A present load effect and its static value, with the tangents of the pipe in both states.
struct EffectView {
  VectorsView functional, present, functional_tangent, tangent;
};

/// Squares and product of the functional part of an effect, rotated with the pipe, and of its environmental part.
struct EffectParts {
  double *functional, *environmental, *both;
};

struct CombinationsView {
  const LoadFactors* factors;
  int count;
};

/// Capacities of a class that bound its utilisation, see design_screen.h.
struct LoadBound {
  double moment_factor, tension_factor, collapse_factor;
  const double* limit;
};
struct StrainBound {
  double strain_factor;           ///< Factor of the design strain itself.
  double utilisation_per_strain;  ///< [-]
  double collapse_factor;
  const double *slope, *limit;
};

/// Kernels of one instruction set. `excess` becomes the maximum over the classes; `first` overwrites it.
struct ScreenKernels {
  void (*split)(const EffectView& effect, int count, const EffectParts& parts);
  /// Strains as vectors along the bending moment; along z where there is none.
  void (*strain_vectors)(const VectorsView& moment, const double* strain, int count, double* x, double* y, double* z);
  /// Maximum design size over all combinations, like design_size() of checks/load_effects.h.
  void (*sizes)(const CombinationsView& all, const EffectParts& parts, int count, double* size);
  /// Maximum magnitude of a design force, like design_value() of checks/load_effects.h.
  void (*forces)(const CombinationsView& all, const double* functional, const double* present, int count,
                 double* force);
  void (*load_excess)(const LoadBound& bound, const double* moment, const double* force, const double* pressure,
                      int count, bool first, double* excess);
  void (*strain_excess)(const StrainBound& bound, const double* size, const double* pressure, int count, bool first,
                        double* excess);
};

namespace isa_baseline {
ScreenKernels screen_kernels();
}  // namespace isa_baseline
namespace isa_avx2 {
ScreenKernels screen_kernels();
}  // namespace isa_avx2
namespace isa_avx512 {
ScreenKernels screen_kernels();
}  // namespace isa_avx512

}  // namespace overbend
