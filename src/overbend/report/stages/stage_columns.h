/// Tables with a row per stage of an operation: columns without a value at any stage are omitted.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "results/operation_results.h"
#include "results/tables/table.h"

namespace overbend {

/// Fractions in percent.
inline constexpr ShownUnit kPercent{"1", "%", 100.0, 1};

/// Columns are added from the left; each computes its cells of all rows.
class StageTable {
 public:
  using StageCell = std::function<TableCell(std::size_t stage)>;
  using LayCell = std::function<TableCell(const StaticResults& lay)>;

  /// `stages` are the numbers of the rows, from 0.
  StageTable(const OperationResults& results, const std::vector<std::size_t>& stages);

  /// `group` is the common heading of neighbouring columns; empty: none.
  void add(const std::string& group, TableColumn column, const StageCell& cell);
  /// Adds a column from the equilibrium of the stage; empty cells without one.
  void add(const std::string& group, TableColumn column, const LayCell& cell);

  /// Returns the table. Empty cells of numbers become dashes. `marked`: rows of failed and exceeded stages are marked.
  Table table(const std::string& title, const std::string& look, bool marked = true) const;

 private:
  const OperationResults& results_;
  std::vector<std::size_t> stages_;
  Table table_;
};

/// Returns the numbers of all stages.
std::vector<std::size_t> all_stages(const OperationResults& results);

}  // namespace overbend
