#include "recording/design_screen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/simd.h"

namespace overbend {
namespace {

/// Relative margin of a bound, far above its rounding [-].
constexpr double kRoundingMargin = 1e-12;

ScreenKernels kernels() {
#if defined(OVERBEND_X86_KERNELS)
  if (best_isa() == Isa::avx512) return isa_avx512::screen_kernels();
  if (best_isa() == Isa::avx2) return isa_avx2::screen_kernels();
#endif
  return isa_baseline::screen_kernels();
}

/// View of the columns from node `first` on.
VectorsView make_view(const VectorColumns& columns, std::size_t first) {
  return {columns.x.data() + first, columns.y.data() + first, columns.z.data() + first};
}

int node_count(const SectionRun& run) {
  return static_cast<int>(run.last - run.first);
}

}  // namespace

DesignScreen::DesignScreen(std::size_t nodes, std::vector<LoadFactors> combinations)
    : kernels_(kernels()), combinations_(std::move(combinations)) {
  for (Limits& limits : limits_) {
    limits.load.assign(nodes, 0.0);
    limits.slope.assign(nodes, 0.0);
    limits.strain.assign(nodes, -1.0);
  }
  for (std::vector<double>* column :
       {&functional_, &environmental_, &both_, &size_, &force_, &load_excess_, &strain_excess_}) {
    column->assign(nodes, 0.0);
  }
  strain_.resize(nodes);
}

void DesignScreen::keep_load(std::size_t of_class, std::size_t node, double utilisation) {
  limits_[of_class].load[node] = (1.0 - kRoundingMargin) * utilisation;
}

/// x^0.8 <= 0.2 x0^0.8 + 0.8 x0^-0.2 x for any x0 > 0; under internal overpressure the criterion has x instead of
/// x^0.8, which is larger only above 1.
void DesignScreen::keep_strain(std::size_t of_class, std::size_t node, double utilisation, double strain,
                               const StrainCapacity& capacity) {
  Limits& limits = limits_[of_class];
  const double x = capacity.strain_factor * strain;
  if (!(x > 0.0)) {
    limits.slope[node] = 0.0;
    limits.strain[node] = -1.0;
    return;
  }
  const double power = std::pow(x, 0.8);
  limits.slope[node] = 0.8 * power / strain;
  limits.strain[node] = utilisation - 0.2 * power - kRoundingMargin * (utilisation + power);
}

/// Squares and product of the rotated functional parts and of the environmental parts, and the design sizes.
void DesignScreen::find_sizes(const SectionRun& run, const VectorColumns& functional,
                              const FunctionalEffects& static_state, const VectorColumns& present,
                              const VectorColumns& tangents) {
  const std::size_t first = run.first;
  const EffectParts parts{functional_.data() + first, environmental_.data() + first, both_.data() + first};
  const EffectView effect{make_view(functional, first), make_view(present, first),
                          make_view(static_state.tangent, first), make_view(tangents, first)};
  kernels_.split(effect, node_count(run), parts);
  kernels_.sizes(combinations(), parts, node_count(run), size_.data() + first);
}

CombinationsView DesignScreen::combinations() const {
  return {combinations_.data(), static_cast<int>(combinations_.size())};
}

void DesignScreen::raise_forces(const SectionRun& run, std::vector<double>& max_force) const {
  const double* force = force_.data();
  double* max = max_force.data();
#pragma GCC ivdep
  for (std::size_t i = run.first; i < run.last; ++i) max[i] = std::max(max[i], force[i]);
}

void DesignScreen::find_loads(const SectionRun& run, const SectionOfClasses& sections,
                              const FunctionalEffects& static_state, const PresentEffects& present,
                              const std::vector<double>& overpressure) {
  find_sizes(run, static_state.moment, static_state, present.moments, present.tangents);
  const std::size_t first = run.first;
  kernels_.forces(combinations(), static_state.force.data() + first, present.force.data() + first, node_count(run),
                  force_.data() + first);
  const double* pressure = overpressure.data();
  double* excess = load_excess_.data();
  for (std::size_t of_class = 0; of_class < kSafetyClasses; ++of_class) {
    const LoadCapacity& capacity = sections[of_class]->load;
    const LoadBound bound{capacity.moment_factor, capacity.tension_factor, capacity.collapse_factor,
                          limits_[of_class].load.data() + first};
    kernels_.load_excess(bound, size_.data() + first, force_.data() + first, pressure + first, node_count(run),
                         of_class == 0, excess + first);
  }
  // Internal overpressure has another formula: evaluated exactly.
#pragma GCC ivdep
  for (std::size_t i = run.first; i < run.last; ++i) excess[i] = pressure[i] < 0.0 ? 1.0 : excess[i];
}

void DesignScreen::find_strains(const SectionRun& run, const SectionOfClasses& sections,
                                const FunctionalEffects& static_state, const PresentEffects& present,
                                const std::vector<double>& overpressure) {
  const std::size_t first = run.first;
  kernels_.strain_vectors(make_view(present.moments, first), present.strain.data() + first, node_count(run),
                          strain_.x.data() + first, strain_.y.data() + first, strain_.z.data() + first);
  find_sizes(run, static_state.strain, static_state, strain_, present.tangents);
  for (std::size_t of_class = 0; of_class < kSafetyClasses; ++of_class) {
    const StrainCapacity& capacity = sections[of_class]->strain;
    const Limits& limits = limits_[of_class];
    const StrainBound bound{sections[of_class]->strain_factor, capacity.strain_factor, capacity.collapse_factor,
                            limits.slope.data() + first, limits.strain.data() + first};
    kernels_.strain_excess(bound, size_.data() + first, overpressure.data() + first, node_count(run), of_class == 0,
                           strain_excess_.data() + first);
  }
}

}  // namespace overbend
