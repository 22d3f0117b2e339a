/// The lock around files of results within Python.
#pragma once

#include "base/file_lock.h"

namespace overbend {

/// Holds the interpreter's lock, and that of h5py where it is loaded: the same HDF5 library serves it and us, one
/// thread at a time. A thread holds it once at a time, whether it has the interpreter's lock already or not.
class InterpreterLock : public FileLock {
 public:
  void lock() override;
  void unlock() override;
};

}  // namespace overbend
