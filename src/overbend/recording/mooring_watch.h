/// The largest tensions of mooring lines over a run, and what they are too much for.
#pragma once

#include <string>
#include <vector>

#include "model/mooring_description.h"
#include "system/assembly.h"

namespace overbend {

/// Counts from t = 0 on. The mooring lines follow the pipe among the lines of the system.
class MooringWatch {
 public:
  /// `names`: of the lines of the run, which `moorings` describes; none without moorings.
  MooringWatch(const std::optional<MooringsDescription>& moorings, const std::vector<std::string>& names);

  /// An accepted step.
  void add(const Assembly& assembly, const SystemState& state);
  /// Lines beyond their breaking or working load, their winch's brake, their anchor's holding power.
  std::vector<std::string> warnings() const;

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  struct Peak {
    double tension = 0.0, time = 0.0;  ///< [N, s]
  };
  struct Watched {
    std::string name;
    std::optional<double> breaking, working, brake, holding;  ///< [N]
    Peak fairlead, anchor;
  };
  std::vector<Watched> lines_;
};

}  // namespace overbend
