#include "report/static/criteria_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/ranges.h"

namespace overbend {
namespace {

/// One row for each check, independent of its regions.
std::vector<CheckRow> distinct_checks(const CheckTable& checks) {
  std::vector<CheckRow> distinct;
  for (const CheckRow& row : checks.rows) {
    const bool known = ranges::any_of(
        distinct, [&](const CheckRow& other_row) { return other_row.id == row.id && other_row.name == row.name; });
    if (!known) distinct.push_back(row);
  }
  ranges::stable_sort(distinct, [](const CheckRow& a, const CheckRow& b) { return a.governing && !b.governing; });
  return distinct;
}

std::string rule_on_findings(const std::optional<Description>& description) {
  std::string text = "Accepted if the utilisation of every governing criterion is at most 1 and no finding is serious.";
  if (description && !description->checks.accepted_findings.empty()) {
    text += fmt::format(" Serious findings accepted by the project: {}.",
                        fmt::join(description->checks.accepted_findings, ", "));
  }
  return text;
}

}  // namespace

Blocks criteria_section(const CheckTable& checks, const std::optional<Description>& description) {
  if (checks.rows.empty()) return {};
  Table table{"", {TableColumn("Criterion"), TableColumn("Code or source"), TableColumn("Clause"), TableColumn("Use")}};
  for (const CheckRow& row : distinct_checks(checks)) {
    table.row({row.name, row.code, row.clause.empty() ? "-" : row.clause, row.governing ? "decides" : "information"},
              row.governing ? RowMark::none : RowMark::soft);
  }
  return block::section("criteria", "Acceptance criteria", block::paragraph(rule_on_findings(description)) + table);
}

}  // namespace overbend
