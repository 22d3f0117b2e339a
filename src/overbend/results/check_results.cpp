#include "results/check_results.h"

#include <algorithm>

#include "base/ranges.h"

namespace overbend {

CheckRow::CheckRow() = default;
CheckRow::CheckRow(const CheckRow&) = default;
CheckRow::CheckRow(CheckRow&&) noexcept = default;
CheckRow& CheckRow::operator=(const CheckRow&) = default;
CheckRow& CheckRow::operator=(CheckRow&&) noexcept = default;
CheckRow::~CheckRow() = default;

Findings find_invalid_checks(const CheckTable& table) {
  Findings all;
  for (const CheckRow& row : table.rows) {
    if (!row.governing || row.status != CheckStatus::outside_validity) continue;
    const std::string where = row.line.empty() ? "" : ", line \"" + row.line + "\"";
    Finding finding = Finding{FindingCode::check_not_judged,
                              "not judged: " + row.name + where + ", " + row.code + " (" + row.remark + ")"}
                          .on(row.name + where);
    if (ranges::find(all, finding) == all.end()) all.push_back(std::move(finding));
  }
  return all;
}

}  // namespace overbend
