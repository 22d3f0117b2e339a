#include "report/page/calculation_sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/page/formula_text.h"
#include "report/page/html.h"
#include "results/verdict.h"

namespace overbend {

const char* const kBasisOfChecks = "Basis of the checks: see the calculation sheet.";

namespace {

/// Rows that a check stands for: the same formula with the same limit in another region is not written twice.
bool same_check(const CheckRow& a, const CheckRow& b) {
  return a.id == b.id && a.code == b.code && (a.id != "yield_share" || a.remark == b.remark);
}

/// The most used row of each check, in the order of the table; rows that govern come before those for information.
std::vector<const CheckRow*> most_used_rows(const CheckTable& table) {
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

const char* confirmation_text(const SheetLine& line) {
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

/// The formula with its symbol on the left, as an equation where the value solves one.
std::string equation_html(const SheetLine& line) {
  if (line.formula.empty()) return "";
  const bool implicit = line.formula.find(" = ") != std::string::npos;
  return formula_html(implicit ? line.formula : line.symbol + " = " + line.formula);
}

std::string sheet_row(const std::vector<SheetLine>& lines, std::size_t i) {
  const SheetLine& line = lines[i];
  const std::string confirmed = confirmation_text(line);
  const std::string sources = line.sources.empty() ? "" : ": " + line.sources;
  return fmt::format(
      "<tr{}><td class=\"t\">{}</td><td class=\"t\">{}</td><td class=\"t\">{}</td><td class=\"t\">{}</td>"
      "<td>{}</td><td class=\"t\">{}</td><td class=\"t\">{}</td></tr>\n",
      line.confirmation == Confirmation::unconfirmed ? " class=\"soft\"" : "", formula_html(line.symbol),
      html::escape(line.meaning), equation_html(line), html::escape(numbers_put_in(lines, i)),
      html::escape(value_text(line)), html::escape(line.origin), html::escape(confirmed + sources));
}

std::string sheet_table(const CheckRow& row) {
  std::string body;
  for (std::size_t i = 0; i < row.sheet.size(); ++i) body += sheet_row(row.sheet, i);
  return "<div class=\"table\"><table class=\"dense\">\n<thead><tr><th class=\"t\">Symbol</th><th "
         "class=\"t\">Meaning</th>"
         "<th class=\"t\">Formula</th><th class=\"t\">Numbers put in</th><th>Value</th>"
         "<th class=\"t\">Clause or origin</th><th class=\"t\">Confirmed by</th></tr></thead>\n<tbody>\n" +
         body + "</tbody>\n</table></div>\n";
}

std::string heading(const CheckRow& row) {
  const std::string where = row.line.empty() ? region_title(row.region) : check_place(row);
  return fmt::format("{}, {}{}{}, {}: utilisation {}", row.name, row.code, row.clause.empty() ? "" : ", ", row.clause,
                     where, html::fixed(row.utilisation, 3));
}

}  // namespace

std::string calculation_sheet_section(const CheckTable& table) {
  const std::vector<const CheckRow*> rows = most_used_rows(table);
  if (rows.empty()) return "";
  std::string body =
      "<p>Most used row of each check. A line without a formula is an input or a number of the code. Formulas were "
      "compared with public texts that restate the codes, named in the last column; none was compared with the printed "
      "standard. Compare the clauses below with it before you submit results; start with what is not confirmed.</p>\n";
  for (const CheckRow* row : rows) body += html::folded(heading(*row), sheet_table(*row));
  return html::section("calculation-sheet", "Appendix: calculation sheet of the checks", body);
}

}  // namespace overbend
