#include "app/print_checks.h"

#include <fmt/format.h>

#include <iostream>

#include "base/shown_unit.h"
#include "results/fields/result_field.h"
#include "results/verdict.h"

namespace overbend {
namespace {

std::string make_check_place(const CheckRow& row) {
  std::string text = check_place(row);
  if (row.in_time && is_on_pipe(row)) text += fmt::format(", t = {:.1f} s", row.time);
  return text;
}

std::string make_check_title(const CheckRow& row) {
  return row.name + ", " + row.code;
}

}  // namespace

std::string check_lines(const CheckTable& table) {
  std::string text;
  for (const CheckRegion region : check_regions()) {
    const CheckRow* row = governing_check(table, region);
    if (row == nullptr) continue;
    const std::string name = region == CheckRegion::line ? "check, whole line" : fmt::format("check, {}", word(region));
    text += fmt::format("  {:<28}{:>12.3f} {}, {}{}\n", name, row->utilisation, make_check_title(*row),
                        make_check_place(*row), row->status == CheckStatus::exceeded ? "  EXCEEDED" : "");
  }
  for (const CheckRow& row : table.rows) {
    if (row.status != CheckStatus::outside_validity || !row.governing) continue;
    text += fmt::format("  {:<28}{:>12} {}, {}: {}\n", fmt::format("check, {}", word(row.region)), "not valid",
                        make_check_title(row) + (row.line.empty() ? "" : ", line \"" + row.line + "\""), row.remark,
                        "neither passed nor failed");
  }
  return text;
}

std::string verdict_line(const Verdict& verdict) {
  return fmt::format("  {:<28}{}\n", "verdict", verdict.headline);
}

ExitCode strict_code(const CheckTable& table, const Findings& findings, bool strict) {
  const VerdictKind kind = verdict_kind(table, findings);
  if (!strict || kind == VerdictKind::passed) return kDone;
  const std::string reserved = serious_findings_text(findings);
  if (kind != VerdictKind::exceeded) {
    if (reserved.empty()) return kDone;
    std::cerr << "overbend: the checks are passed with reservations: " << reserved << "\n";
    return kCheckExceeded;
  }
  const CheckRow* worst = find_governing_check(table);
  std::cerr << fmt::format("overbend: a check is exceeded: {} in {}: utilisation {:.3f} at {}\n",
                           make_check_title(*worst),
                           worst->region == CheckRegion::line ? "the line" : word(worst->region), worst->utilisation,
                           make_check_place(*worst));
  return kCheckExceeded;
}

}  // namespace overbend
