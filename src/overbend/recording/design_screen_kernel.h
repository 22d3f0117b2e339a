/// The loops of the design screen over the nodes of a run. Compiled once per instruction set; raw pointers only, see
/// wave_kernel.h. Arrays that are written overlap no other.
#pragma once

#include "checks/load_factors.h"

namespace overbend {

/// Vectors at many nodes.
struct VectorsView {
  const double *x, *y, *z;
};

/// A load effect now and in the static state, with the pipe's tangents then and now.
struct EffectView {
  VectorsView still, now, still_tangent, tangent;
};

/// Of the functional part of an effect, which has turned with the pipe, and what the environment adds to it: squares
/// and product.
struct EffectParts {
  double *functional, *environmental, *both;
};

struct CombinationsView {
  const LoadFactors* factors;
  int count;
};

/// What of the capacity of a class bounds its utilisation, see design_screen.h.
struct LoadBound {
  double moment_factor, tension_factor, collapse_factor;
  const double* limit;
};
struct StrainBound {
  double strain_factor;           ///< Of the design strain itself.
  double utilisation_per_strain;  ///< [-]
  double collapse_factor;
  const double *slope, *limit;
};

/// The kernels of one instruction set. `excess` becomes the largest over the classes: `first` begins anew.
struct ScreenKernels {
  void (*split)(const EffectView& effect, int count, const EffectParts& parts);
  /// Strains as vectors along the bending moment; along z where there is none.
  void (*strain_vectors)(const VectorsView& moment, const double* strain, int count, double* x, double* y, double* z);
  /// The largest design size over all combinations, as design_size() of checks/load_effects.h.
  void (*sizes)(const CombinationsView& all, const EffectParts& parts, int count, double* size);
  /// The largest magnitude of a design force, as design_value() there.
  void (*forces)(const CombinationsView& all, const double* still, const double* now, int count, double* force);
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
