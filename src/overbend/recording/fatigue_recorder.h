/// Fatigue of girth welds: stress cycles at eight points around the section at every station, counted during the run.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "checks/fatigue_spot.h"
#include "numerics/rainflow.h"
#include "recording/design_recorder.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Stress ranges below this are not counted [Pa].
inline constexpr double kMinStressRange = 0.1e6;

class FatigueRecorder {
 public:
  /// Counts from station `first` on; `section_of_station` of all stations.
  FatigueRecorder(const Model& model, const std::vector<int>& section_of_station, std::size_t first);

  /// Sets the static state, which determines the positions of the points around the section.
  void start(const DesignInstant& instant);
  /// Adds an accepted step after t = 0. Allocates nothing.
  void step(const DesignInstant& instant);

  /// Fills the results by station from `first` on, after envelopes and stations. Does nothing if no time has passed.
  void fill(DynamicResults& results) const;
  std::vector<double> save() const;
  void restore(std::span<const double> saved);

 private:
  static constexpr std::size_t kPoints = 8;  ///< Around the section, 45 degrees apart.

  /// Conversion of the loads of a station into stress.
  struct Station {
    const Section* section = nullptr;  ///< Null for a cable, which has no welds.
    double per_moment = 0.0;           ///< Stress per bending moment and radius, including field joints [N/m4].
    std::array<double, 2> radius{};    ///< Radii of the outer and the inner surface [m].
    Vec3 aside = Vec3::UnitY();        ///< Horizontal direction across the pipe in the static state, W.
  };
  /// Sums of the points: damage for each spot, and cycles.
  struct Sums {
    std::vector<std::vector<double>> damage;  ///< By spot.
    std::vector<double> cycles;               ///< By record.
  };

  void place_spots(const DesignInstant& instant);
  void find_stress(const DesignInstant& instant);
  void count(Sums& sums, std::size_t record, const RainflowCycle& cycle) const;
  FatigueSpot make_spot(std::size_t spot, const Sums& sums) const;
  std::size_t stations() const { return stations_.size(); }

  const Model* model_;
  const FatigueDescription* fatigue_;
  std::size_t first_;
  std::vector<FatigueSpotDescription> spots_;
  std::vector<std::size_t> surface_of_spot_;  ///< Index among the surfaces in use.
  std::vector<bool> surfaces_;                ///< Surfaces in use; true for the inner one.
  std::vector<Station> stations_;
  std::vector<std::vector<FatiguePlace>> places_;  ///< By spot and station.
  std::vector<double> stress_;                     ///< By surface, station and point [Pa].
  RainflowCounter counter_;
  Sums sums_;
  double time_ = 0.0;  ///< Time counted so far [s].
};

}  // namespace overbend
