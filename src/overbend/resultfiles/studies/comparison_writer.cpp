#include "resultfiles/studies/comparison_writer.h"

#include <cmath>
#include <stdexcept>

#include "resultfiles/static/results_writer.h"
#include "resultfiles/studies/seeds_writer.h"
#include "resultfiles/summary/summary_json.h"
#include "resultfiles/tables/csv_table.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

/// Calls `put(name, quantity, values of the runs)` for every compared quantity.
template <class Put>
void for_each_row(const Comparison& comparison, Put put) {
  for (std::size_t i = 0; i < comparison.quantities.size(); ++i) {
    std::vector<double> values;
    for (const ComparedRun& run : comparison.runs) values.push_back(run.values.at(i));
    put(comparison.quantities[i].name, comparison.quantities[i], values);
  }
  for (const ComparedBoxes& box : comparison.boxes) {
    for (const BoxQuantity& rule : box_quantities()) {
      std::vector<double> values;
      for (const ComparedBox& run : box.runs) values.push_back(run.*(rule.value));
      put("support/" + box.name + "/" + rule.quantity.name, rule.quantity, values);
    }
  }
}

void require_finite_values(const Comparison& comparison) {
  for_each_row(comparison, [&](const std::string& name, const SeedQuantity&, const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isfinite(values[i])) throw std::runtime_error(comparison.runs[i].name + ": " + name + " is not finite");
    }
  });
}

Json run_json(const ComparedRun& run, const std::vector<SeedQuantity>& quantities) {
  Json json = {{"name", run.name}, {"words", run.label}};
  for (std::size_t i = 0; i < quantities.size(); ++i) json[quantities[i].name] = run.values.at(i);
  json["warnings"] = messages(run.results.findings);
  json["findings"] = findings_json(run.results.findings);
  return json;
}

Json box_json(const ComparedBoxes& box, const std::vector<ComparedRun>& runs) {
  Json json = {{"name", box.name}, {"structure", box.stinger ? "stinger" : "ramp"}};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const ComparedBox& seen = box.runs.at(i);
    Json values = Json::object();
    for (const BoxQuantity& rule : box_quantities()) values[rule.quantity.name] = seen.*(rule.value);
    values["row_contact_share"] = seen.row_share;
    values["row_peak_force"] = seen.row_peak;
    json[runs[i].name] = values;
  }
  return json;
}

}  // namespace

const std::vector<BoxQuantity>& box_quantities() {
  static const std::vector<BoxQuantity> kQuantities = {
      {{"contact_share", "1", "Fraction of time in contact"}, &ComparedBox::contact_share},
      {{"static_reaction", "N", "Reaction in the static state"}, &ComparedBox::static_reaction},
      {{"mean_reaction", "N", "Mean reaction"}, &ComparedBox::mean_reaction},
      {{"peak_reaction", "N", "Largest reaction"}, &ComparedBox::peak_reaction},
      {{"peak_force", "N", "Largest force of one roller"}, &ComparedBox::peak_force},
      {{"dent_depth", "m", "Dent of bare steel under that force"}, &ComparedBox::dent_depth},
      {{"line_load", "N/m", "Load on the coating under that force"}, &ComparedBox::line_load}};
  return kQuantities;
}

std::string comparison_table(const Comparison& comparison) {
  std::vector<std::string> head = {"quantity", "unit"};
  for (const ComparedRun& run : comparison.runs) head.push_back(run.name);
  head.emplace_back("description");
  CsvTable table(head);
  for_each_row(comparison,
               [&](const std::string& name, const SeedQuantity& quantity, const std::vector<double>& values) {
                 const ShownUnit unit = table_unit(quantity);
                 table.cell(name).cell(std::string(unit.name));
                 for (const double value : values) table.cell(value * unit.factor);
                 table.cell(quantity.description).end_row();
               });
  return table.text();
}

std::string comparison_summary(const StaticResults& statics, const Comparison& comparison) {
  Json quantities = Json::object(), runs = Json::array(), boxes = Json::array();
  for (const SeedQuantity& q : comparison.quantities) {
    quantities[q.name] = {{"units", q.units}, {"description", q.description}};
  }
  for (const ComparedRun& run : comparison.runs) runs.push_back(run_json(run, comparison.quantities));
  for (const ComparedBoxes& box : comparison.boxes) boxes.push_back(box_json(box, comparison.runs));
  Json summary = static_summary_json(statics);
  summary["comparison"] = {{"of", enum_name(comparison.of)},
                           {"duration", comparison.duration},
                           {"build_up", comparison.build_up},
                           {"quantities", quantities},
                           {"variants", runs}};
  if (!comparison.boxes.empty()) summary["comparison"]["supports"] = boxes;
  return summary_text(summary);
}

void write_comparison_files(const StaticResults& statics, const Comparison& comparison,
                            const std::filesystem::path& folder) {
  require_finite_values(comparison);
  write_text(folder / "comparison.csv", comparison_table(comparison));
  write_text(folder / "comparison.json", comparison_summary(statics, comparison));
}

}  // namespace overbend
