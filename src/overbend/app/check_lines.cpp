#include "app/check_lines.h"

#include <fmt/format.h>

#include <iostream>

#include "io/result_field.h"

namespace overbend {
namespace {

/// The governing row of a region that is used most; null without one.
const CheckRow* worst_of(const CheckTable& table, CheckRegion region) {
  const CheckRow* worst = nullptr;
  for (const CheckRow& row : table.rows) {
    if (row.region != region || !row.governing || !row.judged()) continue;
    if (worst == nullptr || row.utilisation > worst->utilisation) worst = &row;
  }
  return worst;
}

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
  for (const CheckRegion region : {CheckRegion::tower, CheckRegion::overbend, CheckRegion::tip, CheckRegion::sagbend,
                                   CheckRegion::seabed, CheckRegion::line}) {
    const CheckRow* row = worst_of(table, region);
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
