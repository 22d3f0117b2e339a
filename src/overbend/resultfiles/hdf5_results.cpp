#include "resultfiles/check_hdf5.h"
#include "resultfiles/hdf5_visitors.h"
#include "resultfiles/mooring_hdf5.h"
#include "resultfiles/results_writer.h"
#include "results/fields/static_tables.h"
#include "results/fields/static_values.h"
#include "runstore/run_record.h"

namespace overbend {
namespace {

void write_region(Hdf5Writer& file, const std::string& group, const std::string& description,
                  const RegionResult& region) {
  file.group(group, description);
  visit_region(region, [&](const ResultField& field, const Extreme& extreme) {
    ValueWriter visit{file, group + "/" + field.name};
    file.group(visit.group, std::string(field.description));
    visit_extreme_fields(field, extreme, visit);
  });
}

void write_supports(Hdf5Writer& file, const std::string& group, const StaticResults& results) {
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

void write_tables(Hdf5Writer& file, const std::string& group, const StaticResults& results) {
  TableWriter stations, sections;
  for (const Station& station : results.stations) {
    visit_station(station, stations);
    stations.end_row();
  }
  for (const DerivedSection& section : results.sections) {
    sections(index_field("Number of the section, from 0: first the line's own"), sections.rows());
    visit_section(section, sections);
    sections.end_row();
  }
  stations.write(file, group + "/stations", "Stations of the pipe from the anchor to the tensioner");
  sections.write(file, group + "/sections", "Properties of the sections");
}

template <class Function, class Part>
void write_part(Hdf5Writer& file, const std::string& group, const std::string& description, Function visit_part,
                const Part& part) {
  file.group(group, description);
  ValueWriter visit{file, group};
  visit_part(part, visit);
}

}  // namespace

void write_model_group(Hdf5Writer& file, const Description& description) {
  file.group("/model", "Model and program version");
  ValueWriter visit{file, "/model"};
  write_model_text(file, description.source_text);
  visit(ResultField{"file", "1", "Path of the model file as given"}, description.source_file);
  visit(ResultField{"version", "1", "Version of the program"}, std::string(OVERBEND_VERSION));
  visit(ResultField{"machine", "1", "Operating system, its release and the architecture"}, machine_name());
  visit(ResultField{"compiler", "1", "Compiler of the program"}, compiler_name());
}

void write_model_text(Hdf5Writer& file, const std::string& text) {
  ValueWriter visit{file, "/model"};
  visit(ResultField{"text", "1", "Text of the model file"}, text);
  visit(ResultField{"hash", "1", "FNV-1a (64 bit) of the text"}, text_hash(text));
}

void write_static_groups(Hdf5Writer& file, const StaticResults& results, const Description& description) {
  file.attribute("/", "Conventions", "overbend-results-1; SI units; attributes units, frame, description");
  file.attribute("/", "title", results.title);
  file.attribute("/", "source", "overbend " OVERBEND_VERSION);
  write_model_group(file, description);
  const auto keys = [](const auto& part, auto& visit) { visit_key_results(part, visit); };
  const auto touchdown = [](const auto& part, auto& visit) { visit_touchdown(part, visit); };
  const auto sums = [](const auto& part, auto& visit) { visit_sums(part, visit); };
  const auto solve = [](const auto& part, auto& visit) { visit_solve(part, visit); };
  const auto scene = [](const auto& part, auto& visit) { visit_scene(part, visit); };
  write_part(file, "/static", "Static equilibrium: key results", keys, results);
  write_part(file, "/static/touchdown", "Touchdown", touchdown, results.touchdown);
  write_part(file, "/static/sums", "Sums of forces on the line", sums, results);
  write_part(file, "/static/solve", "Solver statistics", solve, results.solve);
  write_part(file, "/static/scene", "Geometry for figures", scene, results);
  if (results.overbend) {
    write_region(file, "/static/overbend", "Extremes from the tensioner to the inflection below the last support",
                 *results.overbend);
  }
  const ResultField least = smallest_tension_field();
  const auto smallest = [&](const auto& part, auto& visit) { visit_extreme_fields(least, part, visit); };
  write_part(file, "/static/" + least.name, std::string(least.description), smallest, results.smallest_tension);
  if (results.tower) {
    write_region(file, "/static/tower", "Extremes where the clamped guide bends the pipe", *results.tower);
  }
  write_region(file, "/static/sagbend", "Extremes from there to touchdown", results.sagbend);
  write_tables(file, "/static", results);
  write_supports(file, "/static", results);
  write_checks(file, "/static/checks", results.checks);
  if (results.moorings) write_moorings(file, *results.moorings);
  if (results.hull) write_hull(file, *results.hull);
}

void write_static_hdf5(const StaticResults& results, const Description& description,
                       const std::filesystem::path& path) {
  Hdf5Writer file(path);
  write_static_groups(file, results, description);
  file.close();
}

}  // namespace overbend
