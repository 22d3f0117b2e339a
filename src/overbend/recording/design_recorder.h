/// Design load effects of the code checks at every node, every accepted step: the largest utilisations of a run, for
/// every safety class.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "checks/check_section.h"
#include "checks/current_part.h"
#include "recording/design_screen.h"
#include "recording/dynamic_stations.h"
#include "results/dynamic_results.h"

namespace overbend {

/// A step as the design recorder is told of it.
struct DesignInstant {
  const NodeValues& nodes;
  const VectorColumns& moments;             ///< Bending moment at every node as a vector, W [N m].
  const VectorColumns& tangents;            ///< Unit, W.
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
  void set_sections(const std::vector<int>& section_of_node);
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
  void find_overpressure(const DesignInstant& at);
  void keep_times(const DesignInstant& at);
  void step_run(const DesignInstant& at, const SectionRun& run);
  void step_load(const DesignInstant& at, std::size_t node);
  void step_strain(const DesignInstant& at, std::size_t node);
  SectionOfClasses section_of_classes(std::size_t section) const;
  void set_limits(std::size_t node);

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
  std::vector<int> section_;  ///< Of every node.
  std::vector<SectionRun> runs_;
  std::size_t first_supported_ = 0;  ///< Lowest node over the supports; one beyond the last without supports.

  FunctionalEffects functional_;
  std::vector<CurrentPart> current_;
  DesignScreen screen_;
  std::vector<double> roller_;        ///< Largest roller force at the node now [N].
  std::vector<double> overpressure_;  ///< External less internal pressure now [Pa].

  // Numbers only, in the order of save().
  struct Peak {
    double load = 0.0, load_time = 0.0, moment = 0.0, force = 0.0, load_pressure = 0.0, share = 1.0;
    double strain = 0.0, strain_time = 0.0, design_strain = 0.0, strain_pressure = 0.0;
  };
  using Peaks = std::array<Peak, kSafetyClasses>;
  static constexpr std::size_t kPeakNumbers = 10 * kSafetyClasses;
  std::vector<Peaks> peaks_;  ///< Of every node.

  /// The largest so far at every node, and when it was.
  struct Largest {
    std::vector<double> value, time;
    Largest(std::size_t nodes, double least) : value(nodes, least), time(nodes, 0.0) {}
    void keep(const std::vector<double>& values, double now);
  };
  std::vector<double> largest_force_;
  Largest von_mises_, fibre_strain_, tension_;
  static constexpr std::size_t kStationNumbers = kPeakNumbers + 7;

  static bool keep_load(Peak& peak, const CheckSection& section, const LoadEffect& effect);
  static bool keep_strain(Peak& peak, const CheckSection& section, const StrainEffect& effect);
  void fill_peaks(DesignPeaks& out, std::size_t of_class, std::size_t first) const;
};

}  // namespace overbend
