/// Design load effects of the code checks at every node, every accepted step: the largest utilisations of a run, for
/// every safety class.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "checks/check_section.h"
#include "checks/current_part.h"
#include "recording/dynamic_stations.h"
#include "results/dynamic_results.h"

namespace overbend {

/// A step as the design recorder is told of it.
struct DesignInstant {
  const NodeValues& nodes;
  const std::vector<Vec3>& moments;         ///< Bending moment at every node as a vector, W [N m].
  const std::vector<Vec3>& tangents;        ///< Unit, W.
  const std::vector<int>& station_of_node;  ///< Of the mesh that contacts tell of.
  const std::vector<RollerContact>& contacts;
  double time = 0.0;
};

class DesignRecorder {
 public:
  DesignRecorder(const Model& model, const std::vector<int>& section_of_node);

  /// What the current adds to the static state, at every node: it is taken off the functional load effects. Before
  /// start(); none where it is not told.
  void set_current(std::vector<CurrentPart> parts) { current_ = std::move(parts); }
  /// What stands at the stations now, where pipe moves through them.
  void set_sections(const std::vector<int>& section_of_node) {
    std::copy(section_of_node.begin(), section_of_node.end(), section_.begin());
  }
  /// The static state: the functional load effects.
  void start(const DesignInstant& at);
  /// An accepted step after t = 0. Nothing is allocated.
  void step(const DesignInstant& at);

  /// From node `first` on.
  void fill(StationDesign& design, std::size_t first) const;
  std::vector<double> save() const;
  void restore(std::span<const double> saved);

 private:
  void find_rollers(const DesignInstant& at);
  void step_load(const DesignInstant& at, std::size_t node);
  void step_strain(const DesignInstant& at, std::size_t node);
  void step_times(const DesignInstant& at, std::size_t node);
  double overpressure(const DesignInstant& at, std::size_t node) const;

  /// Of one instant and combination of load factors.
  struct LoadEffect {
    double moment, force, pressure, share, time;
  };
  struct StrainEffect {
    double strain, pressure, time;
  };

  const Model* model_;
  std::array<std::vector<CheckSection>, kSafetyClasses> sections_;  ///< By class, as in Model::sections.
  std::vector<LoadFactors> combinations_;
  std::vector<std::size_t> section_;  ///< Of every node.
  std::size_t first_supported_ = 0;   ///< Lowest node over the supports; one beyond the last without supports.

  struct Functional {
    Vec3 moment = Vec3::Zero(), strain = Vec3::Zero(), tangent = Vec3::UnitX();
    double force = 0.0;
  };
  std::vector<Functional> functional_;
  std::vector<CurrentPart> current_;
  std::vector<double> roller_;  ///< Largest roller force at the node now [N].

  // Numbers only, in the order of save().
  struct Peak {
    double load = 0.0, load_time = 0.0, moment = 0.0, force = 0.0, load_pressure = 0.0, share = 1.0;
    double strain = 0.0, strain_time = 0.0, design_strain = 0.0, strain_pressure = 0.0;
  };
  struct Station {
    std::array<Peak, kSafetyClasses> peaks;
    double largest_force = 0.0;
    double von_mises = -1.0, von_mises_time = 0.0, fibre_strain = -1.0, fibre_strain_time = 0.0;
    double tension = -1e300, tension_time = 0.0;
  };
  static constexpr std::size_t kStationNumbers = 10 * kSafetyClasses + 7;
  std::vector<Station> stations_;

  static void keep_load(Peak& peak, const CheckSection& section, const LoadEffect& effect);
  static void keep_strain(Peak& peak, const CheckSection& section, const StrainEffect& effect);
  void fill_peaks(DesignPeaks& out, std::size_t of_class, std::size_t first) const;
};

}  // namespace overbend
