/// The tensioner as a machine: when it holds, waits, pays out and hauls in, and how fast. See docs/theory/tensioner.md.
#pragma once

#include <limits>
#include <optional>

#include "model/description/tensioner_description.h"

namespace overbend {

enum class TensionerState { hold, delay, pay_out, haul_in, at_limit };
inline constexpr int kTensionerStates = 5;

/// What decides the speed over a step. Speeds count positive when it pays out.
enum class TensionerDrive {
  brake,     ///< At rest.
  governor,  ///< The tension decides: T = T0 + slope * speed.
  slowest,   ///< The least speed that it can have at the end of the step.
  fastest,   ///< The greatest.
};

/// Settings of a tensioner.
struct TensionerLaw {
  TensionerMode mode = TensionerMode::locked;
  double wanted = 0.0;                                     ///< Tension T0 that it restores [N].
  double low = 0.0;                                        ///< Operational range [N].
  double high = 0.0;                                       ///< [N]
  double delay = 0.0;                                      ///< Time out of range before it moves [s].
  double velocity = 0.0;                                   ///< Largest, of paying out and hauling in [m/s].
  double acceleration = 0.0;                               ///< Up to that velocity and down again [m/s2].
  double limit = std::numeric_limits<double>::infinity();  ///< Of travel either way [m].
  double resolution =
      0.0;  ///< Tension difference that the machine cannot distinguish from a bound: events are met within it [N].
};

/// Memory of the machine.
struct TensionerMachine {
  TensionerState state = TensionerState::hold;
  TensionerDrive drive = TensionerDrive::brake;  ///< Over the last step.
  int side = 0;          ///< +1: the tension is too high, it shall pay out or does; -1: too low, haul in.
  double timer = 0.0;    ///< While it waits: time out of range. While it moves: time back in range [s].
  double tension = 0.0;  ///< Last measured [N].
  /// Speed that somebody outside asks for in place of the law, within velocity, acceleration and travel [m/s].
  std::optional<double> commanded{};
  bool returning = false;  ///< The command is over: its speed goes back to that of the law.
};

/// Travel counts what was paid out since the start, hauled in negative.
struct Travel {
  double length = 0.0;        ///< [m]
  double speed = 0.0;         ///< [m/s]
  double acceleration = 0.0;  ///< [m/s2]
};

/// Speeds that the machine can have at the end of a step [m/s].
struct SpeedBounds {
  double slowest = 0.0, fastest = 0.0;
};

/// From `now` over `h`; `authority` (0 to 1) is the fraction of the response velocity that it may use. It has to stand
/// where its travel ends. Of a commanded machine both are the speed that comes closest to the command.
SpeedBounds reachable_speeds(const TensionerLaw& law, const TensionerMachine& machine, const Travel& now,
                             double authority, double h);

/// Travel after `h` with the speed `speed` at its end, evenly reached; not beyond the limit.
Travel driven(const TensionerLaw& law, const Travel& now, double speed, double h);
/// The same of a commanded machine: it gathers speed as fast as it can and keeps it for the rest of the step.
Travel led(const TensionerLaw& law, const Travel& now, double speed, double h);

/// Sets a new tension T0 to restore; the operational range is shifted with it [N].
void set_wanted_tension(TensionerLaw& law, double wanted);
/// It shall have this speed from here on [m/s].
void command_speed(TensionerMachine& machine, double speed);
/// It goes on by its own law from the speed that it has [m/s]; where that is another, it goes there first.
void leave_to_law(const TensionerLaw& law, double speed, TensionerMachine& machine);

/// Tension at which the governor asks for a speed: the wanted one at rest, an end of the range at full speed [N].
double governed_tension(const TensionerLaw& law, double speed);
/// Its derivative with the speed [N s/m].
double governor_slope(const TensionerLaw& law, double speed);

/// The drive to begin a step with.
TensionerDrive first_drive(const TensionerLaw& law, const TensionerMachine& machine);
/// The drive that speed and tension at the end of a step with `drive` ask for: the same where the step was right.
TensionerDrive fitting_drive(const TensionerLaw& law, const SpeedBounds& bounds, TensionerDrive drive, double speed,
                             double tension);

/// By how much tension and speed are beyond what keeps the machine in its state [N]: negative while it stays, positive
/// when it changes; minus infinity when they do not change it.
double excess(const TensionerLaw& law, const TensionerMachine& machine, double tension, double speed);
/// Time until its delay is over [s]; infinite where none runs.
double time_to_move(const TensionerLaw& law, const TensionerMachine& machine);

/// Takes the tension and travel at the end of a step of `h` and changes the machine's state as they and its clock ask.
/// Returns the travel, which is put on its limit exactly where it ends there.
Travel observe(const TensionerLaw& law, double tension, double h, const Travel& travel, TensionerMachine& machine);

/// Whether a tension lies outside the operational range.
inline bool out_of_range(const TensionerLaw& law, double tension) {
  return tension > law.high || tension < law.low;
}

/// The excess after a step of `h`: 0 is the state that it began from.
struct EventTry {
  double h = 0.0, excess = 0.0;
};

/// How long a step that was tried as `now` may be to meet the change of state, by the straight line through `now` and
/// the try before it (the state at first): a little beyond its root. `now.h` where it met it within the resolution, by
/// the line of two tries no more than `shortest` too late, or is no longer than that. A tension that jumps at the
/// beginning of the step misleads the first line alone.
double step_to_event(const TensionerLaw& law, const EventTry& before, const EventTry& now, double shortest);

}  // namespace overbend
