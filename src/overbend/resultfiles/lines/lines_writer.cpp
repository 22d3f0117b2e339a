#include "resultfiles/lines/lines_writer.h"

#include "resultfiles/hdf5/check_hdf5.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/studies/seeds_writer.h"
#include "resultfiles/summary/json_fields.h"
#include "resultfiles/summary/summary_fields.h"
#include "resultfiles/summary/summary_json.h"
#include "resultfiles/tables/csv_fields.h"
#include "results/fields/line_values.h"
#include "results/fields/static_values.h"
#include "results/verdict.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

Json line_json(const SummaryStyle& style, const LineResult& line) {
  JsonWriter json(style);
  visit_line(line, json);
  json["first"] = object_of(style, [&](auto& end) { visit_line_end(line.first, end); });
  json["second"] = object_of(style, [&](auto& end) { visit_line_end(line.second, end); });
  return json.take();
}

}  // namespace

void write_lines_groups(DatasetSink& file, const LinesResults& results) {
  file.group("/lines", "Lines between two ends, by their number in the model, from 0");
  ValueWriter heading{file, "/lines"};
  visit_heading(results, heading);
  if (results.moved) {
    visit_lines_run(results, heading);
    file.write("/lines/time", ResultField{"time", "s", "Time of the histories"}, results.time, {results.time.size()});
  }
  for (std::size_t i = 0; i < results.lines.size(); ++i) {
    const LineResult& line = results.lines[i];
    const std::string group = "/lines/" + std::to_string(i);
    file.group(group, "Line " + line.name);
    ValueWriter values{file, group};
    visit_line(line, values);
    for (const auto& [name, end] : {std::pair{"first", &line.first}, {"second", &line.second}}) {
      file.group(group + "/" + name, "End of the line");
      ValueWriter of_end{file, group + "/" + name};
      visit_line_end(*end, of_end);
    }
    TableWriter nodes;
    for (const LineNodeResult& node : line.nodes) {
      visit_line_node(node, nodes);
      nodes.end_row();
    }
    nodes.write(file, group + "/nodes", "Nodes from the first end");
    if (!results.moved) continue;
    file.group(group + "/in_time", "Tensions over time, all steps");
    ValueWriter in_time{file, group + "/in_time"};
    visit_line_in_time(line, in_time);
    for (const auto& [name, values_of] :
         {std::pair{"first_tension", &line.first_history}, {"second_tension", &line.second_history}}) {
      file.write(group + "/" + name, ResultField{name, "N", "Tension at the end over time"}, *values_of,
                 {values_of->size()});
      file.attach_scale(group + "/" + name, "/lines/time");
    }
  }
}

namespace {

void write_lines_hdf5(const LinesResults& results, const Description& description, const std::filesystem::path& path) {
  Hdf5Writer file(path);
  write_results_heading(file, results.title, description);
  write_lines_groups(file, results);
  write_checks(file, "/lines/checks", results.checks);
  file.close();
}

/// All but what is over time.
JsonWriter<SummaryStyle> rest_json(const LinesResults& results) {
  const SummaryStyle style;
  JsonWriter json(style);
  json["status"] = "converged";
  visit_heading(results, json);
  json["units"] = "SI: m, N, Pa, rad, s; angles from horizontal";
  json["frame"] = kWorldFrame;
  json["verdict"] = verdict_json(make_verdict(results.checks, results.findings));
  json["checks"] = summary_checks(style, results.checks);
  json["static"] =
      Json{{"lines", style.rows(results.lines, [&](const LineResult& line) { return line_json(style, line); })}};
  return json;
}

}  // namespace

std::string lines_summary(const LinesResults& results) {
  const SummaryStyle style;
  JsonWriter json = rest_json(results);
  if (results.moved) {
    json["dynamic"] =
        Json{{"lines", style.rows(results.lines,
                                  [&](const LineResult& line) {
                                    return object_of(style, [&](auto& one) { visit_line_in_time(line, one); });
                                  })},
             {"energy_drift", results.energy_drift},
             {"steps", results.steps}};
  }
  return summary_text(json.take());
}

std::string lines_table(const LinesResults& results) {
  const ResultField name{"name", "1", "Name of the line"};
  CsvHead head;
  head(ResultField(name).csv("line"), std::string());
  const LineNodeResult example;
  visit_line_node(example, head);
  CsvTable table(head.names);
  for (const LineResult& line : results.lines) {
    for (const LineNodeResult& node : line.nodes) {
      CsvCells cells{table};
      cells(ResultField(name).csv("line"), line.name);
      visit_line_node(node, cells);
      table.end_row();
    }
  }
  return table.text();
}

void write_lines_seeds(const LinesResults& one, const SeedsResults& seeds, const std::filesystem::path& folder) {
  require_finite(seeds);
  JsonWriter json = rest_json(one);
  json["seeds"] = seeds_json(seeds);
  write_text(folder / "seeds.csv", seeds_table(seeds));
  write_text(folder / "summary.json", summary_text(json.take()));
}

void write_lines_files(const LinesResults& results, const Description& description,
                       const std::filesystem::path& folder) {
  write_lines_hdf5(results, description, folder / "results.h5");
  write_text(folder / "lines.csv", lines_table(results));
  write_text(folder / "summary.json", lines_summary(results));
}

}  // namespace overbend
