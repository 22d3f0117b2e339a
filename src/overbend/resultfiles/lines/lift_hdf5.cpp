#include "resultfiles/lines/lift_hdf5.h"

#include "resultfiles/hdf5/check_hdf5.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/lines/bodies_files.h"
#include "results/fields/lift_fields.h"
#include "results/fields/static_scalars.h"

namespace overbend {
namespace {

std::string numbered(const std::string& group, const char* list, std::size_t i) {
  return group + "/" + list + "/" + std::to_string(i);
}

/// Calls `each` for the parts of a line that have a position, with their names.
template <class Line, class Each>
void for_places(Line& line, Each each) {
  each("first_end", line.first.location);
  each("second_end", line.second.location);
  each("largest_sagging_moment", line.sagging.location);
  each("largest_hogging_moment", line.hogging.location);
  each("largest_bending_moment", line.bending.location);
}

template <class Line, class Each>
void for_moments(Line& line, Each each) {
  each(ResultField{"sagging_moment", "N m", "Largest sagging moment"}, line.sagging.value);
  each(ResultField{"hogging_moment", "N m", "Largest hogging moment"}, line.hogging.value);
  each(ResultField{"bending_moment", "N m", "Largest bending moment"}, line.bending.value);
}

void write_place(DatasetSink& file, const std::string& group, const LinePlace& place) {
  file.group(group, "A position along the line");
  ValueWriter values{file, group};
  visit_line_place(place, values);
}

void write_numbers(DatasetSink& file, const std::string& path, const char* text, const std::vector<double>& numbers) {
  if (numbers.empty()) return;
  file.write(path, ResultField{"", "m", text}, numbers, {numbers.size()});
}

std::vector<double> read_numbers(const Hdf5Reader& file, const std::string& path) {
  return file.has(path) ? file.doubles(path) : std::vector<double>{};
}

void write_line(DatasetSink& file, const std::string& group, const LiftedLine& line) {
  file.group(group, "Line " + line.name);
  ValueWriter values{file, group};
  visit_lifted_line(line, values);
  for_moments(line, values);
  for_places(line, [&](const char* name, const LinePlace& place) { write_place(file, group + "/" + name, place); });
  for (const auto& [name, end] : {std::pair{"/first_end", &line.first}, {"/second_end", &line.second}}) {
    ValueWriter of_end{file, group + name};
    visit_lifted_end(*end, of_end);
  }
  if (line.lift_off) write_place(file, group + "/lift_off", *line.lift_off);
  std::vector<double> bounds;
  for (const BedStretch& stretch : line.on_bed) bounds.insert(bounds.end(), {stretch.from, stretch.to});
  write_numbers(file, group + "/on_bed", "Start and end of each stretch in contact with the seabed", bounds);
  write_numbers(file, group + "/water_crossings", "Arc lengths at which the axis crosses the water surface",
                line.water_crossings);
  TableWriter nodes;
  for (const LiftedNode& node : line.nodes) {
    visit_lifted_node(node, nodes);
    nodes.end_row();
  }
  nodes.write(file, group + "/nodes", "Nodes from the first end");
}

LiftedLine read_line(const Hdf5Reader& file, const std::string& group) {
  LiftedLine line;
  ValueReader values{file, group};
  visit_lifted_line(line, values);
  for_moments(line, values);
  for_places(line, [&](const char* name, LinePlace& place) {
    ValueReader of_place{file, group + "/" + name};
    visit_line_place(place, of_place);
  });
  for (const auto& [name, end] : {std::pair{"/first_end", &line.first}, {"/second_end", &line.second}}) {
    ValueReader of_end{file, group + name};
    visit_lifted_end(*end, of_end);
  }
  if (file.has(group + "/lift_off")) {
    ValueReader of_place{file, group + "/lift_off"};
    visit_line_place(line.lift_off.emplace(), of_place);
  }
  const std::vector<double> bounds = read_numbers(file, group + "/on_bed");
  for (std::size_t i = 0; i + 1 < bounds.size(); i += 2) line.on_bed.push_back({bounds[i], bounds[i + 1]});
  line.water_crossings = read_numbers(file, group + "/water_crossings");
  TableReader nodes(file, group + "/nodes");
  line.nodes.resize(nodes.rows("arc_length"));
  for (std::size_t node = 0; node < line.nodes.size(); ++node) {
    nodes.start_row(node);
    visit_lifted_node(line.nodes[node], nodes);
  }
  return line;
}

}  // namespace

void write_lift_group(DatasetSink& file, const std::string& group, const StaticResults& results) {
  const LiftResults& lift = *results.lift;
  file.group(group, "Equilibrium of connected lines");
  ValueWriter heading{file, group};
  visit_heading(results, heading);
  write_checks(file, group + "/checks", results.checks);
  file.group(group + "/lines", "Pipe lines");
  for (std::size_t i = 0; i < lift.lines.size(); ++i) write_line(file, numbered(group, "lines", i), lift.lines[i]);
  file.group(group + "/davits", "Lines attached to other lines");
  for (std::size_t i = 0; i < lift.davits.size(); ++i) {
    const std::string below = numbered(group, "davits", i);
    file.group(below, "Line " + lift.davits[i].name);
    ValueWriter values{file, below};
    visit_lifted_wire(lift.davits[i], values);
    visit_line_place(lift.davits[i].location, values);
  }
  write_bodies(file, group + "/bodies", results.bodies);
  if (lift.gap) {
    file.group(group + "/gap", "Ends to be welded");
    ValueWriter values{file, group + "/gap"};
    visit_weld_gap(*lift.gap, values);
  }
  if (lift.join) {
    write_place(file, group + "/join", lift.join->location);
    ValueWriter values{file, group + "/join"};
    visit_weld(*lift.join, values);
  }
}

StaticResults read_lift_group(const Hdf5Reader& file, const std::string& group) {
  StaticResults results;
  ValueReader heading{file, group};
  visit_heading(results, heading);
  results.checks = read_checks(file, group + "/checks");
  LiftResults& lift = results.lift.emplace();
  for (std::size_t i = 0; file.has(numbered(group, "lines", i)); ++i) {
    lift.lines.push_back(read_line(file, numbered(group, "lines", i)));
  }
  for (std::size_t i = 0; file.has(numbered(group, "davits", i)); ++i) {
    ValueReader values{file, numbered(group, "davits", i)};
    LiftedWire& wire = lift.davits.emplace_back();
    visit_lifted_wire(wire, values);
    visit_line_place(wire.location, values);
  }
  results.bodies = read_bodies(file, group + "/bodies");
  if (file.has(group + "/gap")) {
    ValueReader values{file, group + "/gap"};
    visit_weld_gap(lift.gap.emplace(), values);
  }
  if (file.has(group + "/join")) {
    ValueReader values{file, group + "/join"};
    Weld& weld = lift.join.emplace();
    visit_line_place(weld.location, values);
    visit_weld(weld, values);
  }
  return results;
}

}  // namespace overbend
