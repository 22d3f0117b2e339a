#include "python/python_errors.h"

#include <pybind11/pybind11.h>

#include "base/utf8.h"
#include "modelfile/yaml/yaml_edit.h"
#include "python/bindings.h"
#include "python/model_handle.h"
#include "runstore/staged_folder.h"
#include "study/goal_seek/seek_model.h"

namespace overbend {
namespace {

namespace py = pybind11;

py::str python_text(const std::string& text) {
  return py::str(valid_utf8(text));
}

py::object python_text(py::object other) {
  return other;
}

/// Sets the exception overbend.errors.<name>(arguments...).
template <class... Arguments>
void set_error(const char* name, Arguments&&... arguments) {
  const py::object type = py::module_::import("overbend.errors").attr(name);
  const py::object error = type(python_text(std::forward<Arguments>(arguments))...);
  PyErr_SetObject(type.ptr(), error.ptr());
}

py::dict fault_of(const Diagnostic& found) {
  py::dict fault;
  fault["message"] = render(found);
  fault["file"] = found.file;
  fault["line"] = found.line;
  fault["column"] = found.column;
  fault["key"] = found.key;
  fault["found"] = found.found;
  fault["expected"] = found.expected;
  fault["hint"] = found.hint;
  return fault;
}

void set_model_error(const Diagnostics& diagnostics) {
  py::list faults;
  for (const Diagnostic& found : diagnostics.sorted()) {
    if (found.severity == Severity::error) faults.append(fault_of(found));
  }
  set_error("ModelError", py::none(), faults);
}

void set_failure(const StaticFailure& failure) {
  if (failure.input) return set_error("ModelError", failure.what + (failure.why.empty() ? "" : ": " + failure.why));
  set_error("NoSolution", failure.what, failure.where, failure.why);
}

void set_ending(const RunEnd& end) {
  switch (end.ending) {
    case RunEnding::wrong_input:
      return set_error("ModelError", end.why);
    case RunEnding::no_solution:
      return set_error("NoSolution", end.why);
    default:
      return set_error("ResultsError", end.why);
  }
}

/// Sets the exception of Python that belongs to a fault of the engine; throws on what belongs to none.
void translate(std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param): pybind11 gives the type
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const UnreadableModel& fault) {
    set_model_error(fault.diagnostics());
  } catch (const SolveFault& fault) {
    set_failure(fault.failure());
  } catch (const EndedRun& fault) {
    set_ending(fault.end());
  } catch (const YamlEditFault& fault) {
    set_error("ModelError", fault.what());
  } catch (const SeekFault& fault) {
    set_error("ModelError", fault.what());
  } catch (const UnusableFolder& fault) {
    set_error("ResultsError", fault.what());
  } catch (const FileFault& fault) {
    set_error("ResultsError", fault.what());
  } catch (const std::invalid_argument& fault) {
    set_error("ModelError", fault.what());
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const py::error_already_set&) {
    throw;
  } catch (const std::exception& fault) {  // pybind11 has an exception for it, but takes its text for UTF-8
    if (valid_utf8(fault.what()) == fault.what()) throw;
    PyErr_SetString(PyExc_RuntimeError, valid_utf8(fault.what()).c_str());
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
