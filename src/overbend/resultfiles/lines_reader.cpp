#include "resultfiles/lines_reader.h"

#include "resultfiles/hdf5_readers.h"
#include "results/fields/line_values.h"

namespace overbend {
namespace {

LineResult read_line(const Hdf5Reader& file, const std::string& group) {
  LineResult line;
  ValueReader values{file, group};
  visit_line(line, values);
  for (const auto& [name, end] : {std::pair{"first", &line.first}, {"second", &line.second}}) {
    ValueReader of_end{file, group + "/" + name};
    visit_line_end(*end, of_end);
  }
  TableReader nodes(file, group + "/nodes");
  line.nodes.resize(nodes.rows("s"));
  for (std::size_t i = 0; i < line.nodes.size(); ++i) {
    nodes.start_row(i);
    visit_line_node(line.nodes[i], nodes);
  }
  return line;
}

}  // namespace

StoredLines read_lines_results(const std::filesystem::path& h5) {
  const Hdf5Reader file(h5);
  StoredLines stored;
  ValueReader visit{file, "/model"};
  visit(ResultField{"text"}, stored.model_text);
  for (std::string group = "/lines/0"; file.has(group);
       group = "/lines/" + std::to_string(stored.results.lines.size())) {
    stored.results.lines.push_back(read_line(file, group));
  }
  if (stored.results.lines.empty()) throw std::runtime_error("the file '" + h5.string() + "' holds no lines");
  return stored;
}

}  // namespace overbend
