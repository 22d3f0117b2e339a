/// Observers of a simulation: recorders, live pages, controllers.
#pragma once

#include <cstdint>

#include "results/dynamic_sink.h"
#include "system/dynamic_line.h"

namespace overbend {

/// One instant. The system is evaluated at the state: its contacts, cuts and surroundings belong to it.
struct Instant {
  const DynamicState* state = nullptr;
  const DynamicSystem* system = nullptr;
  double step = 0.0;       ///< That led here [s].
  double elevation = 0.0;  ///< Of the water at the stern shoe's mean place [m].
  double drift = 0.0;      ///< Of energy, relative.
};

/// References are valid during a call only. Whatever an observer remembers between calls belongs in a checkpoint.
class SimulationObserver {
 public:
  virtual ~SimulationObserver() = default;
  /// Once, when it is added; at the beginning of a run the instant is the static state.
  virtual void begun(const Instant&) {}
  /// After every accepted step.
  virtual void stepped(const Instant&) {}
  /// An impact that ended with the step; before stepped().
  virtual void impact(const Impact&) {}
  /// At every row of output, after stepped(); row 0 is that of t = 0.
  virtual void row(const Instant&, std::int64_t /*number*/) {}
  virtual void save(DynamicCheckpoint&) const {}
  virtual void restore(const DynamicCheckpoint&) {}
};

}  // namespace overbend
