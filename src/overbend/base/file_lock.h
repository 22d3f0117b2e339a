/// The lock around libraries that serve one thread alone.
#pragma once

#include <mutex>

namespace overbend {

/// Held while files of results are read or written, for HDF5 serves one thread alone. Where other code of the process
/// uses that library as well, whoever runs us derives a lock that keeps that code away too.
class FileLock {
 public:
  FileLock() = default;
  virtual ~FileLock() = default;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  virtual void lock() { mutex_.lock(); }
  virtual void unlock() { mutex_.unlock(); }

 private:
  std::mutex mutex_;
};

}  // namespace overbend
