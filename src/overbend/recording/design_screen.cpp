#include "recording/design_screen.h"

#include <algorithm>
#include <cmath>
#include <utility>

// In the loops below arrays do not overlap, as the compiler is told, and nothing branches: it makes vectors of them.

namespace overbend {
namespace {

/// What rounding may do to a bound, relative. Far more than it does.
constexpr double kRoundingMargin = 1e-12;

/// As carried() of checks/load_effects.h.
inline Parts carried_along(const Parts& v, const Parts& from, const Parts& to) {
  const double opposite = 1.0 + dot(from, to);
  const double along = dot(v, to) / opposite;
  return v - (opposite > 1e-6 ? along : 0.0) * (from + to);
}

}  // namespace

DesignScreen::DesignScreen(std::size_t nodes, std::vector<LoadFactors> combinations)
    : combinations_(std::move(combinations)) {
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

/// x^0.8 <= 0.2 x0^0.8 + 0.8 x0^-0.2 x for any x0 > 0; under internal overpressure x itself stands for x^0.8, which is
/// more above 1 alone.
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

/// The largest fibre strain as a vector along the bending moment, as strain_vector() has it.
void DesignScreen::put_strain_vectors(const SectionRun& run, const PresentEffects& now) {
  const ConstColumns moment(now.moments);
  const PlainColumns vector(strain_);
  const double* strain = now.strain.data();
#pragma GCC ivdep
  for (std::size_t i = run.first; i < run.last; ++i) {
    const Parts m = moment.at(i);
    const double size = length(m);
    const Parts along = (strain[i] / size) * m;
    vector.put(i, {size > 0.0 ? along.x : 0.0, size > 0.0 ? along.y : 0.0, size > 0.0 ? along.z : strain[i]});
  }
}

/// As design_size() of checks/load_effects.h, the largest over all combinations.
void DesignScreen::find_sizes(const SectionRun& run) {
  const double* a = functional_.data();
  const double* b = environmental_.data();
  const double* ab = both_.data();
  double* size = size_.data();
  std::fill(size_.begin() + static_cast<std::ptrdiff_t>(run.first),
            size_.begin() + static_cast<std::ptrdiff_t>(run.last), 0.0);
  for (const LoadFactors& f : combinations_) {
    const double F = f.functional, f_favourable = f.functional_favourable;
    const double E = f.environmental, e_favourable = f.environmental_favourable;
#pragma GCC ivdep
    for (std::size_t i = run.first; i < run.last; ++i) {
      const auto squared = [a = a[i], b = b[i], ab = ab[i]](double of_a, double of_b) {
        return of_a * of_a * a + 2.0 * of_a * of_b * ab + of_b * of_b * b;
      };
      const double one = std::max(squared(F, E), squared(F, e_favourable));
      const double two = std::max(squared(f_favourable, E), squared(f_favourable, e_favourable));
      size[i] = std::max(size[i], std::max(one, two));
    }
  }
#pragma GCC ivdep
  for (std::size_t i = run.first; i < run.last; ++i) size[i] = std::sqrt(size[i]);
}

/// Squares and product of what is added to the carried functional parts of the nodes of `run`.
void DesignScreen::part(const SectionRun& run, const VectorColumns& functional, const FunctionalEffects& still,
                        const VectorColumns& present, const VectorColumns& tangents) {
  const ConstColumns before(functional), from(still.tangent), now(present), to(tangents);
  double* a = functional_.data();
  double* b = environmental_.data();
  double* ab = both_.data();
#pragma GCC ivdep
  for (std::size_t i = run.first; i < run.last; ++i) {
    const Parts carried = carried_along(before.at(i), from.at(i), to.at(i));
    const Parts added = now.at(i) - carried;
    a[i] = dot(carried, carried);
    b[i] = dot(added, added);
    ab[i] = dot(carried, added);
  }
}

/// As design_value() of checks/load_effects.h, its magnitude, the largest over all combinations.
void DesignScreen::find_forces(const SectionRun& run, const std::vector<double>& still,
                               const std::vector<double>& present) {
  const double* before = still.data();
  const double* now = present.data();
  double* force = force_.data();
  std::fill(force_.begin() + static_cast<std::ptrdiff_t>(run.first),
            force_.begin() + static_cast<std::ptrdiff_t>(run.last), 0.0);
  for (const LoadFactors& f : combinations_) {
    const double F = f.functional, f_favourable = f.functional_favourable;
    const double E = f.environmental, e_favourable = f.environmental_favourable;
#pragma GCC ivdep
    for (std::size_t i = run.first; i < run.last; ++i) {
      const double added = now[i] - before[i];
      const double one = std::max(std::abs(F * before[i] + E * added), std::abs(F * before[i] + e_favourable * added));
      const double two = std::max(std::abs(f_favourable * before[i] + E * added),
                                  std::abs(f_favourable * before[i] + e_favourable * added));
      force[i] = std::max(force[i], std::max(one, two));
    }
  }
}

void DesignScreen::raise_forces(const SectionRun& run, std::vector<double>& largest) const {
  const double* force = force_.data();
  double* most = largest.data();
#pragma GCC ivdep
  for (std::size_t i = run.first; i < run.last; ++i) most[i] = std::max(most[i], force[i]);
}

void DesignScreen::find_loads(const SectionRun& run, const SectionOfClasses& sections, const FunctionalEffects& still,
                              const PresentEffects& now, const std::vector<double>& overpressure) {
  part(run, still.moment, still, now.moments, now.tangents);
  find_sizes(run);
  find_forces(run, still.force, now.force);
  const double* moment = size_.data();
  const double* force = force_.data();
  const double* pressure = overpressure.data();
  double* excess = load_excess_.data();
  for (std::size_t of_class = 0; of_class < kSafetyClasses; ++of_class) {
    const LoadCapacity capacity = sections[of_class]->load;
    const double* limit = limits_[of_class].load.data();
#pragma GCC ivdep
    for (std::size_t i = run.first; i < run.last; ++i) {
      const double axial = capacity.tension_factor * force[i];
      const double bracket = capacity.moment_factor * moment[i] + axial * axial;
      const double pressed = capacity.collapse_factor * pressure[i];
      const double above = bracket * bracket + pressed * pressed - limit[i];
      excess[i] = of_class == 0 ? above : std::max(excess[i], above);
    }
  }
  // Internal overpressure has another formula, for a closer look.
#pragma GCC ivdep
  for (std::size_t i = run.first; i < run.last; ++i) excess[i] = pressure[i] < 0.0 ? 1.0 : excess[i];
}

void DesignScreen::find_strains(const SectionRun& run, const SectionOfClasses& sections, const FunctionalEffects& still,
                                const PresentEffects& now, const std::vector<double>& overpressure) {
  put_strain_vectors(run, now);
  part(run, still.strain, still, strain_, now.tangents);
  find_sizes(run);
  const double* size = size_.data();
  const double* pressure = overpressure.data();
  double* excess = strain_excess_.data();
  for (std::size_t of_class = 0; of_class < kSafetyClasses; ++of_class) {
    const StrainCapacity capacity = sections[of_class]->strain;
    const double factor = sections[of_class]->strain_factor;
    const double* slope = limits_[of_class].slope.data();
    const double* limit = limits_[of_class].strain.data();
#pragma GCC ivdep
    for (std::size_t i = run.first; i < run.last; ++i) {
      const double strain = factor * size[i];
      const double below = slope[i] * strain + capacity.collapse_factor * std::max(pressure[i], 0.0) - limit[i];
      const double above = std::max(below, capacity.strain_factor * strain - 1.0);
      excess[i] = of_class == 0 ? above : std::max(excess[i], above);
    }
  }
}

}  // namespace overbend
