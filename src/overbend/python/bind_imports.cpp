// Import of OrcaFlex files.
#include <optional>
#include <string>

#include <pybind11/stl.h>

#include "orcaflex/import_orcaflex.h"
#include "python/bindings.h"
#include "python/model_handle.h"

namespace overbend {
namespace py = pybind11;
namespace {

/// Text of the model and account of a file.
py::tuple import_file(const std::string& file, const std::string& folder, std::optional<double> yield_stress) {
  orcaflex::ImportOptions options;
  options.model_folder = folder;
  options.yield_stress = yield_stress;
  Diagnostics diagnostics;
  const std::optional<orcaflex::ImportedModel> model = orcaflex::import_orcaflex(file, options, diagnostics);
  if (!model) throw UnreadableModel(std::move(diagnostics));
  py::list left_out;
  for (const orcaflex::Account::Omission& omission : model->account.left_out) {
    left_out.append(py::make_tuple(omission.text, omission.matters));
  }
  return py::make_tuple(model->text, model->account.translated, model->account.approximated, left_out);
}

}  // namespace

void add_imports(py::module_& module) {
  module.def("import_orcaflex", &import_file, py::arg("file"), py::arg("folder"), py::arg("yield_stress"),
             "Returns model text, what was translated, what was approximated, and what was left out, with whether it\n"
             "matters. Raises ModelError.");
}

}  // namespace overbend
