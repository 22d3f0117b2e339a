#include "resultfiles/mooring_writer.h"

#include <limits>

#include "resultfiles/csv_fields.h"
#include "resultfiles/finite_visitor.h"
#include "resultfiles/hdf5_visitors.h"
#include "resultfiles/move_table.h"
#include "results/fields/mooring_fields.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// The rest as drawn first, then the stages.
std::vector<const MooredState*> states_of(const MooringResults& results) {
  std::vector<const MooredState*> states = {&results.rest};
  for (const MooredState& stage : results.stages) states.push_back(&stage);
  return states;
}

template <class Visit>
void visit_table_row(const std::string& state, const MooringLineResult& line, Visit& visit) {
  visit(ResultField{"state", "1", "Static or the stage of the operation"}.csv("state"), state);
  visit_mooring_line(line, visit);
  visit(ResultField{"utilisation", "1", "Tension over the least breaking load"}.csv("utilisation"),
        line.utilisation.value_or(kNone));
  visit(
      ResultField{"anchor_utilisation", "1", "Tension at the anchor over its holding power"}.csv("anchor utilisation"),
      line.anchor_utilisation.value_or(kNone));
  visit(ResultField{"clearance", "m", "Least distance to the objects on the bed"}.csv("clearance"),
        line.clearance.value_or(kNone));
}

void require_finite(const MooringResults& results) {
  for (const MooredState* state : states_of(results)) {
    FiniteVisitor visit{state->name + ".vessel."};
    visit_vessel_offset(state->vessel, visit);
    for (const MooringLineResult& line : state->moorings) {
      visit.place = state->name + ".moorings." + line.name + ".";
      visit_mooring_line(line, visit);
    }
  }
}

void write_hdf5(const MooringResults& results, const Description& description, const std::filesystem::path& path) {
  Hdf5Writer file(path);
  file.attribute("/", "Conventions", "overbend-results-1; SI units; attributes units, frame, description");
  file.attribute("/", "title", results.title);
  file.attribute("/", "source", "overbend " OVERBEND_VERSION);
  file.group("/model", "Model and program version");
  write_model_text(file, description.source_text);
  file.group("/moorings", "Hull and mooring lines at rest");
  TableWriter vessels, lines, shapes;
  for (const MooredState* state : states_of(results)) {
    for (const MooringLineResult& line : state->moorings) {
      for (const Vec3& point : line.shape_W) {
        shapes(index_field("Number of the point, from 0"), shapes.rows());
        shapes(ResultField{"line", "1", "Index of its line in the table of lines"}, lines.rows());
        shapes(ResultField{"", "m", "Point of the line, fairlead to anchor", kWorldFrame}, point);
        shapes.end_row();
      }
      lines(index_field("Number of state and line, from 0"), lines.rows());
      visit_table_row(state->name, line, lines);
      lines.end_row();
    }
    vessels(index_field("Number of the state, from 0"), vessels.rows());
    vessels(ResultField{"state", "1", "Static or the stage of the operation"}, state->name);
    visit_vessel_offset(state->vessel, vessels);
    vessels.end_row();
  }
  vessels.write(file, "/moorings/vessel", "Where the hull lies");
  lines.write(file, "/moorings/lines", "Mooring lines, state by state");
  shapes.write(file, "/moorings/shapes", "Shapes of the lines");
  file.close();
}

}  // namespace

std::string moorings_table(const MooringResults& results) {
  CsvHead head;
  visit_table_row("", MooringLineResult{}, head);
  CsvTable table(head.names);
  for (const MooredState* state : states_of(results)) {
    for (const MooringLineResult& line : state->moorings) {
      CsvCells cells{table};
      visit_table_row(state->name, line, cells);
      table.end_row();
    }
  }
  return table.text();
}

void write_mooring_files(const MooringResults& results, const Description& description,
                         const std::filesystem::path& folder) {
  require_finite(results);
  write_hdf5(results, description, folder / "results.h5");
  write_text(folder / "moorings.csv", moorings_table(results));
  if (!results.steps.empty()) write_text(folder / "pull_ahead.csv", move_table(results));
  write_text(folder / "summary.json", mooring_summary(results));
}

}  // namespace overbend
