/// The tensions whose bends the steps of a run follow: those of the tensioners where there are some, else those at the
/// ends of every line, free ones apart, and of wires.
#pragma once

#include <vector>

#include "dynamics/integrator/dynamic_clock.h"
#include "system/assembly.h"

namespace overbend {

class TensionWatches {
 public:
  /// `time_scale`: DynamicOptions::time_scale [s].
  TensionWatches(const System& system, double time_scale);

  /// At the beginning of a run, the assembly evaluated there.
  void start(const Assembly& assembly);
  /// Longest step that the tensions allow after one of `h` that led to what the assembly stands at [s].
  double longest_step(const Assembly& assembly, double h) const;
  /// Whether a step of `h` is to be taken again where they ask for one of `longest`: a line snapped tight within it.
  bool snapped(double h, double longest) const;
  void took(const Assembly& assembly, double h);
  /// What they are now, after a change that was no step.
  void renew(const Assembly& assembly);

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  double tension(const Assembly& assembly, std::size_t watch) const;

  /// A tensioner by its number, or an end of a line, or a wire.
  struct Watched {
    int tensioner = -1, line = -1, wire = -1;
    LineEnd end = LineEnd::first;
  };
  static std::vector<Watched> watched_of(const System& system);

  std::vector<Watched> watched_;
  ShortestSteps shortest_;
  bool follows_snaps_;
  std::vector<TensionWatch> watches_;  ///< One of each.
};

}  // namespace overbend
