#include "results/verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "results/result_enum_names.h"

namespace overbend {
namespace {

std::string lower_first(std::string text) {
  const bool acronym = text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1])) != 0;
  if (!text.empty() && !acronym) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

std::ptrdiff_t count_checks(const CheckTable& table, CheckStatus status) {
  return std::count_if(table.rows.begin(), table.rows.end(),
                       [&](const CheckRow& row) { return row.governing && row.status == status; });
}

/// Formats with two decimals, or more if they would round an exceeded check to 1.
std::string factor(double utilisation) {
  return utilisation > 1.0 && utilisation < 1.005 ? fixed(utilisation, 4) : fixed(utilisation, 2);
}

std::string reasons(const CheckTable& table) {
  const CheckRow* worst = find_governing_check(table);
  if (worst == nullptr) return "No check could be judged.";
  const std::ptrdiff_t exceeded = count_checks(table, CheckStatus::exceeded);
  const std::ptrdiff_t invalid = count_checks(table, CheckStatus::outside_validity);
  std::string text = exceeded == 0
                         ? "No governing check is exceeded."
                         : fmt::format("{} governing check{} exceeded.", exceeded, exceeded == 1 ? " is" : "s are");
  text += fmt::format(" The largest utilisation is {}: {}, {}{}.", fixed(worst->utilisation, 3), check_label(*worst),
                      check_place(*worst), worst->in_time ? ", t = " + fixed(worst->time, 1) + " s" : "");
  if (invalid > 0) {
    text += fmt::format(" {} outside the validity of {}: neither passed nor failed.", invalid,
                        invalid == 1 ? "its formula" : "their formulas");
  }
  return text;
}

}  // namespace

bool is_on_pipe(const CheckRow& row) {
  return row.line.empty() && !row.id.starts_with("mooring_") && row.id != "anchor_load" && row.id != "line_load";
}

std::string check_place(const CheckRow& row) {
  if (is_on_pipe(row)) return shown(row.from_top, "m", 1) + " from the tensioner";
  if (row.line.empty() || row.id == "line_load") return row.remark;
  return fmt::format("line \"{}\", {} from its first end", row.line, shown(row.s, "m", 1));
}

VerdictKind verdict_kind(const CheckTable& table, const Findings& findings) {
  const CheckRow* worst = find_governing_check(table);
  if (worst != nullptr && worst->status == CheckStatus::exceeded) return VerdictKind::exceeded;
  if (worst == nullptr) return VerdictKind::not_judged;
  return count(findings, FindingSeverity::serious) > 0 ? VerdictKind::reserved : VerdictKind::passed;
}

Json verdict_json(const Verdict& verdict) {
  return {{"kind", word(verdict.kind)}, {"words", verdict.headline}, {"because", verdict.because}};
}

std::string serious_codes(const Findings& findings) {
  std::vector<std::string_view> codes;
  for (const Finding& finding : serious_findings(findings)) {
    if (ranges::find(codes, kind(finding.code).name) == codes.end()) codes.push_back(kind(finding.code).name);
  }
  return fmt::format("{}", fmt::join(codes, ", "));
}

std::string serious_findings_text(const Findings& findings) {
  const std::size_t serious = count(findings, FindingSeverity::serious);
  if (serious == 0) return "";
  return fmt::format("{} serious finding{}: {}", serious, serious == 1 ? "" : "s", serious_codes(findings));
}

Verdict make_verdict(const CheckTable& table, const Findings& findings) {
  const VerdictKind kind = verdict_kind(table, findings);
  const CheckRow* worst = find_governing_check(table);
  const std::string reserved = serious_findings_text(findings);
  switch (kind) {
    case VerdictKind::not_judged:
      return {kind, reserved.empty() ? "NOT JUDGED" : "NOT JUDGED, " + reserved, reasons(table)};
    case VerdictKind::exceeded:
      return {kind, "EXCEEDED " + factor(worst->utilisation) + ", " + check_label(*worst), reasons(table)};
    case VerdictKind::reserved:
      return {kind, "PASSED WITH RESERVATIONS: " + reserved, reasons(table)};
    default:
      return {kind, "PASSED", reasons(table)};
  }
}

const CheckRow* governing_check(const CheckTable& table, CheckRegion region) {
  const CheckRow* worst = nullptr;
  for (const CheckRow& row : table.rows) {
    if (row.region != region || !row.governing || !row.judged()) continue;
    if (worst == nullptr || row.utilisation > worst->utilisation) worst = &row;
  }
  return worst;
}

const std::vector<CheckRegion>& check_regions() {
  static const std::vector<CheckRegion> kOrder = {CheckRegion::tower,   CheckRegion::overbend, CheckRegion::tip,
                                                  CheckRegion::sagbend, CheckRegion::seabed,   CheckRegion::line};
  return kOrder;
}

std::string check_label(const CheckRow& row) {
  const std::string name = lower_first(row.name);
  const bool placed = row.region == CheckRegion::line || row.name.find(word(row.region)) != std::string::npos;
  return placed ? name : name + ", " + word(row.region);
}

std::string region_title(CheckRegion region) {
  if (region == CheckRegion::line) return "Line and equipment";
  std::string title = word(region);
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

}  // namespace overbend
