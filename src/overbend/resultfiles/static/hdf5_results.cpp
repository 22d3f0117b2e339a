#include "platform/machine.h"
#include "resultfiles/hdf5/check_hdf5.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/hdf5/object_links.h"
#include "resultfiles/lines/bodies_files.h"
#include "resultfiles/lines/lift_hdf5.h"
#include "resultfiles/lines/lines_files.h"
#include "resultfiles/moored/mooring_hdf5.h"
#include "resultfiles/static/results_writer.h"
#include "resultfiles/static/sensitivity_files.h"
#include "results/fields/attachment_fields.h"
#include "results/fields/dragging_fields.h"
#include "results/fields/ground_fields.h"
#include "results/fields/lay_operation_fields.h"
#include "results/fields/route_fields.h"
#include "results/fields/static_scalars.h"
#include "results/fields/static_tables.h"
#include "results/fields/stinger_fields.h"
#include "runstore/run_record.h"

namespace overbend {
namespace {

void write_region(DatasetSink& file, const std::string& group, const std::string& description,
                  const RegionResult& region) {
  file.group(group, description);
  visit_region(region, [&](const ResultField& field, const Extreme& extreme) {
    ValueWriter visit{file, group + "/" + field.name};
    file.group(visit.group, std::string(field.description));
    visit_extreme_fields(field, extreme, visit);
  });
}

void write_supports(DatasetSink& file, const std::string& group, const StaticResults& results) {
  TableWriter boxes, rows, rollers;
  for (const SupportResult& support : results.supports) {
    for (const RowResult& row : support.rows) {
      for (const RollerResult& roller : row.rollers) {
        rollers(index_field("Number of the roller, from 0"), rollers.rows());
        rollers(ResultField{"row", "1", "Index of its row in the table of rows"}, rows.rows());
        visit_roller(roller, rollers);
        rollers.end_row();
      }
      rows(index_field("Number of the row, from 0"), rows.rows());
      rows(ResultField{"support", "1", "Index of its box in the table of supports"}, boxes.rows());
      visit_row(row, rows);
      rows.end_row();
    }
    boxes(index_field("Number of the box, from 0"), boxes.rows());
    visit_support(support, boxes);
    boxes.end_row();
  }
  boxes.write(file, group + "/supports", "Roller boxes");
  rows.write(file, group + "/rows", "Rows of rollers");
  rollers.write(file, group + "/rollers", "Rollers: bottom first, then port and starboard");
}

void write_tables(DatasetSink& file, const std::string& group, const StaticResults& results) {
  TableWriter stations, sections, structures;
  for (const StructureResult& structure : results.structures) {
    structures(index_field("Number of the structure, from 0"), structures.rows());
    visit_structure(structure, structures);
    structures.end_row();
  }
  for (const Station& station : results.stations) {
    visit_station(station, stations);
    stations.end_row();
  }
  for (const DerivedSection& section : results.sections) {
    sections(index_field("Number of the section, from 0: first that of the line itself"), sections.rows());
    visit_section(section, sections);
    sections.end_row();
  }
  stations.write(file, group + "/stations", "Stations of the pipe from the anchor to the tensioner");
  sections.write(file, group + "/sections", "Properties of the sections");
  structures.write(file, group + "/structures", "Structures built into the pipe");
}

void write_attachments(DatasetSink& file, const std::string& group, const StaticResults& results) {
  TableWriter points, wires;
  for (const PipePointResult& point : results.points) {
    points(index_field("Number of the point, from 0"), points.rows());
    visit_pipe_point(point, points);
    points.end_row();
  }
  for (const PipeWireResult& wire : results.wires) {
    wires(index_field("Number of the wire, from 0"), wires.rows());
    visit_pipe_wire(wire, wires);
    wires.end_row();
  }
  if (!results.points.empty()) points.write(file, group + "/points", "Clumps and buoys on the pipe");
  if (!results.wires.empty()) wires.write(file, group + "/wires", "Wires on the pipe");
}

void write_stinger(DatasetSink& file, const std::string& group, const StaticResults& results) {
  if (results.stinger.empty()) return;
  TableWriter sections, tanks;
  for (const StingerSectionResult& section : results.stinger) {
    for (const StingerTankResult& tank : section.tanks) {
      tanks(index_field("Number of the tank, from 0"), tanks.rows());
      tanks(ResultField{"section", "1", "Index of its section in the table of sections"}, sections.rows());
      visit_stinger_tank(tank, tanks);
      tanks.end_row();
    }
    sections(index_field("Number of the section, from 0 at the vessel"), sections.rows());
    visit_stinger_section(section, sections);
    sections.end_row();
  }
  sections.write(file, group + "/stinger", "Sections of the stinger on their hinges");
  tanks.write(file, group + "/stinger_tanks", "Tanks of the stinger");
}

template <class Function, class Part>
void write_part(DatasetSink& file, const std::string& group, const std::string& description, Function visit_part,
                const Part& part) {
  file.group(group, description);
  ValueWriter visit{file, group};
  visit_part(part, visit);
}

/// Writes head, cable and anchor of a line with a cable.
void write_cable_parts(DatasetSink& file, const std::string& group, const StaticResults& results) {
  const auto head = [](const auto& part, auto& visit) { visit_head(part, visit); };
  const auto cable = [](const auto& part, auto& visit) { visit_cable(part, visit); };
  const auto anchor = [](const auto& part, auto& visit) { visit_far_anchor(part, visit); };
  if (results.head) write_part(file, group + "/head", "Head of the line", head, *results.head);
  if (results.cable) write_part(file, group + "/cable", "Cable of the line", cable, *results.cable);
  if (results.far_anchor) {
    write_part(file, group + "/far_anchor", "Anchor at the far end of the cable", anchor, *results.far_anchor);
  }
}

/// Writes a line dragged along the seabed.
void write_dragging(DatasetSink& file, const std::string& group, const DraggingResults& dragging) {
  write_part(
      file, group, "Line dragged along the seabed", [](const auto& part, auto& visit) { visit_dragging(part, visit); },
      dragging);
  if (dragging.lift_off) {
    write_part(
        file, group + "/lift_off", "Where the line leaves the seabed before the winch",
        [](const auto& part, auto& visit) { visit_lift_off(part, visit); }, *dragging.lift_off);
  }
  TableWriter contacts;
  for (const BedContactResult& contact : dragging.contacts) {
    contacts(index_field("Number of the contact, from 0: from touchdown astern"), contacts.rows());
    visit_bed_contact(contact, contacts);
    contacts.end_row();
  }
  contacts.write(file, group + "/contacts", "Stretches in contact with the seabed");
}

/// Writes the laid pipe on an uneven seabed.
void write_bed(DatasetSink& file, const std::string& group, const BedResults& bed) {
  write_part(
      file, group, "Laid pipe on an uneven seabed", [](const auto& part, auto& visit) { visit_laid_pipe(part, visit); },
      bed);
  TableWriter contacts, spans, heights;
  for (const BedHeight& height : bed.heights) {
    visit_bed_height(height, heights);
    heights.end_row();
  }
  for (const BedContactResult& contact : bed.contacts) {
    contacts(index_field("Number of the contact, from 0: from touchdown astern"), contacts.rows());
    visit_bed_contact(contact, contacts);
    contacts.end_row();
  }
  for (const FreeSpanResult& span : bed.spans) {
    spans(index_field("Number of the span, from 0: from touchdown astern"), spans.rows());
    visit_free_span(span, spans);
    spans.end_row();
  }
  contacts.write(file, group + "/contacts", "Stretches in contact with the seabed");
  heights.write(file, group + "/heights", "Heights of the seabed under the line, for figures");
  spans.write(file, group + "/spans", "Free spans between them");
}

/// Writes the position of the pipe on its route, and the limit cases of friction.
void write_route_parts(DatasetSink& file, const std::string& group, const StaticResults& results) {
  const auto route = [](const auto& part, auto& visit) { visit_route(part, visit); };
  if (results.route) write_part(file, group + "/route", "Pipe on its route", route, *results.route);
  if (results.roller_friction.empty()) return;
  TableWriter cases;
  for (const RollerFrictionCase& answer : results.roller_friction) {
    cases(index_field("Number of the case, from 0"), cases.rows());
    visit_friction_case(answer, cases);
    cases.end_row();
  }
  cases.write(file, group + "/roller_friction", "Limit cases of friction");
}

}  // namespace

void write_model_group(DatasetSink& file, const Description& description) {
  file.group("/model", "Model and program version");
  ValueWriter visit{file, "/model"};
  write_model_text(file, description.source_text);
  visit(ResultField{"file", "1", "Path of the model file as given"}, description.source_file);
  visit(ResultField{"version", "1", "Version of the program"}, std::string(OVERBEND_VERSION));
  visit(ResultField{"machine", "1", "Operating system, its release and the architecture"}, machine_name());
  visit(ResultField{"compiler", "1", "Compiler of the program"}, compiler_name());
  if (!description.stage) return;
  visit.group = "/model/stage";
  file.group(visit.group, "Stage of the operation that the results belong to");
  visit_lay_stage(*description.stage, visit);
}

void write_model_text(DatasetSink& file, const std::string& text) {
  ValueWriter visit{file, "/model"};
  visit(ResultField{"text", "1", "Text of the model file"}, text);
  visit(ResultField{"hash", "1", "FNV-1a (64 bit) of the text"}, text_hash(text));
}

void write_lay_group(DatasetSink& file, const std::string& group, const StaticResults& results) {
  const auto keys = [](const auto& part, auto& visit) {
    part.has_pipe() ? visit_key_results(part, visit) : visit_heading(part, visit);
  };
  const auto touchdown = [](const auto& part, auto& visit) { visit_touchdown(part, visit); };
  const auto sums = [](const auto& part, auto& visit) { visit_sums(part, visit); };
  const auto solve = [](const auto& part, auto& visit) { visit_solve(part, visit); };
  const auto scene = [](const auto& part, auto& visit) { visit_scene(part, visit); };
  write_part(file, group, results.has_pipe() ? "Static equilibrium: key results" : "Static state", keys, results);
  if (!results.has_pipe()) return write_checks(file, group + "/checks", results.checks);
  write_part(file, group + "/touchdown", "Touchdown", touchdown, results.touchdown);
  write_part(file, group + "/sums", "Sums of forces on the line", sums, results);
  write_part(file, group + "/solve", "Solver statistics", solve, results.solve);
  write_part(file, group + "/scene", "Geometry for figures", scene, results);
  if (results.overbend) {
    write_region(file, group + "/overbend", "Extremes from the tensioner to the inflection below the last support",
                 *results.overbend);
  }
  const ResultField min_tension = min_effective_tension_field();
  const auto visit_min_tension = [&](const auto& part, auto& visit) { visit_extreme_fields(min_tension, part, visit); };
  write_part(file, group + "/" + min_tension.name, std::string(min_tension.description), visit_min_tension,
             results.min_effective_tension);
  if (results.tower) {
    write_region(file, group + "/tower", "Extremes where the clamped guide bends the pipe", *results.tower);
  }
  write_region(file, group + "/sagbend", "Extremes from the inflection to touchdown", results.sagbend);
  write_tables(file, group, results);
  write_attachments(file, group, results);
  write_supports(file, group, results);
  write_stinger(file, group, results);
  write_checks(file, group + "/checks", results.checks);
  write_cable_parts(file, group, results);
  if (results.dragging) write_dragging(file, group + "/dragging", *results.dragging);
  if (results.bed) write_bed(file, group + "/bed", *results.bed);
  write_route_parts(file, group, results);
}

void write_results_heading(DatasetSink& file, const std::string& title, const Description& description) {
  file.attribute("/", "Conventions", "overbend-results-1; SI units; attributes units, frame, description");
  file.attribute("/", "title", title);
  file.attribute("/", "source", "overbend " OVERBEND_VERSION);
  write_model_group(file, description);
}

void write_static_groups(DatasetSink& file, const StaticResults& results, const Description& description) {
  write_results_heading(file, results.title, description);
  write_static_parts(file, results);
}

void write_static_parts(DatasetSink& file, const StaticResults& results) {
  write_lay_group(file, "/static", results);
  if (results.moorings) write_moorings(file, *results.moorings);
  if (results.hull) write_hull(file, *results.hull);
  write_lines(file, results.lines);
  write_bodies(file, "/bodies", results.bodies);
  if (results.lift) write_lift_group(file, "/lift", results);
}

void write_static_hdf5(const StaticResults& results, const Description& description, const std::filesystem::path& path,
                       const SensitivityResults* sensitivities) {
  Hdf5Writer file(path);
  write_static_groups(file, results, description);
  if (sensitivities != nullptr) write_sensitivities(file, *sensitivities);
  link_objects(file, results);
  file.close();
}

}  // namespace overbend
