/// The table of the stages of an operation: a row per stage, engineering units.
#pragma once

#include <string>
#include <vector>

#include "results/operation_results.h"
#include "results/tables/table.h"

namespace overbend {

/// One column. A number that does not apply is not a number, a text that does not is empty.
struct StageTableColumn {
  std::string heading;
  std::string unit;   ///< Empty for texts and plain numbers.
  int digits = 3;     ///< Decimals to show.
  bool text = false;  ///< Which of the two lists holds its cells.
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

/// All columns that hold anything, each with a cell per stage.
std::vector<StageTableColumn> stage_table_columns(const OperationResults& results);

/// The table of stages.csv and stages.xlsx.
Table stages_table(const OperationResults& results);

}  // namespace overbend
