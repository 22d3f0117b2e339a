#include <array>

#include "model/description/description_words.h"
#include "modelfile/fields/field_rows_lines.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

using Operation = OperationDescription;

/// A place on the bed by x and y.
std::vector<Field> new_place() {
  using Place = std::array<double, 2>;
  const auto open = [](Operation& operation, const FieldValue&) -> Place& { return operation.anchor.to.emplace(); };
  const auto take = [](std::size_t i) {
    return taken_by<Place>([i](Place& place, const FieldValue& value) { place[i] = value.number; });
  };
  return {
      otherwise(group_row("operation.to", opened_by<Operation>(open), "Of anchor_move: new place of the anchor."),
                "follows from bearing and anchor_distance"),
      required(quantity_row("operation.to.x", take(0), world_axes_words()[0], kLength)),
      required(quantity_row("operation.to.y", take(1), world_axes_words()[1], kLength)),
  };
}

std::vector<Field> anchor_move() {
  using Anchor = AnchorMoveDescription;
  const auto of = [](const Member& member) { return through(&Operation::anchor, member); };
  std::vector<Field> rows = {otherwise(row_of_kind(FieldKind::text, "operation.line", of(fills(&Anchor::line)),
                                                   "Of anchor_move: name of the line under moorings.lines."),
                                       "not used")};
  append(rows, new_place());
  append(
      rows,
      {otherwise(quantity_row("operation.bearing", of(fills(&Anchor::bearing)),
                              "Of anchor_move: direction from the fairlead to the new place, clockwise from the bow "
                              "of the vessel as drawn.",
                              kAngle, azimuth()),
                 "to is given"),
       otherwise(quantity_row("operation.anchor_distance", of(fills(&Anchor::anchor_distance)),
                              "Of anchor_move: horizontal distance from the fairlead to the new place, vessel as "
                              "drawn.",
                              kLength, kPositive),
                 "to is given"),
       quantity_row("operation.handling_tension", with_default(of(fills(&Anchor::handling_tension)), 50e3),
                    "Of anchor_move: tension while the anchor is taken up and laid down.", kForce, kPositive),
       otherwise(
           quantity_row("operation.working_tension", of(fills(&Anchor::working_tension)),
                        "Of anchor_move: tension to which the line is hauled at its new place.", kForce, kPositive),
           "that of the line before"),
       otherwise(quantity_row("operation.test_tension", of(fills(&Anchor::test_tension)),
                              "Of anchor_move: tension with which the anchor's holding is tested.", kForce, kPositive),
                 "no test")});
  return rows;
}

}  // namespace

std::vector<Field> operation() {
  Field type = required(row_of_kind(
      FieldKind::choice, "operation.type", fills(&Operation::type),
      "moored: the vessel on its lines in several stages; pull_ahead: it moves ahead on its "
      "winches, or by dynamic positioning; anchor_move: an anchor is taken up and laid down elsewhere; "
      "anchor_plan: which "
      "anchor has to be moved before which joint; abandonment: the pipe goes down on a cable; "
      "recovery: it comes up again, the stages in reverse order; lay_down: the end of the line, "
      "as abandonment; start_up: the first pipe is pulled off the vessel by a cable to an anchor; "
      "move: the vessel goes ahead and the pipe with its segments leaves it; passage: what is built into "
      "the pipe goes down the line; ballast: a tank of the stinger is flooded or emptied; shore_pull: a winch at a "
      "distance draws the pipe from the vessel along the seabed by a cable; hold_back: the vessel draws it "
      "back, the winch holds; lift: lines are hauled and paid out, the vessel moves, ends of pipe are welded."));
  for (const OperationType operation :
       {OperationType::moored, OperationType::pull_ahead, OperationType::anchor_move, OperationType::anchor_plan,
        OperationType::abandonment, OperationType::recovery, OperationType::lay_down, OperationType::start_up,
        OperationType::move, OperationType::passage, OperationType::ballast, OperationType::shore_pull,
        OperationType::hold_back, OperationType::lift}) {
    type.choices.emplace_back(word_of(operation));
  }
  std::vector<Field> rows = {
      otherwise(group_row("operation", enters(&Description::operation),
                          "What is done with the moored vessel, or with the line."),
                "nothing"),
      type,
      quantity_row("operation.distance", defaults(&Operation::distance),
                   "Of pull_ahead: distance ahead, astern negative; of anchor_plan: of each joint.", kLength,
                   {.low = -1000.0, .high = 1000.0}),
      quantity_row("operation.speed", defaults(&Operation::speed), "Of pull_ahead: speed of the vessel.", kSpeed,
                   {.low = 0.0, .high = 5.0, .low_open = true}),
      quantity_row("operation.acceleration_time", defaults(&Operation::acceleration_time),
                   "Of pull_ahead: time to reach that speed, and to stop.", kTime, {.low = 0.0, .high = 3600.0}),
      quantity_row("operation.start", defaults(&Operation::start), "Of pull_ahead: time at which it begins.", kTime,
                   kNotNegative),
      row_of_kind(FieldKind::integer, "operation.moves", defaults(&Operation::moves),
                  "Of pull_ahead: number of such moves, one after the other; of anchor_plan: of joints.",
                  {.low = 1.0, .high = 1000.0}),
      quantity_row("operation.wait", defaults(&Operation::wait), "Of pull_ahead: time between two moves.", kTime,
                   {.low = 0.0, .high = 86400.0}),
      row_of_kind(
          FieldKind::choice, "operation.shape", defaults(&Operation::shape),
          "Of pull_ahead: speed in time. trapezoid: with ramps of acceleration_time; minimum_jerk: as smooth as "
          "can be, with `speed` its largest; zero_vibration: trapezoid in two halves, half a natural period of "
          "surge apart, so that the vessel does not swing on afterwards."),
      list_row("operation.loads", enters(&Operation::loads), "Of pull_ahead: loads on the vessel besides vessel.loads.",
               "none")};
  append(rows, vessel_load_rows("operation.loads"));
  append(rows, anchor_move());
  append(rows, lay_operation());
  append(rows, operation_stages());
  rows.push_back(passing_structure());
  return rows;
}

}  // namespace overbend::field_rows
