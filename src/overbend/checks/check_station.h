/// Input of the code checks at a station, for the static state or over a dynamic run.
#pragma once

#include <vector>

#include "checks/check_section.h"
#include "model/model.h"
#include "results/dynamic_results.h"
#include "results/static_results.h"

namespace overbend {

/// A value and its time (0 in statics).
struct Timed {
  double value = 0.0;
  double time = 0.0;
};

/// Static load effects by origin, in the vertical plane of the pipe and normal to it, and the governing load factors.
struct FactoredEffects {
  Vec3 functional = Vec3::Zero(), current = Vec3::Zero();                ///< Bending moment [N m].
  Vec3 functional_strain = Vec3::Zero(), current_strain = Vec3::Zero();  ///< Components along the moments [-].
  double tension = 0.0;                                                  ///< Tension due to the current [N].
  /// Factors of the governing combination, load and displacement controlled.
  LoadFactors load_factors, strain_factors;
};

struct CheckStation {
  std::size_t section = 0;
  CheckRegion region = CheckRegion::sagbend;
  bool leaves = false;  ///< Last station over the supports: belongs to the stinger tip as well.
  bool lands = false;   ///< First station above the seabed: belongs to the seabed as well.
  double s = 0.0, from_top = 0.0;
  Vec3 p_W = Vec3::Zero();
  double external_pressure = 0.0;  ///< At the static position [Pa].
  double overpressure = 0.0;       ///< External minus internal pressure at the static position [Pa].
  // Static state. Functional load effects, moment and force; without the contribution of the current if separated.
  double moment = 0.0, force = 0.0, strain = 0.0, von_mises = 0.0;
  FactoredEffects effects;  ///< Only for a static table.
  // Load controlled, at the instant of maximum utilisation.
  Timed load;
  double roller_force = 0.0;  ///< Only for a static table if rollers reduce the plastic moment [N].
  double design_moment = 0.0, design_force = 0.0, load_pressure = 0.0, share = 1.0, max_force = 0.0;
  // Displacement controlled, at the instant of maximum utilisation.
  Timed bend;
  double design_strain = 0.0, bend_pressure = 0.0;
  // Maxima of static state or run, without load factors.
  Timed max_von_mises, max_strain, max_tension;
};

/// True if a station belongs to a region.
inline bool counts_in(const CheckStation& station, CheckRegion region) {
  return region == CheckRegion::line || station.region == region || (region == CheckRegion::tip && station.leaves) ||
         (region == CheckRegion::seabed && station.lands);
}

struct CheckStations {
  std::string line;  ///< Name of a standalone line; empty: the laid pipe.
  std::vector<CheckSection> sections;
  std::vector<CheckStation> stations;
  bool in_time = false;
  double duration = 0.0;          ///< Duration of the run [s].
  bool current_separate = false;  ///< True if the current's part of the static state counts as environmental.

  const CheckSection& section_for(const CheckStation& station) const { return sections[station.section]; }
};

/// Sets the design load effects of a static state: the maximum over the combinations.
void factor_static(CheckStation& station, const CheckSection& section, const std::vector<LoadFactors>& combinations);

/// Returns the section used for the checks of a node of a run; where two meet, the one of its stresses.
std::size_t section_of_node(const Model& model, double from_top);

/// Returns the stations of the static state without those of a cable; design load effects are the factored static ones.
CheckStations static_stations(const Model& model, const StaticResults& statics);

/// Returns the stations of a run without those of a cable; design load effects as collected in the run.
CheckStations dynamic_stations(const Model& model, const StaticResults& statics, const DynamicResults& dynamics);

}  // namespace overbend
