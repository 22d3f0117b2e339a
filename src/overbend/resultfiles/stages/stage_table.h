/// The table of the stages of an operation: a row per stage, engineering units.
#pragma once

#include <string>
#include <vector>

#include "results/operation_results.h"
#include "results/tables/table.h"

namespace overbend {

/// One column. A number that does not apply is NaN, a text that does not apply is empty.
struct StageTableColumn {
  std::string heading;
  std::string unit;   ///< Empty for texts and plain numbers.
  int digits = 3;     ///< Number of decimals shown.
  bool text = false;  ///< True if `texts` holds the cells, false for numbers.
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

/// Returns all columns with at least one value, each with a cell per stage.
std::vector<StageTableColumn> stage_table_columns(const OperationResults& results);

/// Returns the table of stages.csv and stages.xlsx.
Table stages_table(const OperationResults& results);

}  // namespace overbend
