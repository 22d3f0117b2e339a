/* Controllers of Overbend in compiled code: C and C++. docs/guide/python-controllers.md shows how one is used.
 *
 * A controller drives the tensioner, or the winch of a mooring line, during an analysis in time. It is asked for the
 * multiples of an interval and answers with what its machine shall do until it is asked again, from the end of the time
 * step within which that instant falls; no step is longer than 1.25 intervals. */
#ifndef OVERBEND_CONTROLLER_H
#define OVERBEND_CONTROLLER_H

#ifdef __cplusplus
extern "C" {
#endif

/* Names as C has them: NOLINTBEGIN(readability-identifier-naming) */

/* What a controller sees of its machine and of the vessel. All values are doubles, in SI units; new ones are added at
 * the end alone. Numbers in brackets: place among the doubles, for languages that see an array. */
struct overbend_reading {
  double time;               /* [0] From the end of the build-up; negative during it [s]. */
  double tension;            /* [1] Of the pipe at the tensioner, or of the line at its fairlead [N]. */
  double paid_out;           /* [2] Since the start; hauled in negative [m]. */
  double speed;              /* [3] Paying out counts positive [m/s]. */
  double set_tension;        /* [4] That the machine's own law restores; 0 where it keeps none [N]. */
  double length;             /* [5] Unstressed length of the mooring line; of the tensioner the same as paid_out [m]. */
  double vessel[6];          /* [6] Surge, sway, heave [m], roll, pitch, yaw [rad], from the mean pose. */
  double vessel_velocity[6]; /* [12] Of the vessel's origin, along the axes of the world [m/s]; about them [rad/s]. */
  double guide_speed;        /* [18] Of what holds the line's end, along the line and away from it [m/s]. */
};

/* What an answer means. */
enum overbend_answer {
  OVERBEND_LEAVE = 0,  /* The machine works by its own law, and keeps the tension that it was set to last. */
  OVERBEND_SPEED = 1,  /* Pay out at *command, negative: haul in [m/s]; within the machine's velocity, acceleration and
                          travel. */
  OVERBEND_TENSION = 2 /* Restore the tension *command by the machine's own law; its range is shifted with it [N]. */
};

/* Answers with one of overbend_answer; anything else ends the run as a failure of the controller. `memory` points to
 * the doubles that it was registered with, which it may change: they belong to the run's state and are saved with it.
 */
typedef int (*overbend_controller)(const struct overbend_reading* seen, double* command, double* memory);

/* NOLINTEND(readability-identifier-naming) */

#ifdef __cplusplus
}
#endif

#endif
