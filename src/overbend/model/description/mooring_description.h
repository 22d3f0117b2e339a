/// Mooring lines of the vessel, their winches and anchors, and what is done with them. SI.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/description/hull_description.h"
#include "model/description/lay_operation.h"
#include "model/description/line_description.h"

namespace overbend {

enum class MooringModel { elements, quasi_static };
enum class WinchMode { hold, speed, length, tension };
enum class FindMooring { pose, lengths };

/// What a winch has paid out by a time, hauled in negative.
struct WinchStepDescription {
  double time = 0.0;      ///< [s]
  double paid_out = 0.0;  ///< [m]
};

struct WinchDescription {
  std::string name;
  WinchMode mode = WinchMode::hold;
  double speed = 0.2;                         ///< Hauling at most [m/s].
  std::optional<double> haul, stall, brake;   ///< [N]
  std::optional<double> tension;              ///< Wanted, in mode tension [N].
  std::optional<double> band;                 ///< Either way of it, within which the winch stays [N].
  double delay = 0.0;                         ///< [s]
  double acceleration_time = 2.0;             ///< Up to its speed [s].
  std::vector<WinchStepDescription> program;  ///< In mode speed when it starts, in mode length when it is there.
  std::optional<double> drum;                 ///< Length it holds [m].
};

struct AnchorDescription {
  std::optional<double> holding;  ///< Holding power along the line [N].
  bool slides = false;            ///< Above its holding power; else it is fixed and reported.
};

/// Where a line is of use while the vessel goes on: beyond, its anchor has to be moved.
struct UsefulRange {
  std::optional<double> least_length, most_length;  ///< Unstressed, of the whole line [m].
  std::optional<double> sector;                     ///< Of its direction either way from that as drawn [rad].

  bool given() const { return least_length || most_length || sector; }
};

struct MooringLineDescription {
  std::string name;
  Vec3 fairlead = Vec3::Zero();                 ///< Frame V [m].
  std::optional<double> azimuth;                ///< Of the anchor from the fairlead, clockwise from north [rad].
  std::optional<double> bearing;                ///< The same, clockwise from the bow as drawn [rad].
  std::optional<double> anchor_distance;        ///< Horizontal, from the fairlead with the hull as drawn [m].
  std::optional<std::array<double, 2>> anchor;  ///< x, y in W instead of direction and distance [m].
  std::optional<double> tension;  ///< At the fairlead with the hull as drawn: the first segment's length follows [N].
  std::vector<LineSegmentDescription> segments;  ///< From the fairlead to the anchor.
  std::vector<LinePointDescription> points;      ///< Clumps and buoys.
  std::string winch;                             ///< By name; none: the line's length stands.
  AnchorDescription anchor_holding;
  std::optional<double> fails_at;  ///< Parts at its fairlead at this time [s].
  UsefulRange useful;
};

/// A thing on the sea bed that lines should keep clear of.
struct SeabedObjectDescription {
  std::string name;
  std::vector<Vec3> points;  ///< A polyline in W; one point: a point [m].
};

struct MooringsDescription {
  std::vector<LineTypeDescription> types;
  std::vector<WinchDescription> winches;
  std::vector<MooringLineDescription> lines;
  std::vector<SeabedObjectDescription> objects;
  std::optional<FindMooring> find;  ///< pose where not given.
  MooringModel model = MooringModel::elements;
  std::optional<double> working_load, least_tension;  ///< Bounds of the planner [N].
  std::optional<double> bed_friction;                 ///< Of all lines whose type says nothing [-].
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
  shore_pull,  ///< The pipe is drawn away from the vessel along the bed by a winch at a distance.
  hold_back,   ///< The vessel draws it back; the winch holds.
};
/// How a vessel that is pulled ahead moves: with ramps of its speed; smoothly; with ramps in two parts, half a period
/// of its surge apart, that leave no surge behind.
enum class MoveShape { trapezoid, minimum_jerk, zero_vibration };

/// One line's anchor is taken up and laid down elsewhere.
struct AnchorMoveDescription {
  std::string line;
  std::optional<std::array<double, 2>> to;  ///< New place, x, y in W [m].
  std::optional<double> bearing;  ///< Instead: of the new place from the fairlead, clockwise from the bow [rad].
  std::optional<double> anchor_distance;  ///< And its horizontal distance from there [m].
  double handling_tension = 50e3;         ///< While the anchor is taken up and laid down [N].
  std::optional<double> working_tension;  ///< Afterwards; that of the line before the move where not given [N].
  std::optional<double> test_tension;     ///< Of the holding test [N].
};

struct MooredStageDescription {
  std::string name;
  std::vector<VesselLoadDescription> loads;
  std::vector<std::string> parted;  ///< Lines that are not there.
};

struct OperationDescription {
  OperationType type = OperationType::none;
  double distance = 12.0;           ///< Ahead [m].
  double speed = 0.15;              ///< [m/s]
  double acceleration_time = 10.0;  ///< [s]
  double start = 0.0;               ///< [s]
  int moves = 1;                    ///< Joints one after the other.
  double wait = 300.0;              ///< Between two moves [s].
  MoveShape shape = MoveShape::trapezoid;
  std::vector<VesselLoadDescription> loads;    ///< Of pull_ahead.
  std::vector<MooredStageDescription> stages;  ///< Of moored.
  AnchorMoveDescription anchor;                ///< Of anchor_move.
  LayOperationDescription lay;                 ///< Of operations on the line itself.
};

/// Whether an operation is one on the line itself: abandonment and what follows it in OperationType.
inline bool is_lay_operation(OperationType type) {
  return type >= OperationType::abandonment;
}

/// Whether an operation drags the pipe along the bed between the vessel and a winch at a distance.
inline bool drags_along_bed(OperationType type) {
  return type == OperationType::shore_pull || type == OperationType::hold_back;
}

}  // namespace overbend
