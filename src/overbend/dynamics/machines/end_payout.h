/// Line ends that move within a time step: winch pay-out and haul-in, rendering brakes, dragging anchors. Derived in
/// docs/theory/winches.md.
///
/// The payout of an end in a step is a single unknown. Speed over tension is a staircase: the program is followed up to
/// the stall tension of the winch, above it nothing is hauled in, and at the brake capacity the brake renders as fast
/// as limits the tension to it. On a horizontal segment the speed is prescribed, on a vertical one the tension, and the
/// payout is found by the secant rule around the Newton iteration of the lines: the tension falls as the end pays out.
#pragma once

#include <array>

#include "mechanics/winch.h"
#include "system/assembly.h"

namespace overbend {

/// Finds the payout of every winch and anchor of a system within a step.
class EndPayoutSolver {
 public:
  explicit EndPayoutSolver(const System& system);
  bool empty() const { return ends_.empty(); }

  /// Sets the payouts at the end of a step of `h` to a first guess.
  void begin(const SystemState& start, double h, SystemState& next);
  /// Compares the payouts with the tensions of `assembly`, whose lines are in equilibrium at `next`. Returns false if a
  /// payout was changed and the lines must be solved again.
  bool settle(const Assembly& assembly, const SystemState& start, double h, SystemState& next);

 private:
  /// Segment of the staircase: horizontal (`rises` false, payout and speed are prescribed) or vertical.
  struct SpeedTensionSegment {
    bool exists = false, rises = false;
    /// On a horizontal segment: payout [m] and speed [m/s] at the end of the step.
    double moved = 0.0, rate = 0.0;
    /// On a vertical segment: tension at zero speed [N] and its increase with speed [N s/m].
    double level = 0.0, slope = 0.0;
    double slowest = 0.0, fastest = 0.0;  ///< Speed range of a vertical segment [m/s].
  };
  struct End {
    std::size_t attachment = 0;
    std::array<SpeedTensionSegment, 4> segments{};  ///< By payout mode.
    Vec3 along = Vec3::UnitX();                     ///< Horizontal direction in which an anchor is dragged, W.
    double last_moved = 0.0, last_excess = 0.0;
    bool has_last = false;  ///< True if both are from an attempt on the present segment.
    int changes = 0;        ///< Number of changes of the segment in this step.
  };

  PaidOut wanted(const End& end, const SystemState& start, double h) const;
  void set_winch(End& end, const SystemState& start, double h);
  void set_constant_tension_winch(End& end, const SystemState& start, double h);
  void set_anchor(End& end, const SystemState& start);
  void set_payout(const End& end, const SystemState& start, double h, double moved, double rate, PayoutMode mode,
                  SystemState& next) const;
  void set_segment(End& end, PayoutMode mode, const SystemState& start, double h, SystemState& next) const;
  bool settle_end(End& end, const Assembly& assembly, const SystemState& start, double h, SystemState& next);
  void finish(End& end, const Assembly& assembly, const SystemState& start, double h, SystemState& next) const;

  const System* system_;
  std::vector<End> ends_;
};

/// Returns the tension on a line end [N]: for a winch the line tension at the fairlead; for an anchor the sum of
/// horizontal force and uplift, as uplift reduces the holding capacity by its amount.
double held_end_load(const Attachment& held, const LineAssembly& line);

}  // namespace overbend
