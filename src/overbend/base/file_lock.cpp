#include "base/file_lock.h"

namespace overbend {
namespace {

FileLock*& present_lock() {
  static FileLock own;
  static FileLock* lock = &own;
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
