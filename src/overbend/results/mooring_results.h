/// Results of a hull and its mooring lines at rest: plain data, SI units. What is assumed and found of them stands with
/// that of the model in StaticResults.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace overbend {

/// A natural period of the hull on its lines.
struct PeriodResult {
  std::string mode;     ///< The motion that most of its kinetic energy is in.
  double period = 0.0;  ///< Undamped [s].
};

/// Where the hull lies: shift of midship on the water line from the drawn place along the drawn axes, then angles with
/// R = Rz(yaw) Ry(pitch) Rx(roll).
struct VesselResult {
  double surge = 0.0, sway = 0.0, heave = 0.0;  ///< Forward, to port, up [m].
  double roll = 0.0, pitch = 0.0, yaw = 0.0;    ///< Starboard down, bow down, bow to port [rad].
  std::vector<PeriodResult> natural_periods;    ///< By falling period; none where the hull's mass is not known.
  /// Of lines, thrusters and water, minus d(force, moment)/d(shift, rotation) about the shifted midship, drawn axes,
  /// row by row [N/m, N, N m]. Empty where the hull is held.
  std::vector<double> stiffness;
};

/// One mooring line at rest.
struct MooringLineResult {
  std::string name;
  double length = 0.0;                       ///< Unstressed [m].
  double first_segment_length = 0.0;         ///< Unstressed, what the winch has out [m].
  double fairlead_tension = 0.0;             ///< [N]
  double horizontal = 0.0;                   ///< Part of it [N].
  double declination = 0.0;                  ///< Of the line below horizontal at the fairlead [rad].
  double anchor_tension = 0.0;               ///< [N]
  double anchor_uplift = 0.0;                ///< Vertical force on the anchor, upwards [N].
  double uplift_angle = 0.0;                 ///< Of the line at the anchor, over horizontal [rad].
  double suspended_length = 0.0;             ///< Unstressed, fairlead to the first touchdown [m].
  double touchdown_distance = 0.0;           ///< Horizontal, fairlead to the first touchdown [m].
  double on_bed = 0.0;                       ///< Unstressed length on the bed [m].
  double horizontal_distance = 0.0;          ///< Fairlead to anchor [m].
  double azimuth = 0.0;                      ///< Of the anchor from the fairlead, clockwise from north [rad].
  std::optional<double> utilisation;         ///< Tension over the least breaking load [-].
  std::optional<double> anchor_utilisation;  ///< Tension over the anchor's holding power [-].
  std::optional<double> clearance;           ///< Least distance to the objects on the bed [m].
  std::string nearest_object;                ///< Which one it is of.
  bool slack = false, parted = false;
  Vec3 fairlead_W = Vec3::Zero(), anchor_W = Vec3::Zero();  ///< [m]
  std::vector<Vec3> shape_W;                                ///< From the fairlead to the anchor [m].
};

/// Hull and lines at rest, and what lines and thrusters do to the hull.
struct MooredState {
  std::string name;
  VesselResult vessel;
  std::vector<MooringLineResult> moorings;
  /// Force and moment of the lines about the shifted midship, and their stiffness row by row; drawn axes. Empty where
  /// the hull is held.
  std::vector<double> mooring_force, mooring_stiffness;
  /// Of dynamic positioning: ahead and to port of the hull, bow to port [N, N, N m]. Empty without it.
  std::vector<double> thrust;
  double residual = 0.0;  ///< Largest unbalanced force over the force scale: weight of lines, thrust a metre off [-].
  int iterations = 0;     ///< Of Newton.
};

/// What the winch of one line does in a pull-ahead.
struct WinchMove {
  std::string name;
  double before = 0.0, after = 0.0;                  ///< Length of the first segment [m].
  double tension_before = 0.0, tension_after = 0.0;  ///< At the fairlead [N].
};

/// The pipe at one place of a pull-ahead.
struct PipeAtStep {
  double top_tension = 0.0, bottom_tension = 0.0;               ///< At the tensioner, at touchdown [N].
  double overbend_bending_stress = 0.0, overbend_strain = 0.0;  ///< Largest [Pa, -].
  double sagbend_bending_stress = 0.0, sagbend_strain = 0.0;    ///< Largest [Pa, -].
  double largest_reaction = 0.0;                                ///< Of a single roller [N].
  std::string largest_reaction_support;                         ///< Box it belongs to.
  double lay_back = 0.0;                                        ///< [m]
  std::optional<double> stinger_tip_clearance;                  ///< [m]
};

/// One place of a pull-ahead.
struct MoveStep {
  double advance = 0.0;          ///< Of midship along the way, from where it began [m].
  VesselResult vessel;           ///< Without periods and stiffness.
  std::vector<double> lengths;   ///< Of the first segments, unstressed; in the order of the lines [m].
  std::vector<double> tensions;  ///< At the fairleads [N].
  double residual = 0.0;         ///< Largest unbalanced force over the weight of the lines [-].
  std::optional<PipeAtStep> pipe;
};

/// An anchor that is due on a route.
struct AnchorDue {
  int joint = 0;                                    ///< Before this one is laid, counted from 1.
  std::string line;                                 ///< Whose anchor it is.
  std::string reason;                               ///< What of the line's useful range it is about to leave.
  Vec3 from_W = Vec3::Zero(), to_W = Vec3::Zero();  ///< Old and new place [m].
  double length = 0.0;                              ///< Of the line, unstressed, at its new place [m].
};

/// What a static analysis of a hull and its lines hands on.
struct MooringResults {
  MooringResults();  // These six are compiled once: a copy of all members is long, and many sources make one.
  MooringResults(const MooringResults&);
  MooringResults(MooringResults&&) noexcept;
  MooringResults& operator=(const MooringResults&);
  MooringResults& operator=(MooringResults&&) noexcept;
  ~MooringResults();

  MooredState rest;
  std::string operation;            ///< moored, pull_ahead, anchor_move, anchor_plan or empty.
  std::vector<MooredState> stages;  ///< Of the operation, in order.
  double distance = 0.0;            ///< Of a pull-ahead [m].
  std::vector<WinchMove> winches;   ///< Of a pull-ahead, from its first stage to its last.
  std::vector<MoveStep> steps;      ///< Of a pull-ahead, place by place.
  std::vector<AnchorDue> anchors;   ///< Of an anchor plan, in order.
};

}  // namespace overbend
