/// Mooring lines of the vessel, their winches and anchors, and the operations with them. SI.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/description/hull_description.h"
#include "model/description/lay_operation_description.h"
#include "model/description/line_description.h"

namespace overbend {

enum class MooringModel { elements, quasi_static };
enum class WinchMode { hold, speed, length, tension };
enum class FindMooring { pose, lengths };

/// Winch payout at a time, negative when hauled in.
struct WinchStepDescription {
  double time = 0.0;      ///< [s]
  double paid_out = 0.0;  ///< [m]
};

struct WinchDescription {
  std::string name;
  WinchMode mode = WinchMode::hold;
  double speed = 0.2;                        ///< Maximum hauling speed [m/s].
  std::optional<double> haul, stall, brake;  ///< [N]
  std::optional<double> tension;             ///< Target tension in mode tension [N].
  std::optional<double> band;                ///< Deadband on either side of the target tension [N].
  double delay = 0.0;                        ///< [s]
  double acceleration_time = 2.0;            ///< Time to reach the speed [s].
  /// Mode speed: start times of the steps; mode length: times by which the payout is reached.
  std::vector<WinchStepDescription> program;
  std::optional<double> drum;  ///< Line length on the drum [m].
};

struct AnchorDescription {
  std::optional<double> holding;  ///< Holding capacity along the line [N].
  bool slides = false;  ///< True: drags above its holding capacity; false: fixed, and its utilisation is reported.
};

/// Range within which a line can be used during an operation; beyond it the anchor has to be moved.
struct UsefulRange {
  std::optional<double> min_length, max_length;  ///< Unstressed length of the whole line [m].
  std::optional<double> sector;  ///< Max. change of direction either way from that in the nominal pose [rad].

  bool given() const { return min_length || max_length || sector; }
};

struct MooringLineDescription {
  std::string name;
  Vec3 fairlead = Vec3::Zero();                 ///< Frame V [m].
  std::optional<double> azimuth;                ///< From the fairlead to the anchor, clockwise from north [rad].
  std::optional<double> bearing;                ///< Same direction, clockwise from the bow in the nominal pose [rad].
  std::optional<double> anchor_distance;        ///< Horizontal distance from the fairlead in the nominal pose [m].
  std::optional<std::array<double, 2>> anchor;  ///< Alternative: x, y in W [m].
  /// Tension at the fairlead in the nominal pose; the length of the first segment follows [N].
  std::optional<double> tension;
  std::vector<LineSegmentDescription> segments;  ///< From the fairlead to the anchor.
  std::vector<LinePointDescription> points;      ///< Clumps and buoys.
  std::string winch;                             ///< Name of the winch; empty: the line has constant length.
  AnchorDescription anchor_holding;
  std::optional<double> fails_at;  ///< Time of failure at the fairlead [s].
  UsefulRange useful;
};

/// Object on the seabed to which the distance of lines is reported.
struct SeabedObjectDescription {
  std::string name;
  std::vector<Vec3> points;  ///< Polyline in W; a single entry is a point [m].
};

struct MooringsDescription {
  std::vector<LineTypeDescription> types;
  std::vector<WinchDescription> winches;
  std::vector<MooringLineDescription> lines;
  std::vector<SeabedObjectDescription> objects;
  std::optional<FindMooring> find;  ///< pose if not given.
  MooringModel model = MooringModel::elements;
  std::optional<double> working_load, min_tension;  ///< Tension bounds of the planner [N].
  std::optional<double> bed_friction;               ///< Default friction of lines whose type gives none [-].
};

enum class OperationType {
  none,
  moored,
  pull_ahead,
  anchor_move,
  anchor_plan,
  abandonment,
  recovery,
  lay_down,
  start_up,
  move,
  passage,
  ballast,
  lift,
  shore_pull,  ///< A winch at a distance pulls the pipe from the vessel along the seabed.
  hold_back,   ///< The vessel pulls the pipe back; the winch holds.
};
/// Velocity profile of a vessel that is pulled ahead: trapezoid with ramps; minimum jerk; two ramped parts, half a
/// surge period apart, that leave no residual surge.
enum class MoveShape { trapezoid, minimum_jerk, zero_vibration };

/// Relocation of one line's anchor.
struct AnchorMoveDescription {
  std::string line;
  std::optional<std::array<double, 2>> to;  ///< New position, x, y in W [m].
  /// Alternative: direction of the new position from the fairlead, clockwise from the bow [rad].
  std::optional<double> bearing;
  std::optional<double> anchor_distance;  ///< Horizontal distance from the fairlead [m].
  double handling_tension = 50e3;         ///< Tension during recovery and deployment of the anchor [N].
  std::optional<double> working_tension;  ///< Tension after the move; as before the move if not given [N].
  std::optional<double> test_tension;     ///< Tension of the holding test [N].
};

struct MooredStageDescription {
  std::string name;
  std::vector<VesselLoadDescription> loads;
  std::vector<std::string> parted;  ///< Names of mooring lines that have failed.
};

struct OperationDescription {
  OperationType type = OperationType::none;
  double distance = 12.0;           ///< Distance ahead per move [m].
  double speed = 0.15;              ///< [m/s]
  double acceleration_time = 10.0;  ///< [s]
  double start = 0.0;               ///< Start of the first move [s].
  int moves = 1;                    ///< Number of moves.
  double wait = 300.0;              ///< Between two moves [s].
  MoveShape shape = MoveShape::trapezoid;
  std::vector<VesselLoadDescription> loads;    ///< Loads during pull_ahead.
  std::vector<MooredStageDescription> stages;  ///< Stages of `moored`.
  AnchorMoveDescription anchor;                ///< Settings of anchor_move.
  LayOperationDescription lay;                 ///< Settings of operations on the laid line.
};

/// Returns true for operations on the laid line: abandonment and those after it in OperationType.
inline bool is_lay_operation(OperationType type) {
  return type >= OperationType::abandonment;
}

/// Returns true if the operation pulls the pipe along the seabed between the vessel and a distant winch.
inline bool drags_along_bed(OperationType type) {
  return type == OperationType::shore_pull || type == OperationType::hold_back;
}

}  // namespace overbend
