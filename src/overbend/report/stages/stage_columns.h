/// Tables with a row per stage of an operation: columns that say nothing at any stage are left out.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/page/html.h"
#include "results/operation_results.h"

namespace overbend {

struct StageColumn {
  std::string group;  ///< Title above neighbouring columns of the same group; empty: none. Plain text.
  html::Head head;
  /// Of a stage by its number from 0; empty where it says nothing.
  std::function<std::string(std::size_t stage)> text;
};

/// `stages` are the numbers of the rows, `css_of` marks them.
std::string stage_rows_table(const std::string& caption, const std::vector<StageColumn>& columns,
                             const std::vector<std::size_t>& stages, const std::string& css_class,
                             const std::function<std::string(std::size_t stage)>& css_of);

/// A value of the equilibrium of a stage; empty where it has none.
using LayText = std::function<std::string(const StaticResults& lay)>;
std::function<std::string(std::size_t)> of_lay(const OperationResults& results, LayText text);

/// The numbers of all stages.
std::vector<std::size_t> all_stages(const OperationResults& results);

/// "over" where a stage has no equilibrium or its checks or its cable are exceeded.
std::string stage_css(const StageResult& stage);

}  // namespace overbend
