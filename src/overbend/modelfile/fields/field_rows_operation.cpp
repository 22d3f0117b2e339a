#include <array>

#include "model/description/description_enum_names.h"
#include "modelfile/fields/field_rows_lines.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

using Operation = OperationDescription;

/// Point on the seabed by x and y.
std::vector<Field> new_place() {
  using Place = std::array<double, 2>;
  const auto open = [](Operation& operation, const FieldValue&) -> Place& { return operation.anchor.to.emplace(); };
  const auto take = [](std::size_t i) {
    return taken_by<Place>([i](Place& place, const FieldValue& value) { place[i] = value.number; });
  };
  return {
      otherwise(group_row("operation.to", opened_by<Operation>(open), "anchor_move: new position of the anchor."),
                "follows from bearing and anchor_distance"),
      required(quantity_row("operation.to.x", take(0), world_axis_texts()[0], kLength)),
      required(quantity_row("operation.to.y", take(1), world_axis_texts()[1], kLength)),
  };
}

std::vector<Field> anchor_move() {
  using Anchor = AnchorMoveDescription;
  const auto of = [](const Member& member) { return through(&Operation::anchor, member); };
  std::vector<Field> rows = {otherwise(row_of_kind(FieldKind::text, "operation.line", of(fills(&Anchor::line)),
                                                   "anchor_move: name of the line under moorings.lines."),
                                       "not used")};
  append(rows, new_place());
  append(rows,
         {otherwise(quantity_row("operation.bearing", of(fills(&Anchor::bearing)),
                                 "anchor_move: direction from the fairlead to the new position, clockwise from the bow "
                                 "of the vessel as drawn.",
                                 kAngle, azimuth()),
                    "to is given"),
          otherwise(
              quantity_row("operation.anchor_distance", of(fills(&Anchor::anchor_distance)),
                           "anchor_move: horizontal distance from the fairlead to the new position, vessel as drawn.",
                           kLength, kPositive),
              "to is given"),
          quantity_row("operation.handling_tension", with_default(of(fills(&Anchor::handling_tension)), 50e3),
                       "anchor_move: tension during recovery and deployment of the anchor.", kForce, kPositive),
          otherwise(
              quantity_row("operation.working_tension", of(fills(&Anchor::working_tension)),
                           "anchor_move: tension to which the line is hauled at its new position.", kForce, kPositive),
              "that of the line before the move"),
          otherwise(quantity_row("operation.test_tension", of(fills(&Anchor::test_tension)),
                                 "anchor_move: tension of the holding test.", kForce, kPositive),
                    "no test")});
  return rows;
}

}  // namespace

std::vector<Field> operation() {
  Field type = required(row_of_kind(
      FieldKind::choice, "operation.type", fills(&Operation::type),
      "moored: the vessel on its lines in several stages; pull_ahead: it moves ahead on its winches, or by dynamic "
      "positioning; anchor_move: an anchor is recovered and set at another position; anchor_plan: which anchor has to "
      "be moved before which joint; abandonment: the pipe is lowered on a cable; recovery: it is raised again, the "
      "stages in reverse order; lay_down: the end of the line, as abandonment; start_up: the first pipe is pulled off "
      "the vessel by a cable to an anchor; move: the vessel moves ahead and the pipe with its segments leaves it; "
      "passage: a structure in the pipe passes the supports and moves down the line; ballast: a tank of the stinger is "
      "flooded or emptied; shore_pull: a winch at a distance pulls the pipe from the vessel along the seabed by a "
      "cable; hold_back: the vessel pulls it back, the winch holds; lift: lines are hauled and paid out, the vessel "
      "moves, ends of pipe are welded."));
  for (const OperationType operation :
       {OperationType::moored, OperationType::pull_ahead, OperationType::anchor_move, OperationType::anchor_plan,
        OperationType::abandonment, OperationType::recovery, OperationType::lay_down, OperationType::start_up,
        OperationType::move, OperationType::passage, OperationType::ballast, OperationType::shore_pull,
        OperationType::hold_back, OperationType::lift}) {
    type.choices.emplace_back(enum_name(operation));
  }
  std::vector<Field> rows = {
      otherwise(
          group_row("operation", enters(&Description::operation), "Operation of the moored vessel or of the line."),
          "nothing"),
      type,
      quantity_row("operation.distance", defaults(&Operation::distance),
                   "pull_ahead: distance ahead, astern negative; anchor_plan: length of each joint.", kLength,
                   {.low = -1000.0, .high = 1000.0}),
      quantity_row("operation.speed", defaults(&Operation::speed), "pull_ahead: speed of the vessel.", kSpeed,
                   {.low = 0.0, .high = 5.0, .low_open = true}),
      quantity_row("operation.acceleration_time", defaults(&Operation::acceleration_time),
                   "pull_ahead: time to reach that speed, and to stop.", kTime, {.low = 0.0, .high = 3600.0}),
      quantity_row("operation.start", defaults(&Operation::start), "pull_ahead: time at which it begins.", kTime,
                   kNotNegative),
      row_of_kind(FieldKind::integer, "operation.moves", defaults(&Operation::moves),
                  "pull_ahead: number of successive moves; anchor_plan: number of joints.",
                  {.low = 1.0, .high = 1000.0}),
      quantity_row("operation.wait", defaults(&Operation::wait), "pull_ahead: time between two moves.", kTime,
                   {.low = 0.0, .high = 86400.0}),
      row_of_kind(FieldKind::choice, "operation.shape", defaults(&Operation::shape),
                  "pull_ahead: velocity profile. trapezoid: with ramps of acceleration_time; minimum_jerk: as smooth "
                  "as possible, with `speed` as its maximum; zero_vibration: trapezoid in two halves, half a natural "
                  "period of surge apart, so that the vessel does not oscillate afterwards."),
      list_row("operation.loads", enters(&Operation::loads),
               "pull_ahead: loads on the vessel in addition to vessel.loads.", "none")};
  append(rows, vessel_load_rows("operation.loads"));
  append(rows, anchor_move());
  append(rows, lay_operation());
  append(rows, operation_stages());
  rows.push_back(passing_structure());
  return rows;
}

}  // namespace overbend::field_rows
