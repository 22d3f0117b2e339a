#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "base/finding.h"
#include "base/shown_unit.h"
#include "report/studies/folder_comparison_page.h"
#include "resultfiles/studies/folder_comparison_writer.h"
#include "runstore/staged_folder.h"
#include "study/compare/folder_compare.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxLines = 20;

std::string change_text(const ComparedResult& result, std::size_t folder) {
  const auto change = result.change(folder);
  return change ? fmt::format(" ({:+.2f} %)", 100.0 * *change) : "";
}

void print_result(const ComparedResult& result) {
  const ShownUnit unit = shown_unit(result.name, result.unit);
  std::string line = fmt::format("  {:<44}", result.name);
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    line += result.values[i] ? fmt::format(" {:>10.5g}", *result.values[i] * unit.factor) : fmt::format(" {:>10}", "-");
    if (i > 0) line += change_text(result, i);
  }
  std::cout << line << " " << unit.name << "\n";
}

void print(const FolderComparison& comparison) {
  for (const ComparedFolder& folder : comparison.folders) {
    std::cout << fmt::format("{}: {} (Overbend {})\n", folder.name, folder.title, folder.version);
  }
  for (const std::string& note : comparison.notes) std::cout << "  " << note << "\n";
  std::cout << fmt::format("  {} keys of the models differ\n", comparison.keys.size());
  for (std::size_t i = 0; i < std::min(comparison.keys.size(), kMaxLines); ++i) {
    std::string values;
    for (const std::string& value : comparison.keys[i].values) {
      values += (values.empty() ? "" : " | ") + (value.empty() ? std::string("not given") : value);
    }
    std::cout << "  " << comparison.keys[i].key << ": " << values << "\n";
  }
  std::size_t lines = 0, differing = 0;
  for (const ComparedResult& result : comparison.results) {
    if (result.max_relative_change() > 0.0) ++differing;
  }
  std::cout << fmt::format("  {} of {} results differ\n", differing, comparison.results.size());
  for (const ComparedResult& result : comparison.results) {
    if (result.key && lines++ < kMaxLines) print_result(result);
  }
  for (const PartialFinding& partial : partial_findings(comparison)) {
    std::string who;
    for (std::size_t i = 0; i < partial.has.size(); ++i) {
      if (partial.has[i]) who += (who.empty() ? "" : ", ") + comparison.folders[i].name;
    }
    std::cout << "  " << name(partial.finding.severity()) << ", only in " << who << ": " << partial.finding.message
              << "\n";
  }
}

/// True if both paths lead to the same folder.
bool same_folder(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

ExitCode complain(const std::string& what) {
  std::cerr << "overbend: " << what << "\n";
  return kWrongInput;
}

}  // namespace

int run_compare_folders(const std::vector<std::string>& places, const std::string& output) {
  if (places.size() < 2) return complain("compare: found one folder of results, expected two or more");
  const std::vector<fs::path> folders(places.begin(), places.end());
  const fs::path first = fs::absolute(folders.front() / "").parent_path();
  const fs::path target = output.empty() ? fs::path(first.filename().string() + ".comparison") : fs::path(output);
  for (const fs::path& folder : folders) {
    if (same_folder(folder, target)) return complain("-o: " + target.string() + " is one of the folders compared");
  }
  FolderComparison comparison;
  try {
    comparison = compare_folders(folders);
  } catch (const std::runtime_error& error) {
    return complain(error.what());
  }
  try {
    StagedFolder staged(target);
    write_folder_comparison(comparison, staged.path());
    write_folder_comparison_page(comparison, staged.path() / "comparison.html");
    staged.commit("comparison.html");
  } catch (const UnusableFolder& error) {
    return complain(error.what());
  }
  print(comparison);
  std::cout << "The comparison is " << (target / "comparison.html").string() << "\n";
  return kDone;
}

}  // namespace overbend
