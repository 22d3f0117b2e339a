#include "resultfiles/static/sensitivity_files.h"

#include <cmath>

#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/summary/summary_fields.h"
#include "resultfiles/tables/csv_table.h"
#include "results/fields/sensitivity_fields.h"

namespace overbend {
namespace {

constexpr const char* kGroup = "/sensitivities";

Json one_sided_json(const SensitivityResults& s, std::size_t result, std::size_t input) {
  Json json = {{"result", s.results[result].name}, {"input", s.inputs[input].name}};
  json.update(make_object(SummaryStyle{}, [&](auto& visitor) { visit_one_sided(s.at(result, input), visitor); }));
  return json;
}

/// Returns the unit of a derivative: "N m^-1".
std::string derivative_unit(const SensitivityOutput& result, const SensitivityInput& input) {
  return input.unit == "1" ? result.unit : result.unit + " / (" + input.unit + ")";
}

template <class Row, class VisitRow>
void write_rows(DatasetSink& file, const std::string& path, const std::string& description,
                const std::vector<Row>& rows, VisitRow visit_row) {
  TableWriter table;
  for (const Row& row : rows) {
    table(index_field("Number of the row, from 0"), table.rows());
    visit_row(row, table);
    table.end_row();
  }
  if (!rows.empty()) table.write(file, path, description);
}

template <class Row, class VisitRow>
std::vector<Row> read_rows(const Hdf5Reader& file, const std::string& path, VisitRow visit_row) {
  if (!file.has(path)) return {};
  TableReader table(file, path);
  std::vector<Row> rows(table.rows("index"));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    table.start_row(i);
    visit_row(rows[i], table);
  }
  return rows;
}

template <class S, class Visit>
void visit_heads(S& s, Visit& visit) {
  visit(ResultField{"assumptions", "1", "Assumptions"}, s.assumptions);
  visit(ResultField{"without_effect", "1", "Inputs without an effect on any result"}, s.without_effect);
  visit(ResultField{"not_done", "1", "Inputs that cannot be varied continuously"}, s.not_done);
  visit(ResultField{"wall_time", "s", "Wall time"}, s.wall_time);
}

}  // namespace

Json sensitivities_json(const SensitivityResults& s) {
  const SummaryStyle style;
  Json json;
  json["inputs"] = Json::array();
  for (const SensitivityInput& input : s.inputs) {
    json["inputs"].push_back(make_object(style, [&](auto& visitor) { visit_sensitivity_input(input, visitor); }));
    json["inputs"].back()["near"] = input.near;
  }
  json["results"] = Json::array();
  json["derivatives"] = Json::array();
  json["one_sided"] = Json::array();
  for (std::size_t r = 0; r < s.results.size(); ++r) {
    json["results"].push_back(
        make_object(style, [&](auto& visitor) { visit_sensitivity_output(s.results[r], visitor); }));
    Json row = Json::array();
    for (std::size_t i = 0; i < s.inputs.size(); ++i) {
      row.push_back(s.at(r, i).value);
      if (s.at(r, i).one_sided()) json["one_sided"].push_back(one_sided_json(s, r, i));
    }
    json["derivatives"].push_back(std::move(row));
  }
  json["without_effect"] = s.without_effect;
  json["not_done"] = s.not_done;
  json["assumptions"] = texts(s.assumptions);
  json[kAssumptionRanks] = rank_names(s.assumptions);
  json["wall_time"] = s.wall_time;
  return json;
}

std::string sensitivities_table(const SensitivityResults& s) {
  CsvTable table({"result", "input", "derivative [SI]", "unit", "tolerance [SI]", "effect of the tolerance [SI]",
                  "one-sided: support", "changes at [SI]", "derivative beyond [SI]"});
  for (std::size_t r = 0; r < s.results.size(); ++r) {
    for (std::size_t i = 0; i < s.inputs.size(); ++i) {
      const Derivative& d = s.at(r, i);
      table.cell(s.results[r].name).cell(s.inputs[i].name).cell(d.value);
      table.cell(derivative_unit(s.results[r], s.inputs[i])).cell(s.inputs[i].tolerance).cell(s.max_effect(r, i));
      table.cell(d.support).cell(d.one_sided() ? d.until : std::nan("")).cell(d.one_sided() ? d.beyond : std::nan(""));
      table.end_row();
    }
  }
  return table.text();
}

void write_sensitivities(DatasetSink& file, const SensitivityResults& s) {
  file.group(kGroup, "Sensitivities: derivatives of the results with respect to the inputs, in SI");
  ValueWriter values{file, kGroup};
  visit_heads(s, values);
  const std::string group = kGroup;
  write_rows(file, group + "/inputs", "Numbers of the model file", s.inputs,
             [](const SensitivityInput& row, auto& visit) { visit_sensitivity_input(row, visit); });
  write_rows(file, group + "/results", "Results", s.results,
             [](const SensitivityOutput& row, auto& visit) { visit_sensitivity_output(row, visit); });
  write_rows(file, group + "/derivatives", "By rows of the results, each with all inputs", s.derivatives,
             [](const Derivative& row, auto& visit) {
               visit(ResultField{"value", kVaries, "Derivative"}, row.value);
               visit_one_sided(row, visit);
             });
}

std::optional<SensitivityResults> read_sensitivities(const Hdf5Reader& file) {
  const std::string group = kGroup;
  if (!file.has(group)) return std::nullopt;
  SensitivityResults s;
  const ValueReader values{file, kGroup};
  visit_heads(s, values);
  s.inputs = read_rows<SensitivityInput>(
      file, group + "/inputs", [](SensitivityInput& row, auto& visit) { visit_sensitivity_input(row, visit); });
  s.results = read_rows<SensitivityOutput>(
      file, group + "/results", [](SensitivityOutput& row, auto& visit) { visit_sensitivity_output(row, visit); });
  s.derivatives = read_rows<Derivative>(file, group + "/derivatives", [](Derivative& row, auto& visit) {
    visit(ResultField{"value"}, row.value);
    visit_one_sided(row, visit);
  });
  return s;
}

}  // namespace overbend
