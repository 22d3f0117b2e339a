#include "base/file_lock.h"

namespace overbend {
namespace {

FileLock*& present_lock() {
  static FileLock default_lock;
  static FileLock* lock = &default_lock;
  return lock;
}

}  // namespace

FileLock& hdf5_lock() {
  return *present_lock();
}

void set_hdf5_lock(FileLock& lock) {
  present_lock() = &lock;
}

}  // namespace overbend
