#include "model/description_words.h"
#include "modelfile/row_makers.h"

namespace overbend::field_rows {
namespace {

using Operation = OperationDescription;

std::vector<Field> stages() {
  using Stage = MooredStageDescription;
  const std::string s = "operation.stages[]";
  std::vector<Field> rows = {
      list_row("operation.stages", enters(&Operation::stages), "Of moored: load cases, each from the vessel as drawn.",
               "the model as it is"),
      group_row(s, appends_named<Stage>("stage"), "One stage."),
      otherwise(row_of_kind(FieldKind::text, s + ".name", fills(&Stage::name), "Name in the results."),
                "stage 1, 2, ..."),
      list_row(s + ".parted", enters(&Stage::parted), "Names of mooring lines that are not there.", "none"),
      row_of_kind(FieldKind::text, s + ".parted[]", appends_value<std::string>(), "A name under moorings.lines."),
      list_row(s + ".loads", enters(&Stage::loads), "Loads on the vessel besides vessel.loads.", "none")};
  append(rows, vessel_load_rows(s + ".loads"));
  return rows;
}

}  // namespace

std::vector<Field> operation() {
  Field type =
      required(row_of_kind(FieldKind::choice, "operation.type", fills(&Operation::type),
                           "moored: the vessel on its lines in several stages; pull_ahead: it moves ahead on its "
                           "winches."));
  type.choices = {word_of(OperationType::moored), word_of(OperationType::pull_ahead)};
  std::vector<Field> rows = {
      otherwise(group_row("operation", enters(&Description::operation), "What is done with the moored vessel."),
                "nothing"),
      type,
      quantity_row("operation.distance", defaults(&Operation::distance),
                   "Of pull_ahead: distance ahead, astern negative.", kLength, {.low = -1000.0, .high = 1000.0}),
      quantity_row("operation.speed", defaults(&Operation::speed), "Of pull_ahead: speed of the vessel.", kSpeed,
                   {.low = 0.0, .high = 5.0, .low_open = true}),
      quantity_row("operation.acceleration_time", defaults(&Operation::acceleration_time),
                   "Of pull_ahead: time to reach that speed, and to stop.", kTime, {.low = 0.0, .high = 3600.0}),
      quantity_row("operation.start", defaults(&Operation::start), "Of pull_ahead: time at which it begins.", kTime,
                   kNotNegative),
      row_of_kind(FieldKind::integer, "operation.moves", defaults(&Operation::moves),
                  "Of pull_ahead: number of such moves, one after the other.", {.low = 1.0, .high = 1000.0}),
      list_row("operation.loads", enters(&Operation::loads), "Of pull_ahead: loads on the vessel besides vessel.loads.",
               "none")};
  append(rows, vessel_load_rows("operation.loads"));
  append(rows, stages());
  return rows;
}

}  // namespace overbend::field_rows
