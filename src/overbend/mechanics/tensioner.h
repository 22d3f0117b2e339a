/// The tensioner as a machine: states hold, delay, pay out and haul in, and their speeds. See docs/theory/tensioner.md.
#pragma once

#include <limits>
#include <optional>

#include "model/description/tensioner_description.h"

namespace overbend {

enum class TensionerState { hold, delay, pay_out, haul_in, at_limit };
inline constexpr int kTensionerStates = 5;

/// Rule for the speed over a step. Speeds are positive when paying out.
enum class TensionerDrive {
  brake,     ///< At rest.
  governor,  ///< Tension governs: T = T0 + slope * speed.
  slowest,   ///< Minimum speed that it can have at the end of the step.
  fastest,   ///< Maximum speed.
};

/// Settings of a tensioner.
struct TensionerLaw {
  TensionerMode mode = TensionerMode::locked;
  double wanted = 0.0;                                     ///< Target tension T0 [N].
  double low = 0.0;                                        ///< Lower end of the operational range [N].
  double high = 0.0;                                       ///< Upper end [N].
  double delay = 0.0;                                      ///< Time out of range before it moves [s].
  double velocity = 0.0;                                   ///< Maximum speed of paying out and hauling in [m/s].
  double acceleration = 0.0;                               ///< Acceleration and deceleration [m/s2].
  double limit = std::numeric_limits<double>::infinity();  ///< Limit of travel in either direction [m].
  double resolution = 0.0;  ///< Resolution of tension: events are located within this tolerance [N].
};

/// State of the machine.
struct TensionerMachine {
  TensionerState state = TensionerState::hold;
  TensionerDrive drive = TensionerDrive::brake;  ///< Drive over the last step.
  int side = 0;          ///< +1: tension above the range, pay out; -1: tension below the range, haul in.
  double timer = 0.0;    ///< In delay: time out of range. When moving: time back in range [s].
  double tension = 0.0;  ///< Last measured tension [N].
  /// Speed commanded by an external controller instead of the law, within velocity, acceleration and travel [m/s].
  std::optional<double> commanded{};
  bool returning = false;  ///< True after the end of a command while the speed returns to that of the law.
};

/// Travel: length paid out since the start, negative when hauled in.
struct Travel {
  double length = 0.0;        ///< [m]
  double speed = 0.0;         ///< [m/s]
  double acceleration = 0.0;  ///< [m/s2]
};

/// Speed range of the machine at the end of a step [m/s].
struct SpeedBounds {
  double slowest = 0.0, fastest = 0.0;
};

/// Returns the speeds reachable from `travel` within `h` [s]; `authority` (0 to 1) is the fraction of the response
/// velocity that it may use. It must be at rest at its travel limit. For a commanded machine both bounds are the speed
/// closest to the command.
SpeedBounds reachable_speeds(const TensionerLaw& law, const TensionerMachine& machine, const Travel& travel,
                             double authority, double h);

/// Returns the travel after `h` [s] at constant acceleration to the final speed `speed`; limited to the travel limit.
Travel advance_governed(const TensionerLaw& law, const Travel& travel, double speed, double h);
/// Returns the travel of a commanded machine: maximum acceleration, then constant speed for the rest of the step.
Travel advance_commanded(const TensionerLaw& law, const Travel& travel, double speed, double h);

/// Sets a new target tension T0; the operational range is shifted with it [N].
void set_target_tension(TensionerLaw& law, double wanted);
/// Commands this speed from now on [m/s].
void command_speed(TensionerMachine& machine, double speed);
/// Returns control to the machine's law at its current speed [m/s]; a different law speed is approached first.
void return_to_law(const TensionerLaw& law, double speed, TensionerMachine& machine);

/// Returns the tension at which the governor demands a speed: the target at rest, an end of the range at full speed
/// [N].
double governed_tension(const TensionerLaw& law, double speed);
/// Returns its derivative with the speed [N s/m].
double governor_slope(const TensionerLaw& law, double speed);

/// Returns the drive for the first try of a step.
TensionerDrive first_drive(const TensionerLaw& law, const TensionerMachine& machine);
/// Returns the drive that matches speed and tension at the end of a step with `drive`: unchanged if the step was right.
TensionerDrive matching_drive(const TensionerLaw& law, const SpeedBounds& bounds, TensionerDrive drive, double speed,
                              double tension);

/// Returns the excess of tension and speed over the limit that keeps the machine in its state [N]: negative while the
/// state persists, positive when it changes; minus infinity if the state does not depend on them.
double excess(const TensionerLaw& law, const TensionerMachine& machine, double tension, double speed);
/// Returns the remaining delay [s]; infinite if none runs.
double time_to_move(const TensionerLaw& law, const TensionerMachine& machine);

/// Updates the machine's state from tension and travel at the end of a step of `h` [s]. Returns the travel, set exactly
/// to its limit if it ends there.
Travel observe(const TensionerLaw& law, double tension, double h, const Travel& travel, TensionerMachine& machine);

/// True if a tension is outside the operational range.
inline bool out_of_range(const TensionerLaw& law, double tension) {
  return tension > law.high || tension < law.low;
}

/// Excess after a step of `h`: 0 is the state at the start of the step.
struct EventTry {
  double h = 0.0, excess = 0.0;
};

/// Returns the length [s] of the next try of a step so that it ends at the change of state: just after the root of the
/// straight line through the tries `current` and `before` (initially the state at the start). Returns `current.h` if
/// that met the event within the resolution, is at most `min_step` too late by the line of two tries, or is no longer
/// than `min_step`. A tension that jumps at the start of the step distorts the first line only.
double step_to_event(const TensionerLaw& law, const EventTry& before, const EventTry& current, double min_step);

}  // namespace overbend
