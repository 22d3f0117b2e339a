#include "resultfiles/check_tables.h"

#include "resultfiles/csv_table.h"
#include "resultfiles/result_field.h"

namespace overbend {
namespace {

/// Plain numbers have no unit; a strain is one by what it is called.
TableUnit engineering(const std::string& units, const std::string& what) {
  if (units == "Pa") return {"MPa", kMega};
  if (units == "N m") return {"kN m", kKilo};
  if (units == "N") return {"kN", kKilo};
  if (units == "N/m") return {"kN/m", kKilo};
  if (units != "1") return {units, 1.0};
  return what.find("strain") != std::string::npos ? TableUnit{"%", kPercent} : TableUnit{"", 1.0};
}

std::string inputs_text(const CheckRow& row) {
  std::string text;
  for (const CheckInput& input : row.inputs) {
    if (!text.empty()) text += "; ";
    const TableUnit unit = check_unit(input);
    text += fmt::format("{} = {:.6g}", input.symbol, input.value * unit.factor);
    if (!unit.name.empty()) text += " " + unit.name;
  }
  return text;
}

Json row_json(const CheckRow& row) {
  Json inputs = Json::array();
  for (const CheckInput& i : row.inputs) {
    inputs.push_back({{"symbol", i.symbol}, {"meaning", i.meaning}, {"value", i.value}, {"units", i.units}});
  }
  Json json = check_head_json(row);
  json["inputs"] = inputs;
  if (row.status == CheckStatus::not_done) return json;
  Json at = {{"s", row.s}, {"from_top", row.from_top}};
  at.update(place(row.p_W));
  json.update({{"quantity", row.quantity},
               {"units", row.units},
               {"demand", row.demand},
               {"capacity", row.capacity},
               {"utilisation", row.utilisation},
               {"reserve", row.reserve},
               {"at", at},
               {"time", row.in_time ? Json(row.time) : Json(nullptr)}});
  return json;
}

}  // namespace

TableUnit check_unit(const CheckRow& row) {
  return engineering(row.units, row.quantity);
}

TableUnit check_unit(const CheckInput& input) {
  if (input.units == "m") return {"mm", kMillimetres};
  const bool factor = input.meaning.find("factor") != std::string::npos;
  return engineering(input.units, factor ? "" : input.meaning);
}

Json check_head_json(const CheckRow& row) {
  return {{"id", row.id},
          {"name", row.name},
          {"code", row.code},
          {"clause", row.clause},
          {"region", word(row.region)},
          {"status", word(row.status)},
          {"governing", row.governing},
          {"remark", row.remark}};
}

std::string checks_table(const CheckTable& table) {
  CsvTable csv({"check",          "code",     "clause", "region",   "status", "governing", "utilisation",
                "reserve factor", "quantity", "demand", "capacity", "units",  "s [m]",     "from tensioner [m]",
                "x [m]",          "y [m]",    "z [m]",  "time [s]", "remark", "inputs"});
  for (const CheckRow& row : table.rows) {
    const bool done = row.status != CheckStatus::not_done;
    const auto number = [&](double value) { done ? csv.cell(value) : csv.cell(std::string()); };
    const TableUnit unit = check_unit(row);
    csv.cell(row.name).cell(row.code).cell(row.clause).cell(std::string(word(row.region)));
    csv.cell(std::string(word(row.status))).cell(std::string(row.governing ? "yes" : "for information"));
    number(row.utilisation);
    number(row.reserve);
    csv.cell(row.quantity);
    number(row.demand * unit.factor);
    number(row.capacity * unit.factor);
    csv.cell(unit.name.empty() ? "-" : unit.name);
    for (const double value : {row.s, row.from_top, row.p_W.x(), row.p_W.y(), row.p_W.z()}) number(value);
    row.in_time ? csv.cell(row.time) : csv.cell(std::string());
    csv.cell(row.remark).cell(inputs_text(row));
    csv.end_row();
  }
  return csv.text();
}

Json checks_json(const CheckTable& table) {
  Json rows = Json::array();
  for (const CheckRow& row : table.rows) rows.push_back(row_json(row));
  const CheckRow* worst = worst_check(table);
  return {{"worst", worst != nullptr ? row_json(*worst) : Json(nullptr)}, {"list", rows}};
}

}  // namespace overbend
