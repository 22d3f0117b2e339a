/// What a dynamic analysis hands on of a floating hull and its mooring lines: plain data, SI units. Statistics count
/// from t = 0, the end of the build-up, to the end of the run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/spread.h"

namespace overbend {

/// A quantity that waves and slow drift move together. `slow` and `wave` are its parts by a symmetric low-pass on the
/// stored history, and add up to it: docs/theory/moorings.md.
struct MotionSpread {
  Spread whole;  ///< Every step of the run.
  Spread slow;   ///< Mean included.
  Spread wave;   ///< Its mean is zero but for the ends of the run.
  /// In three hours, slow and wave part combined; none of a record that is not stationary.
  std::optional<double> most_probable_min, most_probable_max;
  double wave_cycles = 0.0, slow_cycles = 0.0;  ///< Mean up-crossings of the parts in the run.
  /// Standard error of the slow part's standard deviation, share of it: how far another seed may lie [-].
  double slow_std_error = 0.0;
};

/// Where the hull was. Surge to yaw from the drawn place as in VesselResult; along and across: horizontal shift of
/// midship from where it lay at the start of the run, along the axes of the hull as drawn: ahead on the route, and to
/// port of it.
struct VesselDynamics {
  MotionSpread surge, sway, heave;  ///< Forward, to port, up [m].
  MotionSpread roll, pitch, yaw;    ///< Starboard down, bow down, bow to port [rad].
  MotionSpread along, across;       ///< [m]
  MotionSpread offset;              ///< Horizontal distance from where it lay at the start [m].
  double covariance = 0.0;          ///< Of along and across, whole [m2]; for an ellipse of offsets.
  double start_surge = 0.0, start_sway = 0.0, start_yaw = 0.0;  ///< Where it lay at the start [m, rad].
  double cut_off = 0.0;                                         ///< Longer periods are slow, shorter ones waves [s].
  std::string confidence;                                       ///< A sentence on the number of slow cycles.
};

/// What dynamic positioning gave along one of its three directions.
struct ThrustDynamics {
  std::string name;             ///< surge, sway, yaw: ahead, to port, bow to port, of the slow heading.
  Spread given;                 ///< [N, N m]
  double largest_asked = 0.0;   ///< Magnitude of what spring and damper ask for [N, N m].
  std::optional<double> limit;  ///< [N, N m]
  double time_at_limit = 0.0;   ///< In which more is asked for [s].
};

/// What happened to a line at an instant.
struct MooringEvent {
  double time = 0.0;  ///< [s]
  std::string what;   ///< "parted", "slack", "taut", "brake renders", "anchor slips".
};

/// One mooring line over time.
struct MooringLineDynamics {
  std::string name;
  MotionSpread fairlead_tension, anchor_tension;    ///< [N]
  double start_fairlead_tension = 0.0;              ///< At the start of the run [N].
  double intact_fairlead_tension = 0.0;             ///< Largest while no line has parted [N].
  double intact_anchor_tension = 0.0;               ///< The same at the anchor [N].
  std::optional<double> utilisation;                ///< Largest tension over the least breaking load [-].
  std::optional<double> most_probable_utilisation;  ///< By the most probable largest tension in three hours [-].
  std::optional<double> anchor_utilisation;         ///< Largest tension at the anchor over its holding power [-].
  double least_on_bed = 0.0;                        ///< Least unstressed length that the bed bears [m].
  double largest_uplift = 0.0;                      ///< Vertical force on the anchor, upwards [N].
  double time_slack = 0.0;                          ///< Less than a tenth of the tension at the start [s].
  std::optional<double> clearance;                  ///< Least distance to the objects on the bed, of snapshots [m].
  std::string nearest_object;                       ///< Which one it is of.
  /// Where on the line its points in the snapshots are: shares of the length, from the anchor [-].
  std::vector<double> points;
  Spread length;                     ///< Unstressed, that the winch has out [m].
  std::optional<double> parted_at;   ///< [s]
  double anchor_slip = 0.0;          ///< How far the anchor slipped in all [m].
  double brake_rendered = 0.0;       ///< What the brake let out in all [m].
  std::vector<MooringEvent> events;  ///< The first fifty, by time.
};

/// A line that stands by itself over time.
struct LineDynamics {
  std::string name;
  Spread first_tension, second_tension;                  ///< At the ends, along the line, negative where pushed [N].
  double least_tension = 0.0, largest_tension = 0.0;     ///< Anywhere along the line [N].
  std::optional<double> utilisation;                     ///< Largest tension over its segment's breaking load [-].
  std::vector<double> least_at_nodes, largest_at_nodes;  ///< Tension, at the nodes from the first end [N].
  std::vector<double> moment_at_nodes;                   ///< Largest bending moment; empty where none bends [N m].
};

}  // namespace overbend
