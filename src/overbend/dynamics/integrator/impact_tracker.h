/// Impacts of the pipe on rollers: recognised, resolved in time, recorded.
#pragma once

#include <vector>

#include "results/dynamic_results.h"
#include "system/roller_contacts.h"

namespace overbend {

/// How impacts are followed.
struct ImpactSettings {
  bool captured = false;       ///< Within the steps that there are; their peak force is estimated.
  double steps = 16.0;         ///< Steps in the undamped contact time pi sqrt(m / k).
  double least_force = 1.0e3;  ///< Impacts with v sqrt(k m) below this are not resolved nor recorded [N].
};

struct EndedImpact {
  Impact impact;
  double box_force = 0.0;  ///< All that its box bears at the peak, where that is estimated: captured impacts [N].
};

/// What limits the next step.
struct ImpactLimit {
  bool reject = false;  ///< The step ran into an impact that it is too long for.
  double step = 1e300;  ///< Longest step, when rejected: to the first touch [s].
};

class ImpactTracker {
 public:
  ImpactTracker(const std::vector<BodyRoller>& rollers, const ImpactSettings& settings);

  /// Looks at a step of `h` that led to `contacts`, before it is accepted.
  ImpactLimit check(const std::vector<RollerContact>& contacts, double h) const;
  /// Takes an accepted step; impacts that end with it are appended to `ended` (which has room for all rollers).
  void accept(const std::vector<RollerContact>& contacts, double time, double h, std::vector<EndedImpact>& ended);
  /// Longest step while impacts go on, and to the next touch as it is foreseen [s].
  double step_limit() const { return step_limit_; }

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  struct Track {
    double penetration = -1.0;  ///< After the last step [m].
    double force = 0.0;         ///< Normal, after the last step [N].
    double rate = 0.0;          ///< Of penetration, after the last step [m/s].
    bool open = false;          ///< An impact goes on.
    bool begun = false;         ///< It began with the last step.
    Impact impact;
    double box_force = 0.0;  ///< See EndedImpact [N].
  };

  double contact_time(std::size_t roller) const;
  double undamped_force(std::size_t roller, double velocity) const;
  bool hard(std::size_t roller, double velocity) const;
  Impact touched(std::size_t roller, const RollerContact& contact, double time, double h) const;
  double time_to_touch(std::size_t roller, const RollerContact& contact, double h) const;
  double longest_in(const Impact& impact, double force) const;
  double bears(std::size_t roller, const std::vector<RollerContact>& contacts) const;

  const std::vector<BodyRoller>* rollers_;
  ImpactSettings settings_;
  std::vector<Track> tracks_;
  double step_limit_ = 1e300;
};

}  // namespace overbend
