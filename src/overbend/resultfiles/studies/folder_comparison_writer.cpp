#include "resultfiles/studies/folder_comparison_writer.h"

#include <algorithm>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "resultfiles/tables/csv_table.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

void add_result(CsvTable& table, const ComparedResult& result) {
  const ShownUnit unit = shown_unit(result.name, result.unit);
  table.cell(std::string("result")).cell(result.name).cell(unit_label(unit));
  for (const std::optional<double>& value : result.values) {
    if (value) {
      table.cell(*value * unit.factor);
    } else {
      table.cell(std::string());
    }
  }
  for (std::size_t i = 1; i < result.values.size(); ++i) {
    if (const auto change = result.change(i)) {
      table.cell(100.0 * *change);
    } else {
      table.cell(std::string());
    }
  }
  table.end_row();
}

/// Adds a row of texts, without changes.
void add_texts(CsvTable& table, const std::string& section, const std::string& name,
               const std::vector<std::string>& labels) {
  table.cell(section).cell(name).cell(std::string());
  for (const std::string& word : labels) table.cell(word);
  for (std::size_t i = 1; i < labels.size(); ++i) table.cell(std::string());
  table.end_row();
}

}  // namespace

std::vector<PartialFinding> partial_findings(const FolderComparison& comparison) {
  std::vector<PartialFinding> all;
  const std::size_t count = comparison.folders.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (const Finding& finding : comparison.folders[i].findings) {
      auto known = ranges::find_if(all, [&](const PartialFinding& candidate) {
        return candidate.finding.code == finding.code && candidate.finding.object == finding.object;
      });
      if (known == all.end()) known = all.insert(known, {finding, std::vector<bool>(count)});
      known->has[i] = true;
    }
  }
  std::erase_if(all,
                [](const PartialFinding& partial) { return ranges::find(partial.has, false) == partial.has.end(); });
  return all;
}

std::string folder_comparison_table(const FolderComparison& comparison) {
  std::vector<std::string> head = {"section", "name", "unit"};
  for (const ComparedFolder& folder : comparison.folders) head.push_back(folder.name);
  for (std::size_t i = 1; i < comparison.folders.size(); ++i) {
    head.push_back(comparison.folders[i].name + " change [%]");
  }
  CsvTable table(head);
  std::vector<std::string> versions;
  for (const ComparedFolder& folder : comparison.folders) versions.push_back(folder.version);
  add_texts(table, "program", "version", versions);
  for (const ComparedKey& key : comparison.keys) add_texts(table, "input", key.key, key.values);
  for (const ComparedResult& result : comparison.results) add_result(table, result);
  for (const PartialFinding& partial : partial_findings(comparison)) {
    std::vector<std::string> has;
    for (const bool value : partial.has) has.emplace_back(value ? "yes" : "no");
    add_texts(table, "finding", partial.finding.message, has);
  }
  return table.text();
}

void write_folder_comparison(const FolderComparison& comparison, const std::filesystem::path& folder) {
  write_text(folder / "comparison.csv", folder_comparison_table(comparison));
}

}  // namespace overbend
