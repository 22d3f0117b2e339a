/// Arrays of a netCDF-4 file, which is an HDF5 file: numbers with the names of their dimensions, and lists of words.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/file_lock.h"

namespace overbend {

/// Row by row, the last dimension fastest.
struct NetcdfArray {
  std::vector<std::string> dimensions;  ///< Names; empty for a single number.
  std::vector<std::size_t> sizes;
  std::vector<double> values;
};

/// Holds the lock of HDF5 as long as it lives.
class NetcdfFile {
 public:
  /// Throws std::runtime_error where it is no HDF5 file.
  explicit NetcdfFile(const std::string& path);
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;
  ~NetcdfFile();

  /// Nothing where there is no such variable or it holds no numbers.
  std::optional<NetcdfArray> numbers(const std::string& name) const;
  /// Words of a one-dimensional variable; empty where there is none.
  std::vector<std::string> words(const std::string& name) const;

 private:
  std::lock_guard<FileLock> hold_{hdf5_lock()};
  long long file_;
};

}  // namespace overbend
