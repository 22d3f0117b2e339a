/// Screening of nodes whose code checks may exceed their previous maxima: upper bounds for the whole line at once, so
/// that only those nodes are evaluated exactly.
///
/// The load criterion increases with moment, |force| and pressure, so that the maximum of each over the combinations of
/// load factors bounds it. The strain criterion x^0.8 + p lies below its tangents in x: a product instead of a power.
/// Bounds have a margin for rounding.
#pragma once

#include <array>
#include <vector>

#include "checks/check_section.h"
#include "recording/design_screen_kernel.h"
#include "recording/node_recovery.h"
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

  /// Screens the nodes of `run`, with `overpressure` p_e - p_i at all nodes [Pa]. Point loads of rollers are left out.
  void find_loads(const SectionRun& run, const SectionOfClasses& sections, const FunctionalEffects& static_state,
                  const PresentEffects& present, const std::vector<double>& overpressure);
  /// Screens the strain criterion in the same way.
  void find_strains(const SectionRun& run, const SectionOfClasses& sections, const FunctionalEffects& static_state,
                    const PresentEffects& present, const std::vector<double>& overpressure);

  /// Raises `largest` to the maximum magnitude of the design force over all combinations, in the last screened state
  /// [N].
  void raise_forces(const SectionRun& run, std::vector<double>& max_force) const;
  // True if a utilisation may exceed its previous maximum, in the last screened state.
  bool loads_more(std::size_t node) const { return load_excess_[node] > 0.0; }
  bool strains_more(std::size_t node) const { return strain_excess_[node] > 0.0; }

  /// Sets the maximum utilisation of a node so far, by the load criterion.
  void keep_load(std::size_t of_class, std::size_t node, double utilisation);
  /// Sets it by the strain criterion, with its design strain, for the node's section.
  void keep_strain(std::size_t of_class, std::size_t node, double utilisation, double strain,
                   const StrainCapacity& capacity);

 private:
  void find_sizes(const SectionRun& run, const VectorColumns& functional, const FunctionalEffects& static_state,
                  const VectorColumns& present, const VectorColumns& tangents);
  CombinationsView combinations() const;

  ScreenKernels kernels_;
  std::vector<LoadFactors> combinations_;
  /// Values below these limits need no exact evaluation: for the load criterion the utilisation; for the strain
  /// criterion slope times design strain plus the pressure part.
  struct Limits {
    std::vector<double> load, slope, strain;
  };
  std::array<Limits, kSafetyClasses> limits_;
  // Last screened state: squares and product of functional and environmental part, maximum design size.
  std::vector<double> functional_, environmental_, both_, size_, force_;
  VectorColumns strain_;
  std::vector<double> load_excess_, strain_excess_;
};

}  // namespace overbend
