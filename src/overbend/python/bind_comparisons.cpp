// Folders of results beside each other.
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

Json told_comparison(const FolderComparison& comparison) {
  Json folders = Json::array(), keys = Json::array(), results = Json::array(), findings = Json::array();
  for (const ComparedFolder& one : comparison.folders) {
    folders.push_back({{"name", one.name},
                       {"path", one.path},
                       {"title", one.title},
                       {"version", one.version},
                       {"governing", one.governing},
                       {"warnings", messages(one.findings)},
                       {"findings", findings_json(one.findings)}});
  }
  for (const ComparedKey& one : comparison.keys) keys.push_back({{"key", one.key}, {"values", one.values}});
  for (const ComparedResult& one : comparison.results) {
    results.push_back({{"name", one.name},
                       {"text", one.text},
                       {"unit", one.unit},
                       {"key", one.key},
                       {"values", compared_numbers(one.values)}});
  }
  for (const PartialFinding& one : partial_findings(comparison)) {
    findings.push_back({{"text", one.finding.message},
                        {"code", kind(one.finding.code).name},
                        {"severity", name(one.finding.severity())},
                        {"has", one.has}});
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
                                                                  "Folders of results beside each other.")
      .def(py::init(&compared), py::arg("folders"))
      .def("told", [](const Given<FolderComparison>& comparison) { return to_python(told_comparison(*comparison)); })
      .def("save", &save_comparison, py::arg("folder"));
}

}  // namespace overbend
