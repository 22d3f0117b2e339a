#include "python/interpreter_lock.h"

#include <pybind11/pybind11.h>

namespace overbend {
namespace {

namespace py = pybind11;

/// Of this thread, while it holds the lock.
struct Hold {
  PyGILState_STATE state;
  py::object h5py;  ///< Its lock; null where it is not loaded.
};
thread_local Hold hold;

/// h5py gives the interpreter's lock away while it waits for files, but never this one.
py::object lock_of_h5py() {
  const auto objects = py::reinterpret_steal<py::object>(PyImport_GetModule(py::str("h5py._objects").ptr()));
  return objects ? py::getattr(objects, "phil", py::none()) : py::none();
}

}  // namespace

void InterpreterLock::lock() {
  hold.state = PyGILState_Ensure();
  hold.h5py = lock_of_h5py();
  if (!hold.h5py.is_none()) hold.h5py.attr("acquire")();
}

void InterpreterLock::unlock() {
  if (!hold.h5py.is_none()) hold.h5py.attr("release")();
  hold.h5py = py::object();
  PyGILState_Release(hold.state);
}

}  // namespace overbend
