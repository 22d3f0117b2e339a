/// Impacts of the pipe on rollers: detection, time resolution, records.
#pragma once

#include <vector>

#include "results/dynamic_results.h"
#include "system/roller_contacts.h"

namespace overbend {

/// Settings of impact detection and resolution.
struct ImpactSettings {
  bool captured = false;     ///< Impacts do not limit the steps; their peak force is estimated.
  double steps = 16.0;       ///< Number of steps per undamped contact time pi sqrt(m / k).
  double min_force = 1.0e3;  ///< Impacts with v sqrt(k m) below this are not resolved nor recorded [N].
};

/// An impact that is over.
struct EndedImpact {
  Impact impact;
  double box_force = 0.0;  ///< Total load on the box at the peak, estimated for captured impacts [N].
};

/// Limit on the next step.
struct ImpactLimit {
  bool reject = false;  ///< The step is too long for an impact that it ran into.
  double step = 1e300;  ///< Maximum step [s]; if rejected, up to the first touch.
};

/// Tracks the contact of every roller from step to step.
class ImpactTracker {
 public:
  ImpactTracker(const std::vector<BodyRoller>& rollers, const ImpactSettings& settings);

  /// Checks a step of `h` that led to `contacts` before it is accepted.
  ImpactLimit check(const std::vector<RollerContact>& contacts, double h) const;
  /// Records an accepted step. Appends the impacts that end with it to `ended`, which has capacity for all rollers.
  void accept(const std::vector<RollerContact>& contacts, double time, double h, std::vector<EndedImpact>& ended);
  /// Maximum step during impacts and up to the next predicted touch [s].
  double step_limit() const { return step_limit_; }

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  struct Track {
    double penetration = -1.0;  ///< After the last step [m].
    double force = 0.0;         ///< Normal force after the last step [N].
    double rate = 0.0;          ///< Penetration rate after the last step [m/s].
    bool open = false;          ///< True during an impact.
    bool begun = false;         ///< True if it began with the last step.
    Impact impact;
    double box_force = 0.0;  ///< See EndedImpact [N].
  };

  double contact_time(std::size_t roller) const;
  double undamped_force(std::size_t roller, double velocity) const;
  bool exceeds_min_force(std::size_t roller, double velocity) const;
  Impact make_impact(std::size_t roller, const RollerContact& contact, double time, double h) const;
  double time_to_touch(std::size_t roller, const RollerContact& contact, double h) const;
  double max_step_during_impact(const Impact& impact, double force) const;
  double peak_box_load(std::size_t roller, const std::vector<RollerContact>& contacts) const;

  const std::vector<BodyRoller>* rollers_;
  ImpactSettings settings_;
  std::vector<Track> tracks_;
  double step_limit_ = 1e300;
};

}  // namespace overbend
