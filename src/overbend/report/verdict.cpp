#include "report/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "report/html.h"
#include "results/fields/result_field.h"

namespace overbend {
namespace {

using html::fixed;

std::string lower_first(std::string text) {
  const bool acronym = text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1])) != 0;
  if (!text.empty() && !acronym) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

std::ptrdiff_t count_of(const CheckTable& table, CheckStatus status) {
  return std::count_if(table.rows.begin(), table.rows.end(),
                       [&](const CheckRow& row) { return row.governing && row.status == status; });
}

/// Two decimals, more where they would round an exceeded check to 1.
std::string factor(double utilisation) {
  return utilisation > 1.0 && utilisation < 1.005 ? fixed(utilisation, 4) : fixed(utilisation, 2);
}

std::string reasons(const CheckTable& table) {
  const CheckRow* worst = worst_check(table);
  if (worst == nullptr) return "No check could be judged.";
  const std::ptrdiff_t exceeded = count_of(table, CheckStatus::exceeded);
  const std::ptrdiff_t invalid = count_of(table, CheckStatus::outside_validity);
  std::string text = exceeded == 0
                         ? "No governing check is exceeded."
                         : fmt::format("{} governing check{} exceeded.", exceeded, exceeded == 1 ? " is" : "s are");
  text += fmt::format(" The largest utilisation is {}: {}, {} m from the tensioner{}.", fixed(worst->utilisation, 3),
                      check_words(*worst), fixed(worst->from_top, 1),
                      worst->in_time ? ", t = " + fixed(worst->time, 1) + " s" : "");
  if (invalid > 0) {
    text += fmt::format(" {} outside the validity of {}: neither passed nor failed.", invalid,
                        invalid == 1 ? "its formula" : "their formulas");
  }
  return text;
}

std::string reservation(const CheckTable& table, std::ptrdiff_t serious) {
  const std::ptrdiff_t invalid = count_of(table, CheckStatus::outside_validity);
  std::string words;
  if (invalid > 0) words += fmt::format("{} not judged", invalid);
  if (serious > 0) {
    words += fmt::format("{}{} serious warning{}", words.empty() ? "" : ", ", serious, serious == 1 ? "" : "s");
  }
  return words;
}

}  // namespace

Verdict verdict_of(const CheckTable& table, const std::vector<WeighedWarning>& warnings) {
  const CheckRow* worst = worst_check(table);
  const auto serious = std::count_if(warnings.begin(), warnings.end(),
                                     [](const WeighedWarning& w) { return w.weight == WarningWeight::serious; });
  const std::string reserved = reservation(table, serious);
  if (worst == nullptr) return {VerdictKind::open, "NOT JUDGED", reasons(table)};
  if (worst->status == CheckStatus::exceeded) {
    return {VerdictKind::exceeded, "EXCEEDED " + factor(worst->utilisation) + ", " + check_words(*worst),
            reasons(table)};
  }
  if (!reserved.empty()) return {VerdictKind::reserved, "PASSED WITH RESERVATIONS: " + reserved, reasons(table)};
  return {VerdictKind::passed, "PASSED", reasons(table)};
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

std::string check_words(const CheckRow& row) {
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
