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
  /// Lines beyond their breaking or working load or their anchor's holding power; what rendered, dragged, could not
  /// haul in or parted.
  std::vector<std::string> warnings() const;

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  struct Peak {
    double tension = 0.0, time = 0.0;  ///< [N, s]
  };
  struct Given {
    double rendered = 0.0, dragged = 0.0;  ///< [m]
    double held_up_for = 0.0;              ///< [s]
    bool parted = false;
    double least_element = 1.0, most_element = 1.0;  ///< Length of the last element, of its own.
  };
  struct Watched {
    std::string name;
    std::optional<double> breaking, working, holding;  ///< [N]
    bool drags = false;                                ///< Its anchor, above the holding power.
    std::optional<double> brake, stall, parts_at;      ///< [N], [s]
    Peak fairlead, anchor;
    Given given;
  };
  void add_given(const System& system, const SystemState& state);
  static void warn_of_given(const Watched& line, std::vector<std::string>& list);
  std::vector<Watched> lines_;
};

}  // namespace overbend
