/// What the checks need of a station, for the static state or over a dynamic run.
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

/// Static load effects by origin, in the vertical plane of the pipe and out of it, and the load factors that govern.
struct FactoredEffects {
  Vec3 functional = Vec3::Zero(), current = Vec3::Zero();                ///< Bending moment [N m].
  Vec3 functional_strain = Vec3::Zero(), current_strain = Vec3::Zero();  ///< Along the moments [-].
  double tension = 0.0;                                                  ///< Of the current [N].
  LoadFactors load_factors, strain_factors;  ///< Of the governing combination, load and displacement controlled.
};

struct CheckStation {
  std::size_t section = 0;
  CheckRegion region = CheckRegion::sagbend;
  bool leaves = false;  ///< The last over the supports: of the stinger tip as well.
  bool lands = false;   ///< The first above the bed: of the seabed as well.
  double s = 0.0, from_top = 0.0;
  Vec3 p_W = Vec3::Zero();
  double external_pressure = 0.0;  ///< At the static place [Pa].
  double overpressure = 0.0;       ///< External over internal pressure at the static place [Pa].
  // The static state. Functional load effects are moment and force: without what is the current's where that is apart.
  double moment = 0.0, force = 0.0, strain = 0.0, von_mises = 0.0;
  FactoredEffects effects;  ///< Only of a static table.
  // Load controlled, where it is used most.
  Timed load;
  double roller_force = 0.0;  ///< Of a static table where rollers reduce the plastic moment [N].
  double design_moment = 0.0, design_force = 0.0, load_pressure = 0.0, share = 1.0, largest_force = 0.0;
  // Displacement controlled, likewise.
  Timed bend;
  double design_strain = 0.0, bend_pressure = 0.0;
  // Without load factors: the largest of static state or run.
  Timed largest_von_mises, largest_strain, largest_tension;
};

/// Whether a station counts in a region.
inline bool counts_in(const CheckStation& station, CheckRegion region) {
  return region == CheckRegion::line || station.region == region || (region == CheckRegion::tip && station.leaves) ||
         (region == CheckRegion::seabed && station.lands);
}

struct CheckStations {
  std::string line;  ///< Name of a line by itself; empty: the laid pipe.
  std::vector<CheckSection> sections;
  std::vector<CheckStation> stations;
  bool in_time = false;
  double duration = 0.0;          ///< Of the run [s].
  bool current_separate = false;  ///< The current's part of the static state counts as environmental.

  const CheckSection& section_of(const CheckStation& station) const { return sections[station.section]; }
};

/// Fills the design load effects of a state that does not move: the largest of the combinations.
void factor_static(CheckStation& station, const CheckSection& section, const std::vector<LoadFactors>& combinations);

/// Section that a node of a run is checked with, where two meet the one whose stresses it has.
std::size_t section_of_node(const Model& model, double from_top);

/// Stations of the static state, those of a cable left out: design load effects are the factored static ones.
CheckStations static_stations(const Model& model, const StaticResults& statics);

/// Stations of a run, those of a cable left out: design load effects as the run gathered them.
CheckStations dynamic_stations(const Model& model, const StaticResults& statics, const DynamicResults& dynamics);

}  // namespace overbend
