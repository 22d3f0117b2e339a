/// Dynamic results of a floating hull and its mooring lines: plain data, SI units. Statistics count from t = 0, the end
/// of the build-up, to the end of the run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/summary_statistics.h"

namespace overbend {

/// A quantity with wave-frequency and low-frequency motion. `slow` and `wave` are these parts, separated by a symmetric
/// low-pass filter of the stored history; their sum is the quantity: docs/theory/moorings.md.
struct MotionStatistics {
  SummaryStatistics whole;  ///< Statistics over all steps of the run.
  SummaryStatistics slow;   ///< Low-frequency part, including the mean.
  SummaryStatistics wave;   ///< Wave-frequency part; its mean is zero except for end effects.
  /// In three hours, from both parts combined; none for a non-stationary record.
  std::optional<double> most_probable_min, most_probable_max;
  double wave_cycles = 0.0, slow_cycles = 0.0;  ///< Number of mean up-crossings of the parts in the run.
  /// Relative standard error of the low-frequency standard deviation, for the scatter between seeds [-].
  double slow_std_error = 0.0;
};

/// Motion of the hull. Surge to yaw are offsets from the nominal pose as in VesselResult; along and across: horizontal
/// shift of midship from its position at the start of the run, along the axes of the nominal pose: ahead on the route,
/// and to port of it.
struct VesselDynamics {
  MotionStatistics surge, sway, heave;  ///< Forward, to port, up [m].
  MotionStatistics roll, pitch, yaw;    ///< Starboard down, bow down, bow to port [rad].
  MotionStatistics along, across;       ///< [m]
  MotionStatistics offset;              ///< Horizontal distance from the position at the start [m].
  double covariance = 0.0;              ///< Covariance of along and across, both parts [m2]; for an ellipse of offsets.
  double start_surge = 0.0, start_sway = 0.0, start_yaw = 0.0;  ///< Offset at the start [m, rad].
  double cut_off = 0.0;                                         ///< Period that separates low-frequency (longer) and
                                                                ///< wave-frequency (shorter) motion [s].
  std::string confidence;                                       ///< Message on the number of low-frequency cycles.
};

/// Thrust of dynamic positioning along one of its three directions.
struct ThrustDynamics {
  std::string name;             ///< surge, sway, yaw: ahead, to port, bow to port, relative to the low-frequency
                                ///< heading.
  SummaryStatistics given;      ///< [N, N m]
  double max_demand = 0.0;      ///< Maximum magnitude of the demand of spring and damper [N, N m].
  std::optional<double> limit;  ///< [N, N m]
  double time_at_limit = 0.0;   ///< Time in which the demand exceeds the limit [s].
};

/// An event of a line.
struct MooringEvent {
  double time = 0.0;  ///< [s]
  std::string what;   ///< "parted", "slack", "taut", "brake renders", "anchor slips".
};

/// One mooring line over time.
struct MooringLineDynamics {
  std::string name;
  MotionStatistics fairlead_tension, anchor_tension;  ///< [N]
  double start_fairlead_tension = 0.0;                ///< At the start of the run [N].
  double intact_fairlead_tension = 0.0;               ///< Maximum before any line has parted [N].
  double intact_anchor_tension = 0.0;                 ///< Maximum at the anchor before any line has parted [N].
  std::optional<double> utilisation;                  ///< Maximum of tension over breaking load of the segment [-].
  std::optional<double> most_probable_utilisation;    ///< For the most probable maximum tension in three hours [-].
  std::optional<double> anchor_utilisation;           ///< Maximum tension at the anchor over its holding power [-].
  double min_on_seabed = 0.0;                         ///< Minimum unstressed length in contact with the seabed [m].
  double max_uplift = 0.0;                            ///< Vertical force on the anchor, upwards [N].
  double time_slack = 0.0;                            ///< Time with less than a tenth of the tension at the start [s].
  std::optional<double> clearance;                    ///< Minimum distance to the objects on the seabed, from snapshots
                                                      ///< [m].
  std::string nearest_object;                         ///< Name of that object.
  /// Positions of the line's points in the snapshots: shares of the length, from the anchor [-].
  std::vector<double> points;
  SummaryStatistics length;          ///< Unstressed length paid out by the winch [m].
  std::optional<double> parted_at;   ///< [s]
  double anchor_slip = 0.0;          ///< Total slip of the anchor [m].
  double brake_rendered = 0.0;       ///< Total length rendered by the brake [m].
  std::vector<MooringEvent> events;  ///< The first fifty, in the order of time.
};

/// A stand-alone line over time.
struct LineDynamics {
  std::string name;
  SummaryStatistics first_tension, second_tension;  ///< Tension at the ends along the line, negative for
                                                    ///< compression [N].
  double min_tension = 0.0, max_tension = 0.0;      ///< Extremes along the line [N].
  std::optional<double> utilisation;                ///< Maximum of tension over breaking load of the segment [-].
  std::vector<double> min_tension_at_nodes, max_tension_at_nodes;  ///< Tension at the nodes from the first end [N].
  std::vector<double> moment_at_nodes;  ///< Maximum bending moment at the nodes; empty for a line
                                        ///< without bending stiffness [N m].
};

}  // namespace overbend
