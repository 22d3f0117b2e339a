#include "resultfiles/static/results_reader.h"

#include "resultfiles/hdf5/check_hdf5.h"
#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/lines/bodies_files.h"
#include "resultfiles/lines/lift_hdf5.h"
#include "resultfiles/lines/lines_files.h"
#include "resultfiles/moored/mooring_hdf5.h"
#include "resultfiles/static/sensitivity_files.h"
#include "results/fields/attachment_fields.h"
#include "results/fields/dragging_fields.h"
#include "results/fields/ground_fields.h"
#include "results/fields/lay_operation_fields.h"
#include "results/fields/route_fields.h"
#include "results/fields/static_scalars.h"
#include "results/fields/static_tables.h"
#include "results/fields/stinger_fields.h"

namespace overbend {
namespace {

void read_region(const Hdf5Reader& file, const std::string& group, RegionResult& region) {
  visit_region(region, [&](const ResultField& field, Extreme& extreme) {
    ValueReader visit{file, group + "/" + field.name};
    visit_extreme_fields(field, extreme, visit);
  });
}

void read_supports(const Hdf5Reader& file, const std::string& group, StaticResults& results) {
  TableReader boxes(file, group + "/supports"), rows(file, group + "/rows"), rollers(file, group + "/rollers");
  results.supports.resize(boxes.rows("index"));
  std::vector<SupportResult*> all_boxes;
  for (std::size_t i = 0; i < results.supports.size(); ++i) {
    boxes.start_row(i);
    visit_support(results.supports[i], boxes);
    all_boxes.push_back(&results.supports[i]);
  }
  for (std::size_t i = 0, count = rows.rows("index"); i < count; ++i) {
    rows.start_row(i);
    int box = -1;
    rows(ResultField{"support"}, box);
    visit_row(owner(all_boxes, box, "row").rows.emplace_back(), rows);
  }
  std::vector<RowResult*> all_rows;  // rows are numbered over all boxes
  for (SupportResult& support : results.supports) {
    for (RowResult& row : support.rows) all_rows.push_back(&row);
  }
  for (std::size_t i = 0, count = rollers.rows("index"); i < count; ++i) {
    rollers.start_row(i);
    int row = -1;
    rollers(ResultField{"row"}, row);
    visit_roller(owner(all_rows, row, "roller").rollers.emplace_back(), rollers);
  }
}

void read_tables(const Hdf5Reader& file, const std::string& group, StaticResults& results) {
  TableReader stations(file, group + "/stations"), sections(file, group + "/sections");
  results.stations.resize(stations.rows("s"));
  for (std::size_t i = 0; i < results.stations.size(); ++i) {
    stations.start_row(i);
    visit_station(results.stations[i], stations);
  }
  results.sections.resize(sections.rows("index"));
  for (std::size_t i = 0; i < results.sections.size(); ++i) {
    sections.start_row(i);
    visit_section(results.sections[i], sections);
  }
  if (!file.has(group + "/structures")) return;
  TableReader structures(file, group + "/structures");
  results.structures.resize(structures.rows("index"));
  for (std::size_t i = 0; i < results.structures.size(); ++i) {
    structures.start_row(i);
    visit_structure(results.structures[i], structures);
  }
}

/// Reads the rows of a table that exists only if it has any.
template <class Row, class Visit>
void read_rows(const Hdf5Reader& file, const std::string& group, std::vector<Row>& rows, Visit visit_row) {
  if (!file.has(group)) return;
  TableReader table(file, group);
  rows.resize(table.rows("index"));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    table.start_row(i);
    visit_row(rows[i], table);
  }
}

void read_attachments(const Hdf5Reader& file, const std::string& group, StaticResults& results) {
  read_rows(file, group + "/points", results.points, [](auto& row, auto& visit) { visit_pipe_point(row, visit); });
  read_rows(file, group + "/wires", results.wires, [](auto& row, auto& visit) { visit_pipe_wire(row, visit); });
}

void read_stinger(const Hdf5Reader& file, const std::string& group, StaticResults& results) {
  if (!file.has(group + "/stinger")) return;
  TableReader sections(file, group + "/stinger");
  results.stinger.resize(sections.rows("index"));
  for (std::size_t i = 0; i < results.stinger.size(); ++i) {
    sections.start_row(i);
    visit_stinger_section(results.stinger[i], sections);
  }
  if (!file.has(group + "/stinger_tanks")) return;
  TableReader tanks(file, group + "/stinger_tanks");
  for (std::size_t i = 0; i < tanks.rows("index"); ++i) {
    tanks.start_row(i);
    int section = 0;
    tanks(ResultField{"section"}, section);
    StingerSectionResult& section_result = results.stinger.at(static_cast<std::size_t>(section));
    visit_stinger_tank(section_result.tanks.emplace_back(), tanks);
  }
}

void read_cable_parts(const Hdf5Reader& file, const std::string& group, StaticResults& results) {
  ValueReader visit{file, group + "/head"};
  if (file.has(visit.group)) visit_head(results.head.emplace(), visit);
  visit.group = group + "/cable";
  if (file.has(visit.group)) visit_cable(results.cable.emplace(), visit);
  visit.group = group + "/far_anchor";
  if (file.has(visit.group)) visit_far_anchor(results.far_anchor.emplace(), visit);
}

void read_dragging(const Hdf5Reader& file, const std::string& group, StaticResults& results) {
  if (!file.has(group)) return;
  DraggingResults& dragging = results.dragging.emplace();
  ValueReader visit{file, group};
  visit_dragging(dragging, visit);
  visit.group = group + "/lift_off";
  if (file.has(visit.group)) visit_lift_off(dragging.lift_off.emplace(), visit);
  if (!file.has(group + "/contacts")) return;
  TableReader contacts(file, group + "/contacts");
  dragging.contacts.resize(contacts.rows("index"));
  for (std::size_t i = 0; i < dragging.contacts.size(); ++i) {
    contacts.start_row(i);
    visit_bed_contact(dragging.contacts[i], contacts);
  }
}

void read_bed(const Hdf5Reader& file, const std::string& group, StaticResults& results) {
  if (!file.has(group)) return;
  BedResults& bed = results.bed.emplace();
  ValueReader visit{file, group};
  visit_laid_pipe(bed, visit);
  TableReader contacts(file, group + "/contacts"), spans(file, group + "/spans"), heights(file, group + "/heights");
  bed.heights.resize(heights.rows("x"));
  for (std::size_t i = 0; i < bed.heights.size(); ++i) {
    heights.start_row(i);
    visit_bed_height(bed.heights[i], heights);
  }
  bed.contacts.resize(contacts.rows("index"));
  for (std::size_t i = 0; i < bed.contacts.size(); ++i) {
    contacts.start_row(i);
    visit_bed_contact(bed.contacts[i], contacts);
  }
  bed.spans.resize(spans.rows("index"));
  for (std::size_t i = 0; i < bed.spans.size(); ++i) {
    spans.start_row(i);
    visit_free_span(bed.spans[i], spans);
  }
}

void read_route_parts(const Hdf5Reader& file, const std::string& group, StaticResults& results) {
  ValueReader visit{file, group + "/route"};
  if (file.has(visit.group)) visit_route(results.route.emplace(), visit);
  if (!file.has(group + "/roller_friction")) return;
  TableReader cases(file, group + "/roller_friction");
  results.roller_friction.resize(cases.rows("index"));
  for (std::size_t i = 0; i < results.roller_friction.size(); ++i) {
    cases.start_row(i);
    visit_friction_case(results.roller_friction[i], cases);
  }
}

}  // namespace

StaticResults read_lay_group(const Hdf5Reader& file, const std::string& group) {
  StaticResults results;
  ValueReader visit{file, group};
  results.checks = read_checks(file, group + "/checks");
  if (!file.has(group + "/stations")) {
    visit_heading(results, visit);
    return results;
  }
  visit_key_results(results, visit);
  visit.group = group + "/touchdown";
  visit_touchdown(results.touchdown, visit);
  read_attachments(file, group, results);
  visit.group = group + "/sums";
  visit_sums(results, visit);
  visit.group = group + "/solve";
  visit_solve(results.solve, visit);
  visit.group = group + "/scene";
  visit_scene(results, visit);
  if (file.has(group + "/overbend")) read_region(file, group + "/overbend", results.overbend.emplace());
  visit.group = group + "/smallest_tension";
  visit_extreme_fields(min_effective_tension_field(), results.min_effective_tension, visit);
  if (file.has(group + "/tower")) read_region(file, group + "/tower", results.tower.emplace());
  read_region(file, group + "/sagbend", results.sagbend);
  read_tables(file, group, results);
  read_supports(file, group, results);
  read_cable_parts(file, group, results);
  read_dragging(file, group + "/dragging", results);
  read_bed(file, group + "/bed", results);
  read_stinger(file, group, results);
  read_route_parts(file, group, results);
  return results;
}

StoredStatics read_static_results(const std::filesystem::path& h5) {
  const Hdf5Reader file(h5);
  StoredStatics stored;
  ValueReader visit{file, "/model"};
  visit(ResultField{"text"}, stored.model_text);
  visit(ResultField{"file"}, stored.model_file);
  visit.group = "/model/stage";
  if (file.has(visit.group)) visit_lay_stage(stored.stage.emplace(), visit);
  StaticResults& results = stored.results;
  results = read_lay_group(file, "/static");
  results.moorings = read_moorings(file);
  results.hull = read_hull(file);
  results.lines = read_lines(file);
  results.bodies = read_bodies(file, "/bodies");
  if (file.has("/lift")) results.lift = read_lift_group(file, "/lift").lift;
  stored.sensitivities = read_sensitivities(file);
  return stored;
}

}  // namespace overbend
