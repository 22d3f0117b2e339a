#include "app/check_lines.h"

#include <fmt/format.h>

#include <iostream>

#include "report/verdict.h"
#include "results/fields/result_field.h"

namespace overbend {
namespace {

std::string place_of(const CheckRow& row) {
  std::string text = fmt::format("{:.1f} m from the tensioner", row.from_top);
  if (row.in_time) text += fmt::format(", t = {:.1f} s", row.time);
  return text;
}

std::string title_of(const CheckRow& row) {
  return row.name + ", " + row.code;
}

}  // namespace

std::string check_lines(const CheckTable& table) {
  std::string text;
  for (const CheckRegion region : check_regions()) {
    const CheckRow* row = governing_check(table, region);
    if (row == nullptr) continue;
    const std::string name = region == CheckRegion::line ? "check, whole line" : fmt::format("check, {}", word(region));
    text += fmt::format("  {:<28}{:>12.3f} {}, {}{}\n", name, row->utilisation, title_of(*row), place_of(*row),
                        row->status == CheckStatus::exceeded ? "  EXCEEDED" : "");
  }
  for (const CheckRow& row : table.rows) {
    if (row.status != CheckStatus::outside_validity || !row.governing) continue;
    text += fmt::format("  {:<28}{:>12} {}, {}: {}\n", fmt::format("check, {}", word(row.region)), "not valid",
                        title_of(row), row.remark, "neither passed nor failed");
  }
  return text;
}

ExitCode strict_code(const CheckTable& table, bool strict) {
  const CheckRow* worst = worst_check(table);
  if (!strict || worst == nullptr || worst->status != CheckStatus::exceeded) return kDone;
  std::cerr << fmt::format("overbend: a check is exceeded: {} in {}: utilisation {:.3f} at {}\n", title_of(*worst),
                           worst->region == CheckRegion::line ? "the line" : word(worst->region), worst->utilisation,
                           place_of(*worst));
  return kCheckExceeded;
}

}  // namespace overbend
