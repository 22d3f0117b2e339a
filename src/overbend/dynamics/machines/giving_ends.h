/// Ends of lines that give way within a time step: winches that pay out and haul in, brakes that render, anchors that
/// drag. docs/theory/winches.md derives it.
///
/// By how much an end gives way is one number in a step. What it may be is a staircase of speed over tension: a program
/// is followed up to the tension at which the winch stalls, nothing is hauled in beyond that, and at what the brake
/// bears it renders as fast as keeps the tension there. On a flat of the staircase the speed is given, on a rise the
/// tension is, and the number is found by the secant rule around the lines' own Newton's method: the tension falls as
/// the end gives.
#pragma once

#include <array>

#include "mechanics/winch.h"
#include "system/assembly.h"

namespace overbend {

class GivingEnds {
 public:
  explicit GivingEnds(const System& system);
  bool empty() const { return ends_.empty(); }

  /// Sets what gave way at the end of a step of `h`, as a first guess.
  void begin(const SystemState& now, double h, SystemState& next);
  /// Compares with the tensions of `assembly`, whose lines are in balance at `next`; false where something had to be
  /// changed, and the lines have to be brought into balance again.
  bool settle(const Assembly& assembly, const SystemState& now, double h, SystemState& next);

 private:
  /// A flat (`rises` false: way and rate are given) or a rise of the staircase.
  struct Stair {
    bool there = false, rises = false;
    double moved = 0.0, rate = 0.0;       ///< Of a flat, at the end of the step [m], [m/s].
    double level = 0.0, slope = 0.0;      ///< Of a rise: tension at rest [N], what it grows by with the speed [N s/m],
    double slowest = 0.0, fastest = 0.0;  ///< and the speeds between which it leads [m/s].
  };
  struct End {
    std::size_t attachment = 0;
    std::array<Stair, 4> stairs{};  ///< By Giving.
    Vec3 along = Vec3::UnitX();     ///< Where an anchor is dragged to: horizontal, W.
    double last_moved = 0.0, last_excess = 0.0;
    bool has_last = false;  ///< The two are of a try on this stair.
    int changes = 0;        ///< Of the stair, in this step.
  };

  PaidOut wanted(const End& end, const SystemState& now, double h) const;
  void set_winch(End& end, const SystemState& now, double h);
  void set_keeper(End& end, const SystemState& now, double h);
  void set_anchor(End& end, const SystemState& now);
  void put(const End& end, const SystemState& now, double h, double moved, double rate, Giving how,
           SystemState& next) const;
  void put_on(End& end, Giving how, const SystemState& now, double h, SystemState& next) const;
  bool settle_one(End& end, const Assembly& assembly, const SystemState& now, double h, SystemState& next);
  void finish(End& end, const Assembly& assembly, const SystemState& now, double h, SystemState& next) const;

  const System* system_;
  std::vector<End> ends_;
};

/// Tension that an end of a line has to take: of a winch the line's at the fairlead, of an anchor the horizontal pull
/// and the uplift together, for uplift takes as much off its holding power [N].
double tension_to_take(const Attachment& held, const LineAssembly& line);

}  // namespace overbend
