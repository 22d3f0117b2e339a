/// Lock around a library that is not thread-safe.
#pragma once

#include <mutex>

namespace overbend {

/// Held while HDF5 reads or writes a file. Recursive: a thread may hold it several times. If other code of the process
/// uses the library as well, the embedding program derives a lock that excludes that code too.
class FileLock {
 public:
  FileLock() = default;
  virtual ~FileLock() = default;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  virtual void lock() { mutex_.lock(); }
  virtual void unlock() { mutex_.unlock(); }

 private:
  std::recursive_mutex mutex_;
};

/// Returns the lock of this process, as HDF5 is global.
FileLock& hdf5_lock();

/// Replaces the lock, before any thread holds it; `lock` must outlive its use.
void set_hdf5_lock(FileLock& lock);

}  // namespace overbend
