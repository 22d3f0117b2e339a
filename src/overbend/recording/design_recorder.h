/// Design load effects of the code checks at every node and accepted step: the maximum utilisations of a run, for every
/// safety class.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "checks/check_section.h"
#include "checks/current_part.h"
#include "recording/design_screen.h"
#include "recording/node_recovery.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Input of the design recorder at one step.
struct DesignInstant {
  const NodeValues& nodes;
  const VectorColumns& moments;             ///< Bending moment at every node as a vector, W [N m].
  const VectorColumns& tangents;            ///< Unit tangents, W.
  const std::vector<int>& station_of_node;  ///< Nearest station of each node of the mesh that `contacts` refers to.
  const std::vector<RollerContact>& contacts;
  double time = 0.0;
};

class DesignRecorder {
 public:
  DesignRecorder(const Model& model, const std::vector<int>& section_of_node);

  /// Sets the effect of the current on the static state at every node, which is subtracted from the functional load
  /// effects. To be called before start(); not called without that effect.
  void set_current(std::vector<CurrentPart> parts) { current_ = std::move(parts); }
  /// Sets the present sections at the stations, if the pipe moves through them.
  void set_sections(const std::vector<int>& section_of_node);
  /// Sets the static state, which gives the functional load effects.
  void start(const DesignInstant& instant);
  /// Adds an accepted step after t = 0. Allocates nothing.
  void step(const DesignInstant& instant);

  /// Fills the results from node `first` on.
  void fill(StationDesign& design, std::size_t first) const;
  std::vector<double> save() const;
  void restore(std::span<const double> saved);

 private:
  void find_rollers(const DesignInstant& instant);
  void find_overpressure(const DesignInstant& instant);
  void keep_times(const DesignInstant& instant);
  void step_run(const DesignInstant& instant, const SectionRun& run);
  void step_load(const DesignInstant& instant, std::size_t node);
  void step_strain(const DesignInstant& instant, std::size_t node);
  SectionOfClasses section_of_classes(std::size_t section) const;
  void set_limits(std::size_t node);

  /// Load effect of one instant and combination of load factors.
  struct LoadEffect {
    double moment, force, pressure, share, time;
  };
  struct StrainEffect {
    double strain, pressure, time;
  };

  const Model* model_;
  std::array<std::vector<CheckSection>, kSafetyClasses> sections_;  ///< By class, as in Model::sections.
  std::vector<LoadFactors> combinations_;
  std::vector<int> section_;  ///< Section of every node.
  std::vector<SectionRun> runs_;
  std::size_t first_supported_ = 0;  ///< Lowest node over the supports; one beyond the last without supports.

  FunctionalEffects functional_;
  std::vector<CurrentPart> current_;
  DesignScreen screen_;
  std::vector<double> roller_;        ///< Present maximum roller force at the node [N].
  std::vector<double> overpressure_;  ///< Present external minus internal pressure [Pa].

  // Numbers only, in the order of save().
  struct Peak {
    double load = 0.0, load_time = 0.0, moment = 0.0, force = 0.0, load_pressure = 0.0, share = 1.0;
    double strain = 0.0, strain_time = 0.0, design_strain = 0.0, strain_pressure = 0.0;
  };
  using Peaks = std::array<Peak, kSafetyClasses>;
  static constexpr std::size_t kPeakNumbers = 10 * kSafetyClasses;
  std::vector<Peaks> peaks_;  ///< Peaks of every node.

  /// Maxima at every node and their times.
  struct RunningMaximum {
    std::vector<double> value, time;
    RunningMaximum(std::size_t nodes, double initial) : value(nodes, initial), time(nodes, 0.0) {}
    void keep(const std::vector<double>& values, double present_time);
  };
  std::vector<double> max_force_;
  RunningMaximum von_mises_, fibre_strain_, tension_;
  static constexpr std::size_t kStationNumbers = kPeakNumbers + 7;

  static bool keep_load(Peak& peak, const CheckSection& section, const LoadEffect& effect);
  static bool keep_strain(Peak& peak, const CheckSection& section, const StrainEffect& effect);
  void fill_peaks(DesignPeaks& out, std::size_t of_class, std::size_t first) const;
};

}  // namespace overbend
