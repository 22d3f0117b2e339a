#include "resultfiles/studies/seek_writer.h"

#include <limits>

#include "base/units.h"
#include "base/version.h"
#include "resultfiles/tables/csv_table.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

/// Name in the model file (model/description/seek_texts.h, whose names differ from those of the results).
const char* relation(const std::optional<SeekRelation>& is) {
  if (!is) return "minimised";
  return *is == SeekRelation::equals ? "equals" : *is == SeekRelation::at_most ? "at_most" : "at_least";
}

Json maybe(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Returns one value for a single key, an object by key for several.
template <class Value>
Json by_key(const SeekResults& results, Value value) {
  if (results.unknowns.size() == 1) return value(results.unknowns.front(), 0);
  Json object = Json::object();
  for (std::size_t i = 0; i < results.unknowns.size(); ++i) {
    object[results.unknowns[i].name] = value(results.unknowns[i], i);
  }
  return object;
}

Json slope_json(const SeekResults& results, const SeekGoal& goal) {
  if (goal.slope.size() != results.unknowns.size()) return nullptr;
  return by_key(results, [&](const SeekUnknown&, std::size_t i) { return Json(goal.slope[i]); });
}

Json unknown_json(const SeekUnknown& unknown) {
  return {{"key", unknown.name},
          {"path", unknown.path},
          {"unit", unknown.unit},
          {"from", unknown.from},
          {"to", unknown.to},
          {"before", unknown.before},
          {"answer", unknown.found ? Json(unknown.answer) : Json(nullptr)},
          {"at_bound", unknown.found && unknown.at_bound}};
}

Json goal_json(const SeekResults& results, const SeekGoal& goal) {
  return {{"result", goal.result},
          {"is", relation(goal.is)},
          {"wanted", goal.is ? Json(goal.wanted) : Json(nullptr)},
          {"before", maybe(goal.before)},
          {"reached", maybe(goal.reached)},
          {"unit", goal.unit},
          {"slope", slope_json(results, goal)}};
}

Json step_json(const SeekStep& step) {
  Json json = {{"values", step.values}, {"results", step.results}};
  if (!step.failure.empty()) json["failure"] = step.failure;
  return json;
}

Json jump_json(const SeekJump& jump) {
  return {{"at", jump.key_value}, {"below", jump.below}, {"above", jump.above}, {"why", jump.why}};
}

template <class Row, class Make>
Json make_list(const std::vector<Row>& rows, Make make) {
  Json list = Json::array();
  for (const Row& row : rows) list.push_back(make(row));
  return list;
}

/// Display unit of a column.
struct ColumnUnit {
  std::string name;
  double factor = 1.0;  ///< Factor from the unit shown to SI.
};

ColumnUnit column_unit(const std::string& unit, const std::string& show) {
  return show.empty() ? ColumnUnit{"-"} : ColumnUnit{show, unit_factor(show, unit).value_or(1.0)};
}

ColumnUnit result_column(const SeekGoal& goal) {
  const std::vector<std::string> units = usual_units(goal.unit);
  return column_unit(goal.unit, units.empty() || goal.unit == "1" ? "" : units.front());
}

Json present_summary(const std::filesystem::path& file) {
  return read_json_object(file).value_or(Json::object());
}

}  // namespace

Json seek_json(const SeekResults& r) {
  Json json;
  json["found"] = r.found;
  json["why"] = r.why.empty() ? Json(nullptr) : Json(r.why);
  json["answer"] =
      r.found ? by_key(r, [](const SeekUnknown& u, std::size_t) { return Json(u.answer); }) : Json(nullptr);
  json["unit"] = by_key(r, [](const SeekUnknown& u, std::size_t) { return Json(u.unit); });
  json["evaluations"] = r.evaluations;
  json["slope"] = r.goals.empty() ? Json(nullptr) : slope_json(r, r.goals.front());
  json["others"] = r.others;
  json["jumps"] = make_list(r.jumps, jump_json);
  json["monotone"] = r.monotone ? Json(*r.monotone) : Json(nullptr);
  json["residual"] = r.residual;
  json["wall_time"] = r.wall_time;
  json["keys"] = make_list(r.unknowns, unknown_json);
  json["goals"] = make_list(r.goals, [&](const SeekGoal& goal) { return goal_json(r, goal); });
  json["remarks"] = r.remarks;
  if (!r.stages.empty()) json["stages"] = r.stages;
  json["path"] = make_list(r.path, step_json);
  return json;
}

std::string seek_table(const SeekResults& r) {
  std::vector<std::string> names;
  std::vector<double> factors;
  const auto column = [&](const std::string& name, const ColumnUnit& unit) {
    names.push_back(name + " [" + unit.name + "]");
    factors.push_back(unit.factor);
  };
  for (const SeekUnknown& unknown : r.unknowns) column(unknown.name, column_unit(unknown.unit, unknown.show));
  for (const SeekGoal& goal : r.goals) column(goal.result, result_column(goal));
  names.emplace_back("failure");
  CsvTable table(names);
  for (const SeekStep& step : r.path) {
    std::vector<double> cells = step.values;
    cells.insert(cells.end(), step.results.begin(), step.results.end());
    cells.resize(factors.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < cells.size(); ++i) table.cell(cells[i] / factors[i]);
    table.cell(step.failure);
    table.end_row();
  }
  return table.text();
}

void write_seek_files(const SeekResults& results, const std::string& title, const std::filesystem::path& folder) {
  Json summary = present_summary(folder / "summary.json");
  if (summary.empty()) {
    summary = {{"status", "no answer"}, {"title", title}, {"version", kVersion}};
  }
  summary["seek"] = seek_json(results);
  write_text(folder / "summary.json", summary_text(summary));
  write_text(folder / "seek.csv", seek_table(results));
}

}  // namespace overbend
