#include "report/stages/stage_columns.h"

#include <numeric>
#include <utility>

#include "report/stages/hold_points.h"

namespace overbend {
namespace {

/// `over` if a stage has no equilibrium or exceeds a check or its cable's capacity.
RowMark stage_mark(const StageResult& stage) {
  const std::optional<StageUtilisation> use = find_max_utilisation(stage);
  return !stage.lay || (use && use->utilisation > 1.0) ? RowMark::over : RowMark::none;
}

}  // namespace

StageTable::StageTable(const OperationResults& results, const std::vector<std::size_t>& stages)
    : results_(results), stages_(stages), table_{"", {}} {
  table_.rows.resize(stages.size());
}

void StageTable::add(const std::string& group, TableColumn column, const StageCell& cell) {
  column.group = group;
  table_.column(std::move(column));
  for (std::size_t i = 0; i < stages_.size(); ++i) table_.rows[i].cells.push_back(cell(stages_[i]));
}

void StageTable::add(const std::string& group, TableColumn column, const LayCell& cell) {
  add(group, std::move(column), [&](std::size_t stage) {
    const std::optional<StaticResults>& lay = results_.stages[stage].lay;
    return lay ? cell(*lay) : TableCell();
  });
}

Table StageTable::table(const std::string& title, const std::string& look, bool marked) const {
  Table table = table_;
  table.title = title;
  table.look = look;
  table.drop_empty_columns();
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    TableRow& row = table.rows[i];
    if (marked) row.mark = stage_mark(results_.stages[stages_[i]]);
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
      if (!table.columns[k].is_text && std::holds_alternative<std::monostate>(row.cells[k])) row.cells[k] = "-";
    }
  }
  return table;
}

std::vector<std::size_t> all_stages(const OperationResults& results) {
  std::vector<std::size_t> all(results.stages.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace overbend
