#include "report/stages/stage_columns.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "report/stages/hold_points.h"

namespace overbend {
namespace {

std::vector<StageColumn> told(const std::vector<StageColumn>& columns, const std::vector<std::size_t>& stages) {
  std::vector<StageColumn> kept;
  for (const StageColumn& column : columns) {
    const auto says = [&](std::size_t stage) { return !column.text(stage).empty(); };
    if (std::any_of(stages.begin(), stages.end(), says)) kept.push_back(column);
  }
  return kept;
}

std::vector<std::pair<std::string, int>> groups_of(const std::vector<StageColumn>& columns) {
  std::vector<std::pair<std::string, int>> groups;
  for (const StageColumn& column : columns) {
    if (groups.empty() || groups.back().first != column.group) groups.emplace_back(column.group, 0);
    ++groups.back().second;
  }
  return groups;
}

}  // namespace

std::string stage_rows_table(const std::string& caption, const std::vector<StageColumn>& columns,
                             const std::vector<std::size_t>& stages, const std::string& css_class,
                             const std::function<std::string(std::size_t stage)>& css_of) {
  const std::vector<StageColumn> shown = told(columns, stages);
  std::vector<html::Head> head;
  for (const StageColumn& column : shown) head.push_back(column.head);
  html::Table table(caption, head, css_class);
  table.groups(groups_of(shown));
  for (const std::size_t stage : stages) {
    std::vector<std::string> cells;
    for (const StageColumn& column : shown) {
      const std::string text = column.text(stage);
      cells.push_back(text.empty() && !column.head.text ? "-" : text);
    }
    table.row(cells, css_of(stage));
  }
  return table.str();
}

std::function<std::string(std::size_t)> of_lay(const OperationResults& results, LayText text) {
  return [&results, text = std::move(text)](std::size_t stage) {
    const std::optional<StaticResults>& lay = results.stages[stage].lay;
    return lay ? text(*lay) : std::string();
  };
}

std::vector<std::size_t> all_stages(const OperationResults& results) {
  std::vector<std::size_t> all(results.stages.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::string stage_css(const StageResult& stage) {
  const std::optional<StageUse> use = largest_use(stage);
  return !stage.lay || (use && use->utilisation > 1.0) ? "over" : "";
}

}  // namespace overbend
