/* Controllers of Overbend in compiled code: C and C++. docs/guide/python-controllers.md shows how one is used.
 *
 * A controller commands the tensioner, or the winch of a mooring line, during a dynamic analysis. It is called for the
 * multiples of an interval. Its command applies from the end of the time step that contains the time of the call until
 * the next call; no step is longer than 1.25 intervals. */
#ifndef OVERBEND_CONTROLLER_H
#define OVERBEND_CONTROLLER_H

#ifdef __cplusplus
extern "C" {
#endif

/* Names as C has them: NOLINTBEGIN(readability-identifier-naming) */

/* Readings of the machine and the vessel. All values are doubles, in SI units; new ones are only added at the end.
 * Numbers in brackets: index among the doubles, for languages that use an array. */
struct overbend_reading {
  double time;               /* [0] Time from the end of the build-up; negative during it [s]. */
  double tension;            /* [1] Tension of the pipe at the tensioner, or of the line at its fairlead [N]. */
  double paid_out;           /* [2] Payout since the start; negative if hauled in [m]. */
  double speed;              /* [3] Speed, positive paying out [m/s]. */
  double set_tension;        /* [4] Target tension of the machine's own law; 0 if it has none [N]. */
  double length;             /* [5] Unstressed length of the mooring line; for the tensioner paid_out [m]. */
  double vessel[6];          /* [6] Surge, sway, heave [m], roll, pitch, yaw [rad], from the mean pose. */
  double vessel_velocity[6]; /* [12] Of the vessel's origin, along the axes of the world [m/s]; about them [rad/s]. */
  double guide_speed;        /* [18] Speed of the guide or fairlead along the line, away from it [m/s]. */
};

/* Return values. */
enum overbend_answer {
  OVERBEND_LEAVE = 0,  /* The machine works by its own law with its last set tension. */
  OVERBEND_SPEED = 1,  /* Pay out at *command, negative: haul in [m/s]; within the machine's velocity, acceleration and
                          travel. */
  OVERBEND_TENSION = 2 /* Restore the tension *command by the machine's own law; its range is shifted with it [N]. */
};

/* Returns one of overbend_answer; any other value ends the run as a failure of the controller. `memory` points to the
 * registered doubles, which the function may change: they belong to the run's state and are saved with it. */
typedef int (*overbend_controller)(const struct overbend_reading* seen, double* command, double* memory);

/* NOLINTEND(readability-identifier-naming) */

#ifdef __cplusplus
}
#endif

#endif
