#include "python/python_errors.h"

#include <pybind11/pybind11.h>

#include "base/utf8.h"
#include "modelfile/yaml/yaml_edit.h"
#include "python/bindings.h"
#include "python/model_handle.h"
#include "runstore/append_file.h"
#include "runstore/staged_folder.h"
#include "study/goal_seek/seek_model.h"

namespace overbend {
namespace {

namespace py = pybind11;

py::str python_text(const std::string& text) {
  return py::str(valid_utf8(text));
}

py::object python_text(py::object object) {
  return object;
}

/// Sets the exception overbend.errors.<name>(arguments...).
template <class... Arguments>
void set_error(const char* name, Arguments&&... arguments) {
  const py::object type = py::module_::import("overbend.errors").attr(name);
  const py::object error = type(python_text(std::forward<Arguments>(arguments))...);
  PyErr_SetObject(type.ptr(), error.ptr());
}

py::dict diagnostic_dict(const Diagnostic& found) {
  py::dict entry;
  entry["message"] = render(found);
  entry["file"] = found.file;
  entry["line"] = found.line;
  entry["column"] = found.column;
  entry["key"] = found.key;
  entry["found"] = found.found;
  entry["expected"] = found.expected;
  entry["hint"] = found.hint;
  return entry;
}

void set_model_error(const Diagnostics& diagnostics) {
  py::list errors;
  for (const Diagnostic& found : diagnostics.sorted()) {
    if (found.severity == Severity::error) errors.append(diagnostic_dict(found));
  }
  set_error("ModelError", py::none(), errors);
}

void set_failure(const StaticFailure& failure) {
  if (failure.input) return set_error("ModelError", failure.what + (failure.why.empty() ? "" : ": " + failure.why));
  set_error("NoSolution", failure.what, failure.where, failure.why);
}

void set_ending(const RunResult& end) {
  switch (end.ending) {
    case RunStatus::wrong_input:
      return set_error("ModelError", end.why);
    case RunStatus::no_solution:
      return set_error("NoSolution", end.why);
    default:
      return set_error("ResultsError", end.why);
  }
}

/// Sets the Python exception for a C++ exception of the engine; rethrows others.
void translate(
    std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param): signature required by pybind11
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const UnreadableModel& error) {
    set_model_error(error.diagnostics());
  } catch (const SolveError& error) {
    set_failure(error.failure());
  } catch (const EndedRun& error) {
    set_ending(error.end());
  } catch (const YamlEditError& error) {
    set_error("ModelError", error.what());
  } catch (const SeekError& error) {
    set_error("ModelError", error.what());
  } catch (const UnusableFolder& error) {
    set_error("ResultsError", error.what());
  } catch (const FileError& error) {
    set_error("ResultsError", error.what());
  } catch (const std::invalid_argument& error) {
    set_error("ModelError", error.what());
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const py::error_already_set&) {
    throw;
  } catch (const std::exception& error) {  // pybind11 translates it, but assumes that its text is UTF-8
    if (valid_utf8(error.what()) == error.what()) throw;
    PyErr_SetString(PyExc_RuntimeError, valid_utf8(error.what()).c_str());
  }
}

}  // namespace

void raise_results_error(const std::string& sentence) {
  set_error("ResultsError", sentence);
  throw py::error_already_set();
}

void raise_controller_error(const std::string& what, const std::string& where, const std::string& why) {
  set_error("ControllerError", what, where, why);
  throw py::error_already_set();
}

void add_errors(py::module_& /*module*/) {
  py::register_exception_translator(translate);
}

}  // namespace overbend
