// Trees of datasets in memory and files of results, which look alike from Python: names(group), dataset(path).
#include <pybind11/stl.h>

#include "modelfile/yaml_edit.h"
#include "python/bindings.h"
#include "python/python_errors.h"
#include "python/to_python.h"
#include "resultfiles/hdf5_file.h"
#include "resultfiles/named_dynamics.h"
#include "resultfiles/named_results.h"
#include "resultfiles/result_tree.h"
#include "resultfiles/result_units.h"

namespace overbend {
namespace {

namespace py = pybind11;

/// What stands directly in the group; groups end with '/'. The paths of the tree are in order.
std::vector<std::string> names_in(const ResultTree& tree, std::string group) {
  if (!group.ends_with('/')) group += '/';
  std::vector<std::string> names;
  for (auto at = tree.datasets.lower_bound(group); at != tree.datasets.end() && at->first.starts_with(group); ++at) {
    const std::string below = at->first.substr(group.size());
    const std::size_t slash = below.find('/');
    const std::string name = slash == std::string::npos ? below : below.substr(0, slash + 1);
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  return names;
}

py::tuple dataset_of(const std::shared_ptr<ResultTree>& tree, const std::string& path) {
  const auto found = tree->datasets.find(path);
  if (found == tree->datasets.end()) throw py::key_error(path);
  return told(found->second, py::cast(tree));
}

/// A file that stays open; datasets are read when they are asked for.
class ResultFile {
 public:
  explicit ResultFile(const std::string& path) try : file_(path) {
  } catch (const std::runtime_error& fault) {
    raise_results_error(fault.what());
  }

  std::vector<std::string> names(const std::string& group) const {
    return file_.has(group) || group == "/" ? file_.names(group) : std::vector<std::string>();
  }
  bool has(const std::string& path) const { return file_.has(path); }
  py::tuple dataset(const std::string& path) const {
    if (!file_.has(path)) throw py::key_error(path);
    auto held = std::make_unique<Dataset>(file_.whole(path));
    const Dataset& set = *held;
    const py::capsule owner(held.release(), [](void* pointer) { delete static_cast<Dataset*>(pointer); });
    return told(set, owner);
  }
  /// Of the first dimension `count` lines from `first` on.
  py::array_t<double> lines(const std::string& path, Extent first, Extent count) const {
    const auto held = new std::vector<double>(file_.doubles(path, first, count));
    const py::capsule owner(held, [](void* pointer) { delete static_cast<std::vector<double>*>(pointer); });
    return py::array_t<double>(static_cast<py::ssize_t>(held->size()), held->data(), owner);
  }
  Extent extent(const std::string& path) const { return file_.lines(path); }

 private:
  Hdf5Reader file_;
};

/// Values, unit, and whether the name is of one value.
py::tuple values_of_name(const std::string& summary, const std::string& name) {
  const Json json = read_json(summary);
  const ResultName parsed = parsed_result_name(name);
  const std::string unit = dynamic_result_unit(name).value_or("1");
  const bool many = parsed.function == ResultFunction::none && name.find('[') != std::string::npos;
  if (many) {
    const std::vector<double> values = named_values(json, parsed.path);
    const bool chosen = name.find_first_of("*?") != std::string::npos || name.find("..") != std::string::npos;
    return py::make_tuple(values, unit, !chosen && values.size() == 1);
  }
  const std::optional<double> one = named_result(json, name);
  return py::make_tuple(one ? std::vector<double>{*one} : std::vector<double>(), unit, true);
}

}  // namespace

void add_results(py::module_& module) {
  py::class_<ResultTree, std::shared_ptr<ResultTree>>(module, "ResultTree", "Datasets in memory, by their paths.")
      .def(
          "names", [](const ResultTree& tree, const std::string& group) { return names_in(tree, group); },
          py::arg("group"), "What stands directly in a group; names of groups end with '/'.")
      .def(
          "has", [](const ResultTree& tree, const std::string& path) { return tree.datasets.contains(path); },
          py::arg("path"))
      .def("dataset", &dataset_of, py::arg("path"), "(values, units, description, frame, scales) of a dataset.");
  py::class_<ResultFile>(module, "ResultFile", "results.h5, read when asked.")
      .def(py::init<const std::string&>(), py::arg("path"))
      .def("names", &ResultFile::names, py::arg("group"), "What stands directly in a group; groups end with '/'.")
      .def("has", &ResultFile::has, py::arg("path"))
      .def("dataset", &ResultFile::dataset, py::arg("path"), "(values, units, description, frame, scales).")
      .def("lines", &ResultFile::lines, py::arg("path"), py::arg("first"), py::arg("count"),
           "Numbers of `count` lines of the first dimension, flat.")
      .def("extent", &ResultFile::extent, py::arg("path"), "Number of lines of the first dimension.");
  module.def("named_values", &values_of_name, py::arg("summary"), py::arg("name"),
             "The values of a result by its name in the text of a summary.json, their unit, and whether it is one.");
  module.def("result_paths", &dynamic_result_paths, "The names of all results.");
  module.def("flow_scalar", &yaml_scalar, py::arg("text"), "A text as it stands within YAML's flow style.");
  module.def(
      "summary_units", [] { return to_python(stored_summary_units()); },
      "Units in the places of summary.json's numbers.");
  module.def(
      "summary_descriptions", [] { return to_python(summary_descriptions()); },
      "Descriptions in the places of summary.json's numbers.");
}

}  // namespace overbend
