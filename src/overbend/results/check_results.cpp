#include "results/check_results.h"

#include <algorithm>

namespace overbend {

const char* const kNotJudged = "not judged: ";

CheckRow::CheckRow() = default;
CheckRow::CheckRow(const CheckRow&) = default;
CheckRow::CheckRow(CheckRow&&) noexcept = default;
CheckRow& CheckRow::operator=(const CheckRow&) = default;
CheckRow& CheckRow::operator=(CheckRow&&) noexcept = default;
CheckRow::~CheckRow() = default;

std::vector<std::string> unjudged_checks(const CheckTable& table) {
  std::vector<std::string> all;
  for (const CheckRow& row : table.rows) {
    if (!row.governing || row.status != CheckStatus::outside_validity) continue;
    std::string words = kNotJudged + row.name + ", " + row.code + " (" + row.remark + ")";
    if (std::find(all.begin(), all.end(), words) == all.end()) all.push_back(std::move(words));
  }
  return all;
}

}  // namespace overbend
