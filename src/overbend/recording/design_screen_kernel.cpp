#include "recording/design_screen_kernel.h"

#include "base/simd.h"

// The loops have non-overlapping arrays (declared to the compiler) and no branches, so that they are vectorised.

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

struct Triple {
  double x, y, z;
};

inline Triple at(const VectorsView& v, int i) {
  return {v.x[i], v.y[i], v.z[i]};
}
inline Triple operator+(const Triple& a, const Triple& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Triple operator-(const Triple& a, const Triple& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Triple operator*(double s, const Triple& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(const Triple& a, const Triple& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double larger(double a, double b) {
  return a > b ? a : b;
}

/// Same as carried() of checks/load_effects.h.
inline Triple carried_along(const Triple& v, const Triple& from, const Triple& to) {
  const double opposite = 1.0 + dot(from, to);
  const double along = dot(v, to) / opposite;
  return v - (opposite > 1e-6 ? along : 0.0) * (from + to);
}

void split(const EffectView& effect, int count, const EffectParts& parts) {
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const Triple carried =
        carried_along(at(effect.functional, i), at(effect.functional_tangent, i), at(effect.tangent, i));
    const Triple added = at(effect.present, i) - carried;
    parts.functional[i] = dot(carried, carried);
    parts.environmental[i] = dot(added, added);
    parts.both[i] = dot(carried, added);
  }
}

void strain_vectors(const VectorsView& moment, const double* strain, int count, double* x, double* y, double* z) {
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const Triple m = at(moment, i);
    const double size = __builtin_sqrt(dot(m, m));
    const Triple along = (strain[i] / size) * m;
    x[i] = size > 0.0 ? along.x : 0.0;
    y[i] = size > 0.0 ? along.y : 0.0;
    z[i] = size > 0.0 ? along.z : strain[i];
  }
}

void sizes(const CombinationsView& all, const EffectParts& parts, int count, double* size) {
  for (int i = 0; i < count; ++i) size[i] = 0.0;
  for (int k = 0; k < all.count; ++k) {
    const LoadFactors f = all.factors[k];
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
      const double a = parts.functional[i], b = parts.environmental[i], ab = 2.0 * parts.both[i];
      const auto squared = [&](double of_a, double of_b) { return of_a * (of_a * a + of_b * ab) + of_b * of_b * b; };
      const double full =
          larger(squared(f.functional, f.environmental), squared(f.functional, f.environmental_favourable));
      const double favourable = larger(squared(f.functional_favourable, f.environmental),
                                       squared(f.functional_favourable, f.environmental_favourable));
      size[i] = larger(size[i], larger(full, favourable));
    }
  }
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) size[i] = __builtin_sqrt(size[i]);
}

void forces(const CombinationsView& all, const double* functional, const double* present, int count, double* force) {
  for (int i = 0; i < count; ++i) force[i] = 0.0;
  for (int k = 0; k < all.count; ++k) {
    const LoadFactors f = all.factors[k];
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
      const double before = functional[i], added = present[i] - before;
      const auto magnitude = [&](double of_before, double of_added) {
        return __builtin_fabs(of_before * before + of_added * added);
      };
      const double full =
          larger(magnitude(f.functional, f.environmental), magnitude(f.functional, f.environmental_favourable));
      const double favourable = larger(magnitude(f.functional_favourable, f.environmental),
                                       magnitude(f.functional_favourable, f.environmental_favourable));
      force[i] = larger(force[i], larger(full, favourable));
    }
  }
}

void load_excess(const LoadBound& bound, const double* moment, const double* force, const double* pressure, int count,
                 bool first, double* excess) {
  const LoadBound by = bound;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const double axial = by.tension_factor * force[i];
    const double bracket = by.moment_factor * moment[i] + axial * axial;
    const double pressed = by.collapse_factor * pressure[i];
    const double above = bracket * bracket + pressed * pressed - by.limit[i];
    excess[i] = first ? above : larger(excess[i], above);
  }
}

void strain_excess(const StrainBound& bound, const double* size, const double* pressure, int count, bool first,
                   double* excess) {
  const StrainBound by = bound;
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const double strain = by.strain_factor * size[i];
    const double below = by.slope[i] * strain + by.collapse_factor * larger(pressure[i], 0.0) - by.limit[i];
    const double above = larger(below, by.utilisation_per_strain * strain - 1.0);
    excess[i] = first ? above : larger(excess[i], above);
  }
}

}  // namespace

ScreenKernels screen_kernels() {
  return {split, strain_vectors, sizes, forces, load_excess, strain_excess};
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
