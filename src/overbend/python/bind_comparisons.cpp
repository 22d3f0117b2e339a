// Comparison of folders of results.
#include <pybind11/stl.h>

#include "python/bindings.h"
#include "python/given.h"
#include "python/python_errors.h"
#include "python/to_python.h"
#include "report/studies/folder_comparison_page.h"
#include "resultfiles/studies/folder_comparison_writer.h"
#include "runstore/staged_folder.h"
#include "study/compare/folder_compare.h"

namespace overbend {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

Json compared_numbers(const std::vector<std::optional<double>>& values) {
  Json list = Json::array();
  for (const std::optional<double>& value : values) list.push_back(value ? Json(*value) : Json(nullptr));
  return list;
}

Json comparison_json(const FolderComparison& comparison) {
  Json folders = Json::array(), keys = Json::array(), results = Json::array(), findings = Json::array();
  for (const ComparedFolder& folder : comparison.folders) {
    folders.push_back({{"name", folder.name},
                       {"path", folder.path},
                       {"title", folder.title},
                       {"version", folder.version},
                       {"governing", folder.governing},
                       {"warnings", messages(folder.findings)},
                       {"findings", findings_json(folder.findings)}});
  }
  for (const ComparedKey& key : comparison.keys) keys.push_back({{"key", key.key}, {"values", key.values}});
  for (const ComparedResult& result : comparison.results) {
    results.push_back({{"name", result.name},
                       {"text", result.text},
                       {"unit", result.unit},
                       {"key", result.key},
                       {"values", compared_numbers(result.values)}});
  }
  for (const PartialFinding& partial : partial_findings(comparison)) {
    findings.push_back({{"text", partial.finding.message},
                        {"code", kind(partial.finding.code).name},
                        {"severity", name(partial.finding.severity())},
                        {"has", partial.has}});
  }
  return {
      {"folders", folders}, {"keys", keys}, {"results", results}, {"warnings", findings}, {"notes", comparison.notes}};
}

std::shared_ptr<FolderComparison> compared(const std::vector<std::string>& folders) {
  if (folders.size() < 2) {
    throw std::invalid_argument("found " + std::to_string(folders.size()) +
                                " folders of results, expected two or more");
  }
  return reading_results([&] {
    return std::make_shared<FolderComparison>(compare_folders({folders.begin(), folders.end()}));
  });
}

void save_comparison(const Given<FolderComparison>& comparison, const std::string& folder) {
  StagedFolder staged{fs::path(folder)};
  write_folder_comparison(*comparison, staged.path());
  write_folder_comparison_page(*comparison, staged.path() / "comparison.html");
  staged.commit("comparison.html");
}

}  // namespace

void add_comparisons(py::module_& module) {
  py::class_<FolderComparison, std::shared_ptr<FolderComparison>>(module, "FolderComparison",
                                                                  "Comparison of folders of results.")
      .def(py::init(&compared), py::arg("folders"))
      .def("content", [](const Given<FolderComparison>& comparison) { return to_python(comparison_json(*comparison)); })
      .def("save", &save_comparison, py::arg("folder"));
}

}  // namespace overbend
