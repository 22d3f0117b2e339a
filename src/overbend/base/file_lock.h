/// The lock around a library that serves one thread alone.
#pragma once

#include <mutex>

namespace overbend {

/// Held while HDF5 reads or writes a file. A thread may hold it several times. Where other code of the process uses
/// that library as well, whoever runs us derives a lock that keeps that code away too.
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

/// The one of this process, as HDF5 is.
FileLock& hdf5_lock();

/// Puts another in its place, before any thread holds it: one that lives as long as it is there.
void set_hdf5_lock(FileLock& lock);

}  // namespace overbend
