#include "resultfiles/moored/move_table.h"

#include <limits>

#include "resultfiles/tables/csv_fields.h"
#include "results/fields/mooring_fields.h"
#include "results/fields/move_fields.h"

namespace overbend {
namespace {

/// Members without a heading in their own tables, with their headings here.
template <class Visit>
void visit_hull(const VesselResult& vessel, Visit& visit) {
  auto named = [&](ResultField field, const double& value) {
    const std::string heading = field.name;
    visit(std::move(field).csv(heading), value);
  };
  visit_vessel_offset(vessel, named);
}

template <class Visit>
void visit_lines(const MooringResults& results, const MoveStep& step, Visit& visit) {
  for (std::size_t i = 0; i < step.lengths.size(); ++i) {
    const std::string& name = results.rest.moorings[i].name;
    const std::string length = name + " first segment", tension = name + " tension";
    visit(ResultField{"first_segment_length", "m"}.csv(length), step.lengths[i]);
    visit(ResultField{"fairlead_tension", "N"}.csv(tension), step.tensions[i]);
  }
}

template <class Visit>
void visit_row(const MooringResults& results, const MoveStep& step, Visit& visit) {
  visit_move_step(step, visit);
  visit_hull(step.vessel, visit);
  visit_lines(results, step, visit);
  if (!step.pipe) return;
  visit_pipe_at_step(*step.pipe, visit);
  visit(ResultField{"stinger_tip_clearance", "m"}.csv("stinger tip clearance"),
        step.pipe->stinger_tip_clearance.value_or(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace

std::string move_table(const MooringResults& results) {
  CsvHead head;
  visit_row(results, results.steps.front(), head);
  CsvTable table(head.names);
  for (const MoveStep& step : results.steps) {
    CsvCells cells{table};
    visit_row(results, step, cells);
    table.end_row();
  }
  return table.text();
}

}  // namespace overbend
