#include "resultfiles/moored/mooring_tables.h"

#include <algorithm>
#include <limits>

#include "resultfiles/tables/csv_fields.h"
#include "resultfiles/tables/finite_visitor.h"
#include "results/fields/moored_fields.h"
#include "results/fields/mooring_fields.h"

namespace overbend {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

template <class Visit>
void visit_table_row(const std::string& state, const MooringLineResult& line, Visit& visit) {
  visit(ResultField{"state", "1", "Static or the stage of the operation"}.csv("state"), state);
  visit_mooring_line(line, visit);
  visit(ResultField{"utilisation", "1", "Tension over the minimum breaking load"}.csv("utilisation"),
        line.utilisation.value_or(kNone));
  visit(
      ResultField{"anchor_utilisation", "1", "Tension at the anchor over its holding power"}.csv("anchor utilisation"),
      line.anchor_utilisation.value_or(kNone));
  visit(ResultField{"clearance", "m", "Minimum distance to the objects on the seabed"}.csv("clearance"),
        line.clearance.value_or(kNone));
}

/// Columns of a dynamic analysis.
template <class Visit>
void visit_in_time(const MooringLineDynamics& line, Visit& visit) {
  const auto tension = [&](const char* name, const char* heading, double value) {
    visit(ResultField{name, "N", "Tension over time"}.csv(heading), value);
  };
  tension("fairlead_tension_mean", "mean fairlead tension", line.fairlead_tension.whole.mean);
  tension("fairlead_tension_std", "std fairlead tension", line.fairlead_tension.whole.std);
  tension("fairlead_tension_min", "least fairlead tension", line.fairlead_tension.whole.min);
  tension("fairlead_tension_max", "largest fairlead tension", line.fairlead_tension.whole.max);
  tension("fairlead_tension_most_probable_max", "most probable largest fairlead tension",
          line.fairlead_tension.most_probable_max.value_or(kNone));
  tension("anchor_tension_max", "largest anchor tension", line.anchor_tension.whole.max);
  visit(
      ResultField{"utilisation_max", "1", "Largest tension over the minimum breaking load"}.csv("largest utilisation"),
      line.utilisation.value_or(kNone));
  visit(ResultField{"least_on_bed", "m", "Minimum unstressed length on the seabed"}.csv("least on bed"),
        line.min_on_seabed);
}

/// Empty cells for a stage that is not the start of the dynamic analysis, or for a line that it does not contain.
MooringLineDynamics missing_line_dynamics() {
  MooringLineDynamics line;
  line.fairlead_tension.whole = {kNone, kNone, kNone, kNone};
  line.anchor_tension.whole.max = line.min_on_seabed = kNone;
  return line;
}

}  // namespace

std::vector<const MooredState*> moored_states(const MooringResults& results) {
  std::vector<const MooredState*> states = {&results.rest};
  for (const MooredState& stage : results.stages) states.push_back(&stage);
  return states;
}

void require_finite(const HullResults& hull) {
  FiniteVisitor visit{"hull."};
  visit_hull(hull, visit);
  visit_steady_loads(hull, visit);
  for (const RadiationEntryResult& entry : hull.entries) visit_radiation_entry(entry, visit);
  for (const RadiationGroupResult& group : hull.groups) visit_radiation_group(group, visit);
  for (const ModeDampingResult& mode : hull.damping) visit_mode_damping(mode, visit);
}

void require_finite(const MooringResults& results) {
  for (const MooredState* state : moored_states(results)) {
    FiniteVisitor visit{state->name + ".vessel."};
    visit_vessel_offset(state->vessel, visit);
    for (const MooringLineResult& line : state->moorings) {
      visit.place = state->name + ".moorings." + line.name + ".";
      visit_mooring_line(line, visit);
      visit_mooring_use(line, visit);
    }
  }
}

std::string moorings_table(const MooringResults& results, const std::vector<MooringLineDynamics>& in_time) {
  CsvHead head;
  visit_table_row("", MooringLineResult{}, head);
  if (!in_time.empty()) visit_in_time(MooringLineDynamics{}, head);
  CsvTable table(head.names);
  const MooringLineDynamics absent = missing_line_dynamics();
  for (const MooredState* state : moored_states(results)) {
    for (const MooringLineResult& line : state->moorings) {
      CsvCells cells{table};
      visit_table_row(state->name, line, cells);
      if (!in_time.empty()) {
        const auto found = std::find_if(in_time.begin(), in_time.end(), [&](const auto& candidate) {
          return state == &results.rest && candidate.name == line.name;
        });
        visit_in_time(found == in_time.end() ? absent : *found, cells);
      }
      table.end_row();
    }
  }
  return table.text();
}

}  // namespace overbend
