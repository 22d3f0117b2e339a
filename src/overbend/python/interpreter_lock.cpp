#include "python/interpreter_lock.h"

#include <pybind11/pybind11.h>

#include <vector>

namespace overbend {
namespace {

namespace py = pybind11;

struct Hold {
  PyGILState_STATE state;
  py::object h5py;  ///< Lock of h5py; None if it is not loaded.
};
thread_local std::vector<Hold> holds;  ///< Nested locks of this thread.

/// Returns the lock of h5py, which h5py holds even while it releases the GIL.
py::object lock_of_h5py() {
  const auto objects = py::reinterpret_steal<py::object>(PyImport_GetModule(py::str("h5py._objects").ptr()));
  if (!objects) return py::none();
  return py::getattr(objects, "phil", py::none());
}

}  // namespace

void InterpreterLock::lock() {
  const PyGILState_STATE state = PyGILState_Ensure();
  holds.push_back({state, lock_of_h5py()});
  if (!holds.back().h5py.is_none()) holds.back().h5py.attr("acquire")();
}

void InterpreterLock::unlock() {
  const PyGILState_STATE state = holds.back().state;
  if (!holds.back().h5py.is_none()) holds.back().h5py.attr("release")();
  holds.pop_back();
  PyGILState_Release(state);
}

}  // namespace overbend
