/// Fatigue of girth welds: stress cycles at eight points round the section at every station, counted as they come.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "checks/fatigue_place.h"
#include "numerics/rainflow.h"
#include "recording/design_recorder.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Stress ranges smaller than this do not count [Pa].
inline constexpr double kLeastStressRange = 0.1e6;

class FatigueRecorder {
 public:
  /// Counts from station `first` on; `section_of_station` of all.
  FatigueRecorder(const Model& model, const std::vector<int>& section_of_station, std::size_t first);

  /// The static state: says where round the section the points are.
  void start(const DesignInstant& at);
  /// An accepted step after t = 0. Nothing is allocated.
  void step(const DesignInstant& at);

  /// Results by station from `first` on; after envelopes and stations are filled. Nothing where no time has passed.
  void fill(DynamicResults& results) const;
  std::vector<double> save() const;
  void restore(std::span<const double> saved);

 private:
  static constexpr std::size_t kPoints = 8;  ///< Round the section, 45 degrees apart.

  /// What turns loads of a station into stress.
  struct Station {
    const Section* section = nullptr;  ///< Null for a cable, which has no welds.
    double per_moment = 0.0;           ///< Stress per bending moment and radius, field joints included [N/m4].
    std::array<double, 2> radius{};    ///< Of the outer and the inner surface [m].
    Vec3 aside = Vec3::UnitY();        ///< Level across the pipe in the static state, W.
  };
  /// Sums of a point: of damage for each spot, and of cycles.
  struct Sums {
    std::vector<std::vector<double>> damage;  ///< By spot.
    std::vector<double> cycles;               ///< By record.
  };

  void place_spots(const DesignInstant& at);
  void find_stress(const DesignInstant& at);
  void count(Sums& sums, std::size_t record, const RainflowCycle& cycle) const;
  FatigueSpot spot_of(std::size_t spot, const Sums& sums) const;
  std::size_t stations() const { return stations_.size(); }

  const Model* model_;
  const FatigueDescription* fatigue_;
  std::size_t first_;
  std::vector<FatigueSpotDescription> spots_;
  std::vector<std::size_t> surface_of_spot_;  ///< Index among the surfaces in use.
  std::vector<bool> surfaces_;                ///< In use; whether it is the inner one.
  std::vector<Station> stations_;
  std::vector<std::vector<FatiguePlace>> places_;  ///< By spot and station.
  std::vector<double> stress_;                     ///< By surface, station and point [Pa].
  RainflowCounter counter_;
  Sums sums_;
  double time_ = 0.0;  ///< Counted so far [s].
};

}  // namespace overbend
