#include "recording/move_recorder.h"

#include <fmt/format.h>

#include "base/shown_unit.h"
#include "model/description/description_enum_names.h"

namespace overbend {

namespace {

void warn_of_tensioner(const TensionerDescription& tensioner, const MoveProfile& move, DynamicResults& results) {
  const SummaryStatistics& travel = results.tensioner.travel;
  if (results.tensioner.mode == enum_name(TensionerMode::locked) && travel.max == travel.min) {
    results.findings.push_back(Finding{FindingCode::tensioner_locked_in_move,
                                       "the tensioner is locked while the vessel moves: no pipe is paid out, and the "
                                       "tension is that of the pulled pipe"}
                                   .on("tensioner"));
  } else if (tensioner.velocity > 0.0 && tensioner.velocity < move.speed) {
    results.findings.push_back(
        Finding{FindingCode::tensioner_slower_than_vessel,
                fmt::format("the tensioner pays out at most {}, but the vessel moves at {}: it cannot follow",
                            shown(tensioner.velocity, "m/s", 2), shown(move.speed, "m/s", 2))}
            .on("tensioner")
            .with("velocity", tensioner.velocity, "m/s"));
  }
  if (tensioner.travel) {
    results.findings.push_back(Finding{
        FindingCode::tensioner_travel_not_applied,
        fmt::format("the tensioner's travel of {} is not applied: while the vessel moves, pipe is fed without limit",
                    shown(*tensioner.travel, "m", 2))}
                                   .on("tensioner")
                                   .with("travel", *tensioner.travel, "m"));
  }
}

}  // namespace

void add_move_columns(std::vector<RecordedColumn>& columns, bool pipe) {
  columns.push_back({{"operation/advance", "m", "Planned advance of the vessel's mean position", false, false},
                     [](const RowSource& row) { return row.instant.move.planned.distance; }});
  if (!pipe) return;
  columns.push_back({{"tensioner/paid_out", "m", "Pipe paid out by the tensioner since the start", false, false},
                     [](const RowSource& row) { return row.instant.move.paid_out; }});
  columns.push_back({{"operation/joints", "1", "Number of pipe joints fed at the tensioner", false, false},
                     [](const RowSource& row) { return row.instant.move.joints; }});
}

void assume_of_move(const Model& model, const MoveProfile& move, DynamicResults& results) {
  const bool prescribed = model.description.vessel.motion != VesselMotion::coupled;
  results.assumptions.push_back(
      {AssumptionRank::other,
       fmt::format("The vessel {} {} ahead in {} from t = {:.0f} s on{}.",
                   prescribed ? "moves as prescribed, regardless of the tension," : "is pulled",
                   shown(move.total_distance(), "m", 2),
                   move.moves == 1 ? "one move" : fmt::format("{} moves", move.moves), move.start,
                   model.description.has_pipe ? "; paid-out pipe joins the line element by element, and its weight "
                                                "between the guide and the last element is neglected"
                                              : "")});
}

void warn_of_move(const Model& model, const MoveProfile& move, DynamicResults& results) {
  if (move.end() > results.duration) {
    results.findings.push_back(
        {FindingCode::run_shorter_than_operation,
         fmt::format(
             "the run is too short for the operation: it ends at t = {:.0f} s, the last of {} moves at {:.0f} s",
             results.duration, move.moves, move.end())});
  }
  if (model.description.has_pipe) warn_of_tensioner(model.description.tensioner, move, results);
}

}  // namespace overbend
