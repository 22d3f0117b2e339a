#include "report/static/checks_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/shown_unit.h"
#include "report/page/calculation_sheet.h"
#include "report/page/figure_list.h"
#include "report/page/html.h"
#include "report/page/json_number.h"
#include "report/page/places.h"
#include "resultfiles/static/check_tables.h"
#include "results/fields/result_field.h"
#include "results/verdict.h"

namespace overbend {
namespace {

using html::fixed;

/// Four significant digits or more, without exponents.
std::string number(double value) {
  const double size = std::abs(value);
  return fixed(value, size >= 1000.0 ? 0 : size >= 100.0 ? 1 : size >= 1.0 ? 3 : 4);
}

/// A unit that does not break.
std::string in_one(std::string unit) {
  const std::size_t at = unit.find(' ');
  return at == std::string::npos ? unit : unit.replace(at, 1, "\u00a0");
}

std::string code_of(const CheckRow& row) {
  return row.clause.empty() ? row.code : row.code + ", " + row.clause;
}

std::string status_of(const CheckRow& row) {
  std::string text = row.governing ? word(row.status) : "for information";
  if (!row.governing && row.status != CheckStatus::passed) text += std::string(", ") + word(row.status);
  return row.remark.empty() ? text : text + ": " + row.remark;
}

std::string row_class(const CheckRow& row) {
  if (!row.governing) return "soft";
  return row.status == CheckStatus::exceeded ? "over" : "";
}

std::string reserve_of(const CheckRow& row) {
  return row.reserve >= 999.0 ? "> 999" : fixed(row.reserve, 2);
}

/// Most used first; what could not be judged last.
std::vector<const CheckRow*> rows_of(const CheckTable& table, CheckRegion region) {
  std::vector<const CheckRow*> rows;
  for (const CheckRow& row : table.rows) {
    if (row.region == region) rows.push_back(&row);
  }
  const auto rank = [](const CheckRow* row) { return row->judged() ? (row->governing ? 0 : 1) : 2; };
  std::stable_sort(rows.begin(), rows.end(), [&](const CheckRow* a, const CheckRow* b) {
    return rank(a) != rank(b) ? rank(a) < rank(b) : a->utilisation > b->utilisation;
  });
  return rows;
}

std::string when(const CheckRow& row) {
  return row.in_time ? fixed(row.time, 1) : "static";
}

std::string governing_table(const StaticResults& statics, const CheckTable& table) {
  html::Table out("Governing check of each region",
                  {{"Region", "", true},
                   {"Check", "", true},
                   {"Code", "", true},
                   {"Utilisation", "-"},
                   {"Reserve factor", "-"},
                   {"Place", "", true},
                   {"Along pipe", shown_name("m")},
                   {"Time", "s"},
                   {"Status", "", true}},
                  "checks");
  for (const CheckRegion region : check_regions()) {
    const CheckRow* governing = governing_check(table, region);
    if (governing == nullptr) continue;
    const CheckRow& row = *governing;
    out.row({region_title(region), row.name, code_of(row), fixed(row.utilisation, 3), reserve_of(row),
             place_name(statics, row), along_pipe(statics, row), when(row), word(row.status)},
            row_class(row));
  }
  return out.str();
}

void add_row(html::Table& out, const StaticResults& statics, const CheckRow& row) {
  if (row.status == CheckStatus::not_done) {
    out.row({row.name, code_of(row), "", "", "", "", "", "", "", "", "", status_of(row)}, row_class(row));
    return;
  }
  const ShownUnit units = check_unit(row);
  const Vec3 p = ship_point(statics, row.p_W);
  out.row({row.name, code_of(row), number(row.demand * units.factor), number(row.capacity * units.factor),
           in_one(std::string(units.name)), fixed(row.utilisation, 3), reserve_of(row), along_pipe(statics, row),
           shown_number(p.x(), "m", 1), shown_number(p.z(), "m", 1), when(row), status_of(row)},
          row_class(row));
}

std::string region_table(const StaticResults& statics, const CheckTable& table, CheckRegion region) {
  const std::vector<const CheckRow*> rows = rows_of(table, region);
  if (rows.empty()) return "";
  html::Table out(region_title(region),
                  {{"Check", "", true},
                   {"Code", "", true},
                   {"Demand", ""},
                   {"Capacity", ""},
                   {"Unit", "", true},
                   {"Utilisation", "-"},
                   {"Reserve factor", "-"},
                   {"Along pipe", shown_name("m")},
                   {"X", shown_name("m")},
                   {"Z", shown_name("m")},
                   {"Time", "s"},
                   {"Status", "", true}},
                  "checks");
  for (const CheckRow* row : rows) add_row(out, statics, *row);
  return out.str();
}

/// Of a model without a laid pipe: lines, moorings, anchors, each row with its place.
std::string objects_table(const StaticResults& statics, const CheckTable& table) {
  html::Table out("Checks of all lines, moorings and wires",
                  {{"Check", "", true},
                   {"Code", "", true},
                   {"Place", "", true},
                   {"Demand", ""},
                   {"Capacity", ""},
                   {"Unit", "", true},
                   {"Utilisation", "-"},
                   {"Reserve factor", "-"},
                   {"Status", "", true}},
                  "checks");
  for (const CheckRow* row : rows_of(table, CheckRegion::line)) {
    if (row->status == CheckStatus::not_done) {
      out.row({row->name, code_of(*row), row->line, "", "", "", "", "", status_of(*row)}, row_class(*row));
      continue;
    }
    const ShownUnit units = check_unit(*row);
    out.row({row->name, code_of(*row), place_name(statics, *row), number(row->demand * units.factor),
             number(row->capacity * units.factor), in_one(std::string(units.name)), fixed(row->utilisation, 3),
             reserve_of(*row), status_of(*row)},
            row_class(*row));
  }
  return out.str();
}

std::string inputs_table(const CheckTable& table) {
  html::Table out("",
                  {{"Check", "", true},
                   {"Region", "", true},
                   {"Symbol", "", true},
                   {"Meaning", "", true},
                   {"Value", ""},
                   {"Unit", "", true}},
                  "dense");
  for (const CheckRow& row : table.rows) {
    std::string name = row.name + ", " + row.code;
    for (const CheckInput& input : row.inputs) {
      const ShownUnit units = check_unit(input);
      out.row({name, region_title(row.region), input.symbol, input.meaning, number(input.value * units.factor),
               std::string(units.name)});
      name.clear();
    }
  }
  return html::folded("Input values of each check", out.str());
}

/// Summary of the table, and the meaning of its columns.
std::string headline(const CheckTable& table) {
  return "<p>" + html::escape(make_verdict(table, {}).because) +
         " The reserve factor is the factor on the load effects, at unchanged pressure, at which the utilisation is 1. "
         "<a href=\"#calculation-sheet\">" +
         kBasisOfChecks + "</a></p>\n";
}

}  // namespace

std::string checks_section(const StaticResults& statics, const CheckTable& table, int& number) {
  if (table.along.s.empty()) {
    return table.rows.empty() ? ""
                              : html::section("checks", "Code checks", headline(table) + objects_table(statics, table));
  }
  std::string body = headline(table) + governing_table(statics, table);
  const std::vector<Figure> figures = {
      {"checks",
       "Utilisation of the code checks along the pipe: DNV displacement controlled (DNV strain) and load controlled "
       "(DNV load), simplified laying criteria (laying strain), equivalent stress over 0.87 f_y (stress), bending and "
       "external pressure (API RP 1111)",
       {"whole", "overbend"}}};
  body += figure_list(
      figures, [&](const Figure&, const std::string& part) { return part == "whole" || !statics.supports.empty(); },
      number);
  std::string tables;
  for (const CheckRegion region : check_regions()) tables += region_table(statics, table, region);
  return html::section("checks", "Code checks", body + tables);
}

std::string check_inputs_section(const CheckTable& table) {
  return table.rows.empty()
             ? ""
             : html::section("check-inputs", "Appendix: input values of the checks", inputs_table(table));
}

Json checks_figure_data(const StaticResults& statics, const CheckTable& table) {
  if (table.along.s.empty()) return nullptr;
  Json data;
  const auto add = [&](const char* name, const std::vector<double>& values) {
    Json column = Json::array();
    for (auto value = values.rbegin(); value != values.rend(); ++value) column.push_back(json_number(*value));
    data[name] = column;
  };
  std::vector<double> along;
  for (const double s : table.along.s) along.push_back(from_tensioner(statics, s));
  add("s", along);
  add("load", table.along.load);
  add("strain", table.along.strain);
  add("stress", table.along.stress);
  add("laying", table.along.laying);
  add("api", table.along.api);
  add("governing", table.along.governing);
  return data;
}

}  // namespace overbend
