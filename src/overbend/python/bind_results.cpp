// Datasets in memory and in results files, with the same interface in Python: names(group), dataset(path).
#include <pybind11/stl.h>

#include <algorithm>

#include "base/ranges.h"
#include "base/utf8.h"
#include "modelfile/yaml/yaml_edit.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/python_errors.h"
#include "python/to_python.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "resultfiles/hdf5/result_tree.h"
#include "resultfiles/summary/lift_units.h"
#include "resultfiles/summary/named_dynamics.h"
#include "resultfiles/summary/named_results.h"
#include "resultfiles/summary/result_objects.h"
#include "resultfiles/summary/result_units.h"

namespace overbend {
namespace {

namespace py = pybind11;

/// Returns the members of a group in the order of the text tables; names of groups end with '/'.
std::vector<std::string> names_in(const ResultTree& tree, std::string group) {
  if (!group.ends_with('/')) group += '/';
  std::vector<std::string> names;
  for (const std::string& path : tree.order) {
    if (!path.starts_with(group)) continue;
    const std::string below = path.substr(group.size());
    const std::size_t slash = below.find('/');
    const std::string name = slash == std::string::npos ? below : below.substr(0, slash + 1);
    if (ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

using GivenTree = Given<ResultTree>;

py::tuple find_dataset(const GivenTree& tree, const std::string& path) {
  const auto found = tree->datasets.find(path);
  if (found == tree->datasets.end()) throw py::key_error(valid_utf8(path));
  return dataset_tuple(found->second, py::cast(tree.shared()));
}

/// An open results file; datasets are read on request. Read errors are a ResultsError.
class ResultFile {
 public:
  explicit ResultFile(const std::string& path)
      : file_(reading_results([&] { return std::make_unique<Hdf5Reader>(path); })) {}

  std::vector<std::string> names(const std::string& group) const {
    return reading_results(
        [&] { return file_->has(group) || group == "/" ? file_->names(group) : std::vector<std::string>(); });
  }
  bool has(const std::string& path) const {
    return reading_results([&] { return file_->has(path); });
  }
  py::tuple dataset(const std::string& path) const {
    if (!has(path)) throw py::key_error(valid_utf8(path));
    auto held = reading_results([&] { return std::make_unique<Dataset>(file_->whole(path)); });
    const Dataset& set = *held;
    const py::capsule owner(held.release(), [](void* pointer) { delete static_cast<Dataset*>(pointer); });
    return dataset_tuple(set, owner);
  }
  /// Returns `count` rows of the first dimension starting at `first`.
  py::array_t<double> lines(const std::string& path, Extent first, Extent count) const {
    const Extent last = extent(path);
    if (first > last || count > last - first) {
      throw py::index_error(valid_utf8(path) + " has " + std::to_string(last) + " rows, found a request for " +
                            std::to_string(count) + " from " + std::to_string(first));
    }
    auto read =
        reading_results([&] { return std::make_unique<std::vector<double>>(file_->doubles(path, first, count)); });
    const std::vector<double>& values = *read;
    const py::capsule owner(read.release(), [](void* pointer) { delete static_cast<std::vector<double>*>(pointer); });
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data(), owner);
  }
  Extent extent(const std::string& path) const {
    if (!has(path)) throw py::key_error(valid_utf8(path));
    return reading_results([&] { return file_->lines(path); });
  }

 private:
  std::unique_ptr<Hdf5Reader> file_;
};

using GivenFile = Given<ResultFile>;

/// Returns values, unit, and true if the name denotes a single value.
py::tuple find_named_values(const std::string& summary, const std::string& name) {
  const Json json = read_json(summary);
  const ResultName parsed = parsed_result_name(name);
  const std::string unit = dynamic_result_unit(name).value_or("1");
  const bool many = parsed.function == ResultFunction::none && name.find('[') != std::string::npos;
  if (many) {
    const std::vector<double> values = named_values(json, parsed.path);
    const bool chosen = name.find_first_of("*?") != std::string::npos || name.find("..") != std::string::npos;
    return py::make_tuple(values, unit, !chosen && values.size() == 1);
  }
  const std::optional<double> value = named_result(json, name);
  return py::make_tuple(value ? std::vector<double>{*value} : std::vector<double>(), unit, true);
}

}  // namespace

void add_results(py::module_& module) {
  py::class_<ResultTree, std::shared_ptr<ResultTree>>(module, "ResultTree", "Datasets in memory by path.")
      .def(
          "names", [](const GivenTree& tree, const std::string& group) { return names_in(*tree, group); },
          py::arg("group"), "Returns the members of a group; names of groups end with '/'.")
      .def(
          "has", [](const GivenTree& tree, const std::string& path) { return tree->datasets.contains(path); },
          py::arg("path"))
      .def("dataset", &find_dataset, py::arg("path"),
           "Returns (values, units, description, frame, scales) of a dataset.");
  py::class_<ResultFile, std::shared_ptr<ResultFile>>(module, "ResultFile", "results.h5, read on request.")
      .def(py::init<const std::string&>(), py::arg("path"))
      .def(
          "names", [](const GivenFile& file, const std::string& group) { return file->names(group); }, py::arg("group"),
          "Returns the members of a group; names of groups end with '/'.")
      .def(
          "has", [](const GivenFile& file, const std::string& path) { return file->has(path); }, py::arg("path"))
      .def(
          "dataset", [](const GivenFile& file, const std::string& path) { return file->dataset(path); },
          py::arg("path"), "Returns (values, units, description, frame, scales).")
      .def(
          "lines",
          [](const GivenFile& file, const std::string& path, Extent first, Extent count) {
            return file->lines(path, first, count);
          },
          py::arg("path"), py::arg("first"), py::arg("count"),
          "Returns the numbers of `count` rows of the first dimension, flattened.")
      .def(
          "extent", [](const GivenFile& file, const std::string& path) { return file->extent(path); }, py::arg("path"),
          "Returns the number of rows of the first dimension.");
  module.def(
      "named_values", &find_named_values, py::arg("summary"), py::arg("name"),
      "Returns the values of a named result in the text of a summary.json, their unit, and True for a single value.");
  module.def("result_paths", &dynamic_result_paths, "Returns the names of all results.");
  module.def("flow_scalar", &yaml_scalar, py::arg("text"), "Returns a text as a scalar in YAML flow style.");
  module.def(
      "summary_units", [] { return to_python(stored_summary_units()); },
      "Returns a tree like summary.json with units in place of numbers.");
  module.def(
      "summary_descriptions", [] { return to_python(summary_descriptions()); },
      "Returns a tree like summary.json with descriptions in place of numbers.");
  module.def(
      "lift_units", [] { return to_python(stored_lift_stage_units()); },
      "Returns a tree like a stage of a lift with units in place of numbers; lines and davits under '*'.");
  module.def(
      "lift_descriptions", [] { return to_python(lift_stage_descriptions()); }, "The same with descriptions.");
  module.def(
      "object_units", [] { return to_python(result_objects(stored_summary_units())); },
      "Returns a tree like the results by object with units in place of numbers; lines by kind, supports under '*'.");
  module.def(
      "object_descriptions", [] { return to_python(result_objects(summary_descriptions())); },
      "The same with descriptions.");
}

}  // namespace overbend
