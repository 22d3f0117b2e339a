#include "resultfiles/moored/moored_dynamics_hdf5.h"

#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "results/fields/moored_fields.h"

namespace overbend {
namespace {

constexpr const char* kThrust = "/dynamic/thrust";
constexpr const char* kLines = "/dynamic/moorings/lines";
constexpr const char* kEvents = "/dynamic/moorings/events";
constexpr const char* kPoints = "/dynamic/moorings/points";

ResultField line_field() {
  return {"line", "1", "Index of its line in the table of lines"};
}
ResultField share_field() {
  return {"share", "1", "Position on the line: share of its length, from the anchor"};
}

/// Returns the line that a row of `table` belongs to.
MooringLineDynamics& find_line(TableReader& table, std::vector<MooringLineDynamics>& lines, const char* what) {
  int line = -1;
  table(line_field(), line);
  if (line < 0 || line >= static_cast<int>(lines.size())) {
    throw std::runtime_error(std::string("a ") + what + " has no parent row");
  }
  return lines[static_cast<std::size_t>(line)];
}

}  // namespace

void write_moored_dynamics(DatasetSink& file, const DynamicResults& results) {
  if (results.vessel) {
    file.group("/dynamic/vessel", "Motion of the floating vessel: total, low-frequency and wave-frequency parts");
    ValueWriter values{file, "/dynamic/vessel"};
    visit_vessel_dynamics(*results.vessel, values);
  }
  if (!results.thrust.empty()) {
    TableWriter table;
    for (const ThrustDynamics& thrust : results.thrust) {
      table(index_field("Number of the direction, from 0"), table.rows());
      visit_thrust_dynamics(thrust, table);
      table.end_row();
    }
    table.write(file, kThrust, "Thrust of dynamic positioning");
  }
  if (results.moorings.empty()) return;
  file.group("/dynamic/moorings", "Mooring lines over time");
  TableWriter lines, events, points;
  for (const MooringLineDynamics& line : results.moorings) {
    for (const MooringEvent& event : line.events) {
      events(index_field("Number of the event, from 0"), events.rows());
      events(line_field(), lines.rows());
      visit_mooring_event(event, events);
      events.end_row();
    }
    for (const double share : line.points) {
      points(index_field("Number of the point in the snapshots, from 0"), points.rows());
      points(line_field(), lines.rows());
      points(share_field(), share);
      points.end_row();
    }
    lines(index_field("Number of the line, from 0"), lines.rows());
    visit_mooring_dynamics(line, lines);
    lines.end_row();
  }
  lines.write(file, kLines, "Statistics of mooring lines");
  events.write(file, kEvents, "Events of mooring lines");
  points.write(file, kPoints, "Points of the lines in /dynamic/snapshots");
}

void read_moored_dynamics(const Hdf5Reader& file, DynamicResults& results) {
  if (file.has("/dynamic/vessel")) {
    ValueReader values{file, "/dynamic/vessel"};
    visit_vessel_dynamics(results.vessel.emplace(), values);
  }
  TableReader thrust(file, kThrust);
  results.thrust.resize(thrust.rows("index"));
  for (std::size_t i = 0; i < results.thrust.size(); ++i) {
    thrust.start_row(i);
    visit_thrust_dynamics(results.thrust[i], thrust);
  }
  TableReader lines(file, kLines), events(file, kEvents), points(file, kPoints);
  results.moorings.resize(lines.rows("index"));
  for (std::size_t i = 0; i < results.moorings.size(); ++i) {
    lines.start_row(i);
    visit_mooring_dynamics(results.moorings[i], lines);
  }
  for (std::size_t i = 0, count = events.rows("index"); i < count; ++i) {
    events.start_row(i);
    visit_mooring_event(find_line(events, results.moorings, "mooring event").events.emplace_back(), events);
  }
  for (std::size_t i = 0, count = points.rows("index"); i < count; ++i) {
    points.start_row(i);
    points(share_field(), find_line(points, results.moorings, "point").points.emplace_back());
  }
}

}  // namespace overbend
