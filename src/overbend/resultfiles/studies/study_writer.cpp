#include "resultfiles/studies/study_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "base/ranges.h"
#include "base/require.h"
#include "base/units.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/studies/operability_json.h"
#include "resultfiles/studies/operability_table.h"
#include "resultfiles/summary/summary_json.h"
#include "resultfiles/tables/data_table.h"
#include "resultfiles/tables/xlsx_table.h"
#include "runstore/append_file.h"
#include "runstore/replace_file.h"

#include "results/result_enum_names.h"
namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr std::array kStates = {"open", "done", "failed"};

const char* state_name(const StudyCase& study_case) {
  return kStates.at(static_cast<std::size_t>(study_case.state));
}

bool has_seeds(const StudyResults& results) {
  return ranges::any_of(results.cases, [](const StudyCase& study_case) { return study_case.seed.has_value(); });
}

/// Returns the factor from the unit shown to SI.
double si_factor(const StudyInput& input) {
  if (input.show.empty()) return 1.0;
  const std::optional<double> factor = unit_factor(input.show, input.unit);
  require(factor.has_value(), "an input is shown in a unit of its dimension");
  return *factor;
}

TableCell number_cell(std::optional<double> value, double factor = 1.0) {
  return value && std::isfinite(*value) ? TableCell(*value * factor) : TableCell();
}

TableCell input_cell(const StudyInput& input, const StudyCase& study_case, std::size_t i) {
  if (i >= study_case.value_texts.size()) return {};
  if (input.unit.empty()) return study_case.value_texts[i];
  return number_cell(study_case.inputs[i], 1.0 / si_factor(input));
}

TableCell verdict_cell(const StudyCase& study_case) {
  return VerdictCell{study_case.verdict, word(study_case.verdict)};
}

std::vector<TableCell> make_cells(const StudyResults& results, const StudyCase& study_case, bool seeds) {
  std::vector<TableCell> cells = {study_case.number, study_case.folder};
  for (std::size_t i = 0; i < results.inputs.size(); ++i) cells.push_back(input_cell(results.inputs[i], study_case, i));
  if (seeds) cells.push_back(study_case.seed ? TableCell(*study_case.seed) : TableCell());
  const bool done = study_case.state == StudyCaseState::done;
  for (std::size_t i = 0; i < results.outputs.size(); ++i) {
    const StudyOutput& output = results.outputs[i];
    if (!done || i >= study_case.values.size()) {
      cells.emplace_back();
    } else if (output.text) {
      cells.emplace_back(study_case.texts[i]);
    } else {
      cells.push_back(number_cell(study_case.values[i]));
    }
  }
  cells.push_back(done ? verdict_cell(study_case) : TableCell());
  cells.emplace_back(study_case.governing);
  cells.push_back(number_cell(study_case.utilisation));
  cells.emplace_back(state_name(study_case));
  cells.emplace_back(study_case.reason);
  cells.emplace_back(study_case.wall_time);
  return cells;
}

std::vector<double> input_column(const StudyResults& results, std::size_t i) {
  std::vector<double> values;
  for (const StudyCase& study_case : results.cases) {
    values.push_back(i < study_case.inputs.size() ? study_case.inputs[i] : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

template <class Value, class Take>
std::vector<Value> column(const StudyResults& results, Take take) {
  std::vector<Value> values;
  for (const StudyCase& study_case : results.cases) values.push_back(take(study_case));
  return values;
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Returns a path that is a single HDF5 link: '/' in the name would create groups.
std::string link(const std::string& group, std::string name) {
  ranges::replace(name, '/', '_');
  return group + "/" + name;
}

void write_inputs(const StudyResults& results, DatasetSink& file, const std::vector<Extent>& shape) {
  file.group("/inputs", "Keys of the model that vary between cases");
  for (std::size_t i = 0; i < results.inputs.size(); ++i) {
    const StudyInput& input = results.inputs[i];
    const std::string path = link("/inputs", input.key);
    if (input.unit.empty()) {
      const auto texts = column<std::string>(results, [i](const StudyCase& study_case) {
        return i < study_case.value_texts.size() ? study_case.value_texts[i] : std::string();
      });
      file.write(path, ResultField{"", "-", "Value of the key"}, texts, shape);
    } else {
      file.write(path, ResultField{"", input.unit, "Value of the key"}, input_column(results, i), shape);
    }
  }
}

void write_outputs(const StudyResults& results, DatasetSink& file, const std::vector<Extent>& shape) {
  file.group("/outputs", "Results collected for every case, by their names in summary.json");
  for (std::size_t i = 0; i < results.outputs.size(); ++i) {
    const StudyOutput& output = results.outputs[i];
    const std::string path = link("/outputs", output.name);
    if (output.text) {
      const auto texts = column<std::string>(results, [i](const StudyCase& study_case) {
        return i < study_case.texts.size() ? study_case.texts[i] : std::string();
      });
      file.write(path, ResultField{"", "-", "Result"}, texts, shape);
    } else {
      const auto values = column<double>(results, [i](const StudyCase& study_case) {
        return i < study_case.values.size() ? study_case.values[i].value_or(kNone) : kNone;
      });
      file.write(path, ResultField{"", output.unit, "Result; NaN if the case has none"}, values, shape);
    }
  }
}

void write_cases(const StudyResults& results, DatasetSink& file, const std::vector<Extent>& shape) {
  file.group("/case", "Outcome of every case");
  const auto count = [](const StudyCase& study_case) { return static_cast<int>(study_case.number); };
  file.write("/case/number", ResultField{"", "1", "Number of the case, from 0"}, column<int>(results, count), shape);
  if (has_seeds(results)) {
    const auto seed = [](const StudyCase& study_case) { return study_case.seed.value_or(0); };
    file.write("/case/seed", ResultField{"", "1", "Seed of the waves"}, column<std::uint64_t>(results, seed), shape);
  }
  const auto passed = [](const StudyCase& study_case) { return study_case.passed() ? 1 : 0; };
  file.write("/case/passed",
             ResultField{"", "1",
                         "1 if the case passes: no governing check exceeded, no serious "
                         "finding"},
             column<int>(results, passed), shape);
  const auto used = [](const StudyCase& study_case) { return study_case.utilisation.value_or(kNone); };
  file.write("/case/utilisation", ResultField{"", "1", "Maximum utilisation of the governing checks"},
             column<double>(results, used), shape);
  const auto text = [&](const char* path, const char* meaning, auto take) {
    file.write(path, ResultField{"", "-", meaning}, column<std::string>(results, take), shape);
  };
  text("/case/governing", "Name of that check", [](const StudyCase& study_case) { return study_case.governing; });
  text("/case/state", "open, done or failed",
       [](const StudyCase& study_case) { return std::string(state_name(study_case)); });
  text("/case/reason", "Reason for the failure", [](const StudyCase& study_case) { return study_case.reason; });
  text("/case/folder", "Folder of the case within that of the study",
       [](const StudyCase& study_case) { return study_case.folder; });
  const auto time = [](const StudyCase& study_case) { return study_case.wall_time; };
  file.write("/case/wall_time", ResultField{"", "s", "Wall time"}, column<double>(results, time), shape);
}

/// Writes a row for each group of seeds and each output that is an extreme.
void write_extremes(const StudyResults& results, DatasetSink& file) {
  TableWriter table;
  for (const StudyExtreme& extreme : results.extremes) {
    const StudyOutput& output = results.outputs.at(extreme.output);
    const StudyEstimate none{kNone, kNone, kNone};
    const StudyEstimate gumbel = extreme.enough ? extreme.gumbel : none, acer = extreme.acer.value_or(none);
    table(index_field("Number of the row, from 0"), table.rows());
    table(ResultField{"group", "1", "Group of cases that differ only in the seed, from 0"},
          static_cast<int>(extreme.group));
    table(ResultField{"result", "1", "Name of the output"}, output.name);
    table(ResultField{"units", "1", "SI unit of its values"}, output.unit);
    table(ResultField{"runs", "1", "Number of seeds"}, extreme.runs);
    table(ResultField{"largest", "1", "1 for a maximum, 0 for a minimum"}, extreme.is_maximum);
    table(ResultField{"mean", kVaries, "Mean of the extremes of the runs"}, extreme.mean);
    table(ResultField{"std", kVaries, "Their standard deviation"}, extreme.std);
    table(ResultField{"worst", kVaries, "Worst of these extremes"}, extreme.worst);
    const char* in_three_hours = "Most probable extreme of three hours, by a Gumbel distribution; NaN: too few runs";
    table(ResultField{"gumbel", kVaries, in_three_hours}, gumbel.value);
    table(ResultField{"gumbel_low", kVaries, "Lower bound of its 95 % confidence interval"}, gumbel.low);
    table(ResultField{"gumbel_high", kVaries, "Upper bound of its 95 % confidence interval"}, gumbel.high);
    table(ResultField{"acer", kVaries, "The same by average conditional exceedance rates; NaN: too few peaks"},
          acer.value);
    table(ResultField{"acer_low", kVaries, "Lower bound of its 95 % confidence interval"}, acer.low);
    table(ResultField{"acer_high", kVaries, "Upper bound of its 95 % confidence interval"}, acer.high);
    table.end_row();
  }
  table.write(file, "/extremes", "Extremes over the seeds");
}

/// Writes an array over the axes of the chart; NaN without a limit.
void write_operability(const OperabilityResults& results, DatasetSink& file) {
  file.group("/operability", "Largest " + results.over + " that passes, over the axes of the chart");
  std::vector<Extent> shape;
  for (const StudyInput& axis : results.axes) {
    shape.push_back(axis.value_texts.size());
    const std::string path = link("/operability", axis.key);
    if (axis.values.empty()) {
      file.write(path, ResultField{"", "-", "Values of the axis"}, axis.value_texts, {axis.value_texts.size()});
    } else {
      file.write(path, ResultField{"", axis.unit, "Values of the axis"}, axis.values, {axis.values.size()});
    }
  }
  if (shape.empty()) shape.push_back(1);
  std::vector<double> limits, above;
  std::vector<std::string> governing;
  for (const OperabilityCell& cell : results.cells) {
    limits.push_back(cell.limit.value_or(kNone));
    above.push_back(cell.above);
    governing.push_back(cell.governing);
  }
  file.write("/operability/limit", ResultField{"", results.unit, "Maximum passing value; NaN if none passes"}, limits,
             shape);
  file.write("/operability/utilisation_above", ResultField{"", "1", "Utilisation at the next value"}, above, shape);
  file.write("/operability/governing", ResultField{"", "-", "Criterion exceeded at that value"}, governing, shape);
}

std::string make_summary(const StudyResults& results) {
  const auto count = [&](StudyCaseState state) { return ranges::count(results.cases, state, &StudyCase::state); };
  Json failed = Json::array();
  for (const StudyCase& study_case : results.cases) {
    if (study_case.state == StudyCaseState::failed) {
      failed.push_back({{"case", study_case.number}, {"reason", study_case.reason}});
    }
  }
  const auto passed = ranges::count_if(results.cases, [](const StudyCase& study_case) {
    return study_case.state == StudyCaseState::done && study_case.passed();
  });
  const auto open = count(StudyCaseState::open);
  Json summary = {{"status", open == 0 ? "completed" : "unfinished"},
                  {"title", results.title},
                  {"version", results.version},
                  {"study",
                   {{"analysis", results.analysis},
                    {"cases", results.cases.size()},
                    {"done", count(StudyCaseState::done)},
                    {"passed", passed},
                    {"open", open},
                    {"failed", failed},
                    {"wall_time", results.wall_time}}}};
  if (results.operability) {
    const auto decided = [](const OperabilityCell& cell) { return cell.decided; };
    if (!ranges::all_of(results.operability->cells, decided)) summary["status"] = "unfinished";
    summary["operability"] = operability_json(*results.operability);
  }
  return summary_text(summary);
}

}  // namespace

ShownUnit shown_output(const StudyOutput& output) {
  // Units of results by name are those of base/units.h; those of the table are the files'.
  static const std::map<std::string, const char*> kOther = {{"N*m", "N m"}, {"N/m^2", "Pa"}, {"m-1", "1/m"}};
  const auto converted = kOther.find(output.unit);
  return shown_unit(output.name, converted == kOther.end() ? std::string_view(output.unit) : converted->second);
}

Table study_table(const StudyResults& results) {
  const bool seeds = has_seeds(results);
  Table table{"study", {{"case", "", 0}, TableColumn("folder")}};
  for (const StudyInput& input : results.inputs) table.column({input.key, ShownUnit{"", input.show}, 3});
  if (seeds) table.column({"seed", "", 0});
  for (const StudyOutput& output : results.outputs) {
    const ShownUnit unit = shown_output(output);
    table.column(output.text ? TableColumn(output.name) : TableColumn(output.name, unit, unit.digits - unit.more));
  }
  table.column(TableColumn("checks"))
      .column(TableColumn("governing check"))
      .column({"utilisation", "", 3})
      .column(TableColumn("state"))
      .column(TableColumn("reason"))
      .column({"wall time", ShownUnit{"s", "s"}, 3});
  for (const StudyCase& study_case : results.cases) table.row(make_cells(results, study_case, seeds));
  return table;
}

void write_study_groups(DatasetSink& file, const StudyResults& results) {
  file.attribute("/", "title", results.title);
  file.attribute("/", "version", results.version);
  file.attribute("/", "analysis", results.analysis);
  if (!results.cases.empty() || !results.operability) {
    const std::vector<Extent> shape = {results.cases.size()};
    write_cases(results, file, shape);
    write_inputs(results, file, shape);
    write_outputs(results, file, shape);
  }
  write_extremes(results, file);
  if (results.operability) write_operability(*results.operability, file);
}

void write_study_hdf5(const StudyResults& results, const fs::path& file) {
  Hdf5Writer writer(file);
  write_study_groups(writer, results);
  writer.close();
}

void write_study_files(const StudyResults& results, const fs::path& folder) {
  const Table table = study_table(results);
  replace_file(folder / "study.csv", csv_text(table));
  std::vector<Table> sheets = {table};
  if (results.operability) {
    sheets = {operability_table(*results.operability), workability_table(*results.operability)};
    replace_file(folder / "operability.csv", csv_text(sheets.front()));
    if (!results.cases.empty()) sheets.push_back(table);
  }
  write_xlsx(sheets, folder / "study.xlsx");
  const fs::path h5 = folder / "study.h5", partial_file = folder / "study.h5.part";
  write_study_hdf5(results, partial_file);
  name_complete_file(partial_file, h5);
  replace_file(folder / "summary.json", make_summary(results));
}

}  // namespace overbend
