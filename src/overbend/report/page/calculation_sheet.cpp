#include "report/page/calculation_sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/shown_unit.h"
#include "report/page/formula_text.h"
#include "results/verdict.h"

namespace overbend {

const char* const kBasisOfChecks = "Basis of the checks: see the calculation sheet.";

namespace {

/// True if two rows have the same formula with the same limit in different regions: it is printed once.
bool same_check(const CheckRow& a, const CheckRow& b) {
  return a.id == b.id && a.code == b.code && (a.id != "yield_share" || a.remark == b.remark);
}

/// Row with the maximum utilisation of each check, in the order of the table; governing rows before informational ones.
std::vector<const CheckRow*> find_governing_rows(const CheckTable& table) {
  std::vector<const CheckRow*> rows;
  for (const CheckRow& row : table.rows) {
    if (row.sheet.empty()) continue;
    const auto known = std::find_if(rows.begin(), rows.end(), [&](const CheckRow* r) { return same_check(*r, row); });
    if (known == rows.end()) {
      rows.push_back(&row);
    } else if (row.governing != (*known)->governing ? row.governing : row.utilisation > (*known)->utilisation) {
      *known = &row;
    }
  }
  return rows;
}

std::string confirmation_text(const SheetLine& line) {
  switch (line.confirmation) {
    case Confirmation::two_sources:
      return "two or more sources";
    case Confirmation::one_source:
      return "one source";
    case Confirmation::unconfirmed:
      return "not confirmed";
    case Confirmation::not_needed:
      break;
  }
  return "";
}

/// The formula with its symbol on the left, as an equation if the value is its solution.
std::string equation(const SheetLine& line) {
  if (line.formula.empty()) return "";
  const bool implicit = line.formula.find(" = ") != std::string::npos;
  return implicit ? line.formula : line.symbol + " = " + line.formula;
}

Json sheet_line(const std::vector<SheetLine>& lines, std::size_t i) {
  const SheetLine& line = lines[i];
  const std::string sources = line.sources.empty() ? "" : ": " + line.sources;
  Json json = {{"symbol", line.symbol},
               {"meaning", line.meaning},
               {"formula", equation(line)},
               {"numbers", substituted_formula(lines, i)},
               {"value", value_text(line)},
               {"origin", line.origin},
               {"confirmed", confirmation_text(line) + sources}};
  if (line.confirmation == Confirmation::unconfirmed) json["soft"] = true;
  return json;
}

Blocks sheet_block(const CheckRow& row) {
  Json lines = Json::array();
  for (std::size_t i = 0; i < row.sheet.size(); ++i) lines.push_back(sheet_line(row.sheet, i));
  return Blocks({{"kind", "sheet"}, {"lines", lines}});
}

std::string heading(const CheckRow& row) {
  const std::string where = row.line.empty() ? region_title(row.region) : check_place(row);
  return fmt::format("{}, {}{}{}, {}: utilisation {}", row.name, row.code, row.clause.empty() ? "" : ", ", row.clause,
                     where, fixed(row.utilisation, 3));
}

}  // namespace

Blocks calculation_sheet_section(const CheckTable& table) {
  const std::vector<const CheckRow*> rows = find_governing_rows(table);
  if (rows.empty()) return {};
  Blocks body = block::paragraph(
      "Row with the maximum utilisation of each check. A line without a formula is an input or a number of the "
      "code. Formulas were compared with public texts that restate the codes, named in the last column; none was "
      "compared with the printed standard. Compare the clauses below with it before you submit results; start with "
      "those not confirmed.");
  for (const CheckRow* row : rows) body += block::folded(heading(*row), sheet_block(*row));
  return block::section("calculation-sheet", "Appendix: calculation sheet of the checks", body);
}

}  // namespace overbend
