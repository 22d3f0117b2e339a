#include "serve/model/lay_table_routes.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/interruption.h"
#include "modelfile/reading/yaml_reader.h"
#include "platform/temporary.h"
#include "report/studies/lay_table_data.h"
#include "resultfiles/studies/lay_table_writer.h"
#include "resultfiles/tables/data_table.h"
#include "resultfiles/tables/xlsx_table.h"
#include "results/fields/lay_table_fields.h"
#include "runstore/append_file.h"
#include "serve/model/diagnose.h"
#include "statics/solver/unsupported_statics.h"
#include "study/lay_table/lay_table.h"
#include "study/lay_table/lay_table_range.h"

namespace overbend {
namespace {

LayTableVary read_vary(const Json& request) {
  LayTableVary vary = LayTableVary::tension;
  const auto word = request.find("vary");
  if (word == request.end()) return vary;
  if (!word->is_string() || !from_enum_name(word->get<std::string>(), vary)) {
    throw HttpError(400, "'vary' must be tension, lay_back or depth");
  }
  return vary;
}

/// Returns the requested table; members that are missing are taken from the model.
LayTableDescription asked(const Description& description, const Json& request) {
  LayTableDescription table = description.lay_table.value_or(LayTableDescription{});
  const LayTableVary vary = read_vary(request);  // an invalid value is rejected even if it is not used
  const auto range = request.find("range");
  if (range == request.end()) return table;
  if (!range->is_string()) throw HttpError(400, "'range' must be a text such as '200 kN..400 kN/20'");
  try {
    take_range(vary, range->get<std::string>(), table);
  } catch (const std::invalid_argument& error) {
    throw HttpError(422, error.what());
  }
  return table;
}

Json cell_json(const TableColumn& column, const TableCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return *number * column.factor;
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* verdict = std::get_if<VerdictCell>(&cell)) return verdict->text;
  return nullptr;
}

Json table_json(const LayTable& table) {
  const Table data = lay_table_data(table);
  Json columns = Json::array(), rows = Json::array();
  for (const TableColumn& column : data.columns) {
    columns.push_back({{"heading", title_with_unit(column)}, {"digits", column.digits}});
  }
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    Json cells = Json::array();
    const std::vector<TableCell>& row = data.rows[i].cells;
    for (std::size_t k = 0; k < row.size(); ++k) cells.push_back(cell_json(data.columns[k], row[k]));
    rows.push_back({{"kind", word(table.rows[i].kind)}, {"verdict", lay_verdict(table.rows[i])}, {"cells", cells}});
  }
  return {{"status", "ok"},
          {"columns", columns},
          {"rows", rows},
          {"curves", lay_table_curves(table)},
          {"findings", findings_json(table.findings)},
          {"wall_time", table.wall_time}};
}

}  // namespace

Json LayTables::make(const ModelText& model, const Json& request) {
  const ModelReading reading = read_model_text(model.text, model.path);
  if (!reading.description) {
    return {{"status", "invalid"}, {"diagnostics", diagnostics_json(reading, model.text)}};
  }
  if (const auto unsupported = missing_pipe_message(*reading.description, "a lay table")) {
    throw HttpError(422, *unsupported);
  }
  const LayTableDescription wanted = asked(*reading.description, request);
  const std::uint64_t mine = ++asked_;
  const std::lock_guard one_at_a_time(work_);
  const InterruptionScope scope([&] { return asked_ != mine; });
  std::shared_ptr<const LayTable> table;
  try {
    table = std::make_shared<const LayTable>(make_lay_table(*reading.description, wanted));
  } catch (const Interrupted&) {
    if (asked_ == mine) throw;
    throw HttpError(409, "a newer lay table has been requested");
  }
  const std::lock_guard lock(mutex_);
  last_ = table;
  return table_json(*table);
}

std::shared_ptr<const LayTable> LayTables::last() const {
  const std::lock_guard lock(mutex_);
  if (!last_) throw HttpError(404, "no lay table has been made yet");
  return last_;
}

HttpAnswer LayTables::csv() const {
  return {200, "text/csv; charset=utf-8", csv_text(lay_table_data(*last())), "lay-table.csv"};
}

HttpAnswer LayTables::xlsx() const {
  std::error_code error;
  const ScratchFolder scratch(error);
  if (error) throw FileError("a temporary folder cannot be created: " + error.message());
  const std::filesystem::path path = scratch.path() / "lay-table.xlsx";
  write_xlsx({lay_table_data(*last())}, path);
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return {200, "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet", bytes, "lay-table.xlsx"};
}

void add_lay_table_routes(std::vector<HttpRoute>& routes, OpenModel& model, LayTables& tables) {
  routes.push_back(
      {"POST", "/api/lay-table",
       [&](const HttpRequest& request) { return json_answer(tables.make(model.snapshot(), request.json())); },
       kLongLimit});
  routes.push_back({"GET", "/api/lay-table.csv", [&](const HttpRequest&) { return tables.csv(); }});
  routes.push_back({"GET", "/api/lay-table.xlsx", [&](const HttpRequest&) { return tables.xlsx(); }});
}

}  // namespace overbend
