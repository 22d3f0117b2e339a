/// Lock for HDF5 within Python.
#pragma once

#include "base/file_lock.h"

namespace overbend {

/// Holds the GIL, and the lock of h5py if it is loaded, because h5py uses the same HDF5 library, which is not
/// thread-safe. May be locked by a thread that already holds the GIL.
class InterpreterLock : public FileLock {
 public:
  void lock() override;
  void unlock() override;
};

}  // namespace overbend
