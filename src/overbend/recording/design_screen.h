/// At which nodes a code check may be used more than ever before: found for the whole line at once and from above, so
/// that only those are looked at closely.
///
/// The load criterion grows with moment, |force| and pressure, so that the largest of each over the combinations of
/// load factors bounds it. The strain criterion x^0.8 + p lies below its tangents in x: a product instead of a power.
/// Bounds have a margin for rounding.
#pragma once

#include <array>
#include <vector>

#include "checks/check_section.h"
#include "recording/design_screen_kernel.h"
#include "recording/dynamic_stations.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Load effects of the static state at all nodes.
struct FunctionalEffects {
  VectorColumns moment, strain, tangent;  ///< [N m], [-], unit; W.
  std::vector<double> force;              ///< [N]

  explicit FunctionalEffects(std::size_t nodes) : moment(nodes), strain(nodes), tangent(nodes), force(nodes, 0.0) {}
};

/// Load effects of an instant at all nodes.
struct PresentEffects {
  const VectorColumns &moments, &tangents;  ///< W [N m], unit.
  const std::vector<double>&strain, &force;
};

/// One section with the capacities of each safety class.
using SectionOfClasses = std::array<const CheckSection*, kSafetyClasses>;

class DesignScreen {
 public:
  DesignScreen(std::size_t nodes, std::vector<LoadFactors> combinations);

  /// Of the nodes of `run`, with `overpressure` p_e - p_i at all nodes [Pa]. Point loads of rollers are left out.
  void find_loads(const SectionRun& run, const SectionOfClasses& sections, const FunctionalEffects& still,
                  const PresentEffects& now, const std::vector<double>& overpressure);
  void find_strains(const SectionRun& run, const SectionOfClasses& sections, const FunctionalEffects& still,
                    const PresentEffects& now, const std::vector<double>& overpressure);

  /// Raises `largest` to the largest magnitude of the design force over all combinations, in the state found last [N].
  void raise_forces(const SectionRun& run, std::vector<double>& largest) const;
  // Whether a utilisation may be larger than any before, in the state found last.
  bool loads_more(std::size_t node) const { return load_excess_[node] > 0.0; }
  bool strains_more(std::size_t node) const { return strain_excess_[node] > 0.0; }

  /// The largest utilisation of a node so far, by the load criterion.
  void keep_load(std::size_t of_class, std::size_t node, double utilisation);
  /// By the strain criterion, and at which design strain, of the node's section.
  void keep_strain(std::size_t of_class, std::size_t node, double utilisation, double strain,
                   const StrainCapacity& capacity);

 private:
  void find_sizes(const SectionRun& run, const VectorColumns& functional, const FunctionalEffects& still,
                  const VectorColumns& present, const VectorColumns& tangents);
  CombinationsView combinations() const;

  ScreenKernels kernels_;
  std::vector<LoadFactors> combinations_;
  /// What is not above these needs no closer look: of the load criterion the utilisation; of the strain criterion
  /// slope times design strain plus the pressure part.
  struct Limits {
    std::vector<double> load, slope, strain;
  };
  std::array<Limits, kSafetyClasses> limits_;
  // Of the state found last: squares and product of functional and environmental part, largest design size.
  std::vector<double> functional_, environmental_, both_, size_, force_;
  VectorColumns strain_;
  std::vector<double> load_excess_, strain_excess_;
};

}  // namespace overbend
