#include "resultfiles/lines/lines_reader.h"

#include "resultfiles/hdf5/check_hdf5.h"
#include "resultfiles/hdf5/hdf5_readers.h"
#include "results/fields/line_values.h"
#include "results/fields/static_values.h"

namespace overbend {
namespace {

LineResult read_line(const Hdf5Reader& file, const std::string& group, bool moved) {
  LineResult line;
  ValueReader values{file, group};
  visit_line(line, values);
  ValueReader first{file, group + "/first"}, second{file, group + "/second"};
  visit_line_end(line.first, first);
  visit_line_end(line.second, second);
  TableReader nodes(file, group + "/nodes");
  line.nodes.resize(nodes.rows("s"));
  for (std::size_t i = 0; i < line.nodes.size(); ++i) {
    nodes.start_row(i);
    visit_line_node(line.nodes[i], nodes);
  }
  if (!moved) return line;
  ValueReader in_time{file, group + "/in_time"};
  visit_line_in_time(line, in_time);
  line.first_history = file.doubles(group + "/first_tension");
  line.second_history = file.doubles(group + "/second_tension");
  return line;
}

}  // namespace

bool has_lines(const std::filesystem::path& h5) {
  return Hdf5Reader(h5).has("/lines");
}

StoredLines read_lines_results(const std::filesystem::path& h5) {
  const Hdf5Reader file(h5);
  if (!file.has("/lines")) throw std::runtime_error("the file '" + h5.string() + "' holds no lines");
  StoredLines stored;
  ValueReader visit{file, "/model"};
  visit(ResultField{"text"}, stored.model_text);
  visit(ResultField{"file"}, stored.model_file);
  LinesResults& results = stored.results;
  visit.group = "/lines";
  visit_heading(results, visit);
  results.checks = read_checks(file, "/lines/checks");
  results.moved = file.has("/lines/time");
  if (results.moved) {
    visit_lines_run(results, visit);
    results.time = file.doubles("/lines/time");
  }
  for (std::size_t i = 0; file.has("/lines/" + std::to_string(i)); ++i) {
    results.lines.push_back(read_line(file, "/lines/" + std::to_string(i), results.moved));
  }
  return stored;
}

}  // namespace overbend
