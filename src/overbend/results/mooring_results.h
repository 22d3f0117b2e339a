/// Static results of a hull and its mooring lines: plain data, SI units. Their assumptions and findings are in
/// StaticResults with those of the model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace overbend {

/// A natural period of the hull on its mooring lines.
struct PeriodResult {
  std::string mode;     ///< Motion with most of the kinetic energy.
  double period = 0.0;  ///< Undamped [s].
};

/// Pose of the hull: shift of midship on the water line from the nominal position along the nominal axes, then angles
/// with R = Rz(yaw) Ry(pitch) Rx(roll).
struct VesselResult {
  double surge = 0.0, sway = 0.0, heave = 0.0;  ///< Forward, to port, up [m].
  double roll = 0.0, pitch = 0.0, yaw = 0.0;    ///< Starboard down, bow down, bow to port [rad].
  std::vector<PeriodResult> natural_periods;    ///< By descending period; empty if the hull's mass is not known.
  /// Stiffness of lines, thrusters and water: minus d(force, moment)/d(shift, rotation) about the shifted midship,
  /// nominal axes, by rows [N/m, N, N m]. Empty for a fixed hull.
  std::vector<double> stiffness;
};

/// Static results of a mooring line.
struct MooringLineResult {
  std::string name;
  double length = 0.0;                       ///< Unstressed [m].
  double first_segment_length = 0.0;         ///< Unstressed, as paid out by the winch [m].
  double fairlead_tension = 0.0;             ///< [N]
  double horizontal = 0.0;                   ///< Horizontal component at the fairlead [N].
  double declination = 0.0;                  ///< Angle of the line below horizontal at the fairlead [rad].
  double anchor_tension = 0.0;               ///< [N]
  double anchor_uplift = 0.0;                ///< Vertical force on the anchor, upwards [N].
  double uplift_angle = 0.0;                 ///< Angle of the line above horizontal at the anchor [rad].
  double suspended_length = 0.0;             ///< Unstressed, fairlead to the first touchdown [m].
  double touchdown_distance = 0.0;           ///< Horizontal, fairlead to the first touchdown [m].
  double on_bed = 0.0;                       ///< Unstressed length on the bed [m].
  double horizontal_distance = 0.0;          ///< Fairlead to anchor [m].
  double azimuth = 0.0;                      ///< Azimuth of the anchor from the fairlead, clockwise from north [rad].
  std::optional<double> utilisation;         ///< Maximum of tension over breaking load of the segment [-].
  std::optional<double> anchor_utilisation;  ///< Tension over the anchor's holding power [-].
  std::optional<double> clearance;           ///< Minimum distance to the objects on the seabed [m].
  std::string nearest_object;                ///< Name of that object.
  bool slack = false, parted = false;
  Vec3 fairlead_W = Vec3::Zero(), anchor_W = Vec3::Zero();  ///< [m]
  std::vector<Vec3> shape_W;                                ///< Points from the fairlead to the anchor [m].
};

/// Equilibrium of hull and lines, and the loads of lines and thrusters on the hull.
struct MooredState {
  std::string name;
  VesselResult vessel;
  std::vector<MooringLineResult> moorings;
  /// Force and moment of the lines about the shifted midship, and their stiffness by rows; nominal axes. Empty for a
  /// fixed hull.
  std::vector<double> mooring_force, mooring_stiffness;
  /// Thrust of dynamic positioning: ahead and to port of the hull, bow to port [N, N, N m]. Empty without it.
  std::vector<double> thrust;
  double residual = 0.0;  ///< Maximum unbalanced force over the force scale: weight of lines, thrust at an offset of 1
                          ///< m [-].
  int iterations = 0;     ///< Number of Newton iterations.
};

/// Winch operation of one line in a pull-ahead.
struct WinchMove {
  std::string name;
  double before = 0.0, after = 0.0;                  ///< Length of the first segment [m].
  double tension_before = 0.0, tension_after = 0.0;  ///< At the fairlead [N].
};

/// The pipe at one position of a pull-ahead.
struct PipeAtStep {
  double top_tension = 0.0, bottom_tension = 0.0;               ///< At the tensioner, at touchdown [N].
  double overbend_bending_stress = 0.0, overbend_strain = 0.0;  ///< Maxima [Pa, -].
  double sagbend_bending_stress = 0.0, sagbend_strain = 0.0;    ///< Maxima [Pa, -].
  double max_reaction = 0.0;                                    ///< Maximum of a single roller [N].
  std::string max_reaction_support;                             ///< Roller box of that maximum.
  double lay_back = 0.0;                                        ///< [m]
  std::optional<double> stinger_tip_clearance;                  ///< [m]
};

/// One position of a pull-ahead.
struct MoveStep {
  double advance = 0.0;          ///< Distance of midship along the path from its start [m].
  VesselResult vessel;           ///< Without natural periods and stiffness.
  std::vector<double> lengths;   ///< Unstressed lengths of the first segments, in the order of the lines [m].
  std::vector<double> tensions;  ///< At the fairleads [N].
  double residual = 0.0;         ///< Maximum unbalanced force over the weight of the lines [-].
  std::optional<PipeAtStep> pipe;
};

/// An anchor move that is due on a route.
struct AnchorDue {
  int joint = 0;                                    ///< Number of joints before the move, from 1.
  std::string line;                                 ///< Line of the anchor.
  std::string reason;                               ///< Limit of the line's range that is about to be exceeded.
  Vec3 from_W = Vec3::Zero(), to_W = Vec3::Zero();  ///< Old and new position [m].
  double length = 0.0;                              ///< Unstressed length of the line at the new position [m].
};

/// Static results of a hull and its mooring lines.
struct MooringResults {
  MooringResults();  // These six are defined in the source file: the member-wise copy is long, and many sources would
                     // instantiate it.
  MooringResults(const MooringResults&);
  MooringResults(MooringResults&&) noexcept;
  MooringResults& operator=(const MooringResults&);
  MooringResults& operator=(MooringResults&&) noexcept;
  ~MooringResults();

  MooredState rest;
  std::string operation;            ///< moored, pull_ahead, anchor_move, anchor_plan or empty.
  std::vector<MooredState> stages;  ///< Stages of the operation, in order.
  double distance = 0.0;            ///< Distance of a pull-ahead [m].
  std::vector<WinchMove> winches;   ///< Winch operations of a pull-ahead, from its first stage to its last.
  std::vector<MoveStep> steps;      ///< Positions of a pull-ahead, in order.
  std::vector<AnchorDue> anchors;   ///< Anchor moves of an anchor plan, in order.
};

}  // namespace overbend
