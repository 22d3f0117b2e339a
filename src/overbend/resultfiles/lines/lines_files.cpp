#include "resultfiles/lines/lines_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/ranges.h"
#include "resultfiles/hdf5/dataset_path.h"
#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/summary/json_fields.h"
#include "resultfiles/summary/summary_fields.h"
#include "resultfiles/summary/summary_json.h"
#include "resultfiles/tables/csv_fields.h"
#include "resultfiles/tables/finite_visitor.h"
#include "results/fields/line_values.h"

namespace overbend {
namespace {

std::string line_group(const std::string& front, std::size_t line) {
  return front + "/" + std::to_string(line);
}

/// Calls `each` for both ends with their names in files.
template <class Line, class Each>
void for_ends(Line& line, Each each) {
  each("first", line.first);
  each("second", line.second);
}

/// Calls `each` for the stored values of every node.
template <class Line, class Each>
void for_nodes_in_time(Line& line, Each each) {
  each(ResultField{"least_at_nodes", "N", "Minimum tension over time, at the nodes"}, line.min_tension_at_nodes);
  each(ResultField{"largest_at_nodes", "N", "Largest tension over time, at the nodes"}, line.max_tension_at_nodes);
  each(ResultField{"moment_at_nodes", "N m", "Largest bending moment over time, at the nodes"}, line.moment_at_nodes);
}

ResultField name_field() {
  return ResultField{"name", "1", "Name of the line"}.csv("line");
}

std::vector<std::string> lines_head() {
  CsvHead head;
  head(name_field(), std::string());
  const LineNodeResult example;
  visit_line_node(example, head);
  visit_line_node_in_time(0.0, 0.0, head);
  return head.names;
}

/// `min_tension`, `max_tension`: tension at the node over time [N].
void add_node(const LineResult& line, std::size_t node, double min_tension, double max_tension, CsvTable& table) {
  CsvCells cells{table};
  cells(name_field(), line.name);
  visit_line_node(line.nodes[node], cells);
  visit_line_node_in_time(min_tension, max_tension, cells);
  table.end_row();
}

}  // namespace

void write_lines(DatasetSink& file, const std::vector<LineResult>& lines, const std::string& front) {
  if (lines.empty()) return;
  file.group(front, "Lines between two ends, by their number in the model, from 0");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const LineResult& line = lines[i];
    const std::string group = line_group(front, i);
    file.group(group, "Line " + line.name);
    ValueWriter values{file, group};
    visit_line(line, values);
    for_ends(line, [&](const std::string& name, const LineEndResult& end) {
      const std::string below = fmt::format("{}/{}", group, name);
      file.group(below, "End of the line");
      ValueWriter of_end{file, below};
      visit_line_end(end, of_end);
    });
    TableWriter nodes;
    for (const LineNodeResult& node : line.nodes) {
      visit_line_node(node, nodes);
      nodes.end_row();
    }
    nodes.write(file, group + "/nodes", "Nodes from the first end");
  }
}

std::vector<LineResult> read_lines(const Hdf5Reader& file, const std::string& front) {
  std::vector<LineResult> lines;
  for (std::size_t i = 0; file.has(line_group(front, i)); ++i) {
    const std::string group = line_group(front, i);
    LineResult& line = lines.emplace_back();
    ValueReader values{file, group};
    visit_line(line, values);
    for_ends(line, [&](const std::string& name, LineEndResult& end) {
      ValueReader of_end{file, fmt::format("{}/{}", group, name)};
      visit_line_end(end, of_end);
    });
    TableReader nodes(file, group + "/nodes");
    line.nodes.resize(nodes.rows("s"));
    for (std::size_t node = 0; node < line.nodes.size(); ++node) {
      nodes.start_row(node);
      visit_line_node(line.nodes[node], nodes);
    }
  }
  return lines;
}

void write_lines_in_time(DatasetSink& file, const std::vector<LineDynamics>& lines) {
  if (lines.empty()) return;
  file.group("/dynamic/lines", "Lines over time, by their number in the model, from 0");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string group = line_group("/dynamic/lines", i);
    file.group(group, "Line " + lines[i].name);
    ValueWriter values{file, group};
    visit_line_in_time(lines[i], values);
    for_nodes_in_time(lines[i], [&](const ResultField& field, const std::vector<double>& tensions) {
      if (!tensions.empty()) file.write(group + "/" + field.name, field, tensions, {tensions.size()});
    });
  }
}

std::vector<LineDynamics> read_lines_in_time(const Hdf5Reader& file) {
  std::vector<LineDynamics> lines;
  for (std::size_t i = 0; file.has(line_group("/dynamic/lines", i)); ++i) {
    const std::string group = line_group("/dynamic/lines", i);
    ValueReader values{file, group};
    visit_line_in_time(lines.emplace_back(), values);
    for_nodes_in_time(lines.back(), [&](const ResultField& field, std::vector<double>& tensions) {
      const std::string path = group + "/" + field.name;
      if (file.has(path)) tensions = file.doubles(path);
    });
  }
  return lines;
}

void link_line_histories(Hdf5Writer& file, const std::vector<LineDynamics>& lines) {
  if (lines.empty()) return;
  file.link("/lines/time", "/dynamic/histories/time");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const char* end : {"first_tension", "second_tension"}) {
      file.link(line_group("/lines", i) + "/" + end,
                "/dynamic/histories/" + dataset_path("line/" + lines[i].name + "/" + end));
    }
  }
}

void add_lines(const StaticResults& results, Json& summary) {
  if (results.lines.empty()) return;
  const SummaryStyle style;
  summary["static"]["lines"] = style.rows(results.lines, [&](const LineResult& line) {
    JsonWriter json(style);
    visit_line(line, json);
    for_ends(line, [&](const char* name, const LineEndResult& end) {
      json[name] = make_object(style, [&](auto& visitor) { visit_line_end(end, visitor); });
    });
    return json.take();
  });
}

void add_lines_in_time(const DynamicResults& results, Json& summary) {
  if (results.lines.empty()) return;
  const SummaryStyle style;
  summary["dynamic"]["lines"] = style.rows(results.lines, [&](const LineDynamics& line) {
    return make_object(style, [&](auto& visitor) {
      visit_line_in_time(line, visitor);
      if (line.moment_at_nodes.empty()) return;
      visitor(ResultField{"largest_bending_moment", "N m", "Largest bending moment along the line over time"}.summary(),
              *ranges::max_element(line.moment_at_nodes));
    });
  });
}

std::string lines_table(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time) {
  CsvTable table(lines_head());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t node = 0; node < lines[i].nodes.size(); ++node) {
      const double rest = lines[i].nodes[node].tension;
      add_node(lines[i], node, in_time.empty() ? rest : in_time[i].min_tension_at_nodes[node],
               in_time.empty() ? rest : in_time[i].max_tension_at_nodes[node], table);
    }
  }
  return table.text();
}

std::string lines_table(const std::vector<StageLines>& stages) {
  std::vector<std::string> head = lines_head();
  head.insert(head.begin(), "stage");
  CsvTable table(head);
  for (const StageLines& stage : stages) {
    for (const LineResult& line : stage.lines) {
      for (std::size_t node = 0; node < line.nodes.size(); ++node) {
        table.cell(stage.stage);
        add_node(line, node, line.nodes[node].tension, line.nodes[node].tension, table);
      }
    }
  }
  return table.text();
}

void require_finite(const std::vector<LineResult>& lines) {
  for (const LineResult& line : lines) {
    FiniteVisitor visit{"lines." + line.name + "."};
    visit_line(line, visit);
    for_ends(line, [&](const char*, const LineEndResult& end) { visit_line_end(end, visit); });
    for (const LineNodeResult& node : line.nodes) visit_line_node(node, visit);
  }
}

void require_finite(const std::vector<LineDynamics>& lines) {
  for (const LineDynamics& line : lines) {
    FiniteVisitor visit{"dynamic.lines." + line.name + "."};
    visit_line_in_time(line, visit);
  }
}

}  // namespace overbend
