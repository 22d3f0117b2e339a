/// Arrays of a netCDF file, classic or netCDF-4 (which is HDF5): numbers with the names of their dimensions, and lists
/// of words.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// Row by row, the last dimension fastest.
struct NetcdfArray {
  std::vector<std::string> dimensions;  ///< Names; empty for a single number.
  std::vector<std::size_t> sizes;
  std::vector<double> values;
};

/// A variable as it was read: numbers, or words, or what is neither.
struct NetcdfVariable {
  enum class Kind { numbers, words, other };
  Kind kind = Kind::other;
  NetcdfArray array;  ///< Of words without values.
  std::vector<std::string> words;
  std::string fault;  ///< Why its values could not be read; empty where they could.
};

using NetcdfContents = std::map<std::string, NetcdfVariable>;

/// More values than any variable that is needed has.
inline constexpr std::size_t kMaxNetcdfValues = std::size_t{1} << 26U;

/// The number of values; nothing where there are more than kMaxNetcdfValues.
std::optional<std::size_t> count_values(const std::vector<std::size_t>& sizes);

/// Numbers as they are meant by the attributes scale_factor, add_offset and _FillValue (which becomes NaN).
struct NetcdfPacking {
  std::optional<double> scale, offset, fill;
};
void unpack(std::vector<double>& values, const NetcdfPacking& packing);

/// Words of `length` letters one after the other; each ends at its first zero.
std::vector<std::string> split_words(const std::string& letters, std::size_t length);

/// A file whose variables were all read.
class NetcdfFile {
 public:
  /// Throws std::runtime_error where it cannot be read.
  explicit NetcdfFile(const std::string& path);

  bool has(const std::string& name) const { return contents_.contains(name); }
  /// Nothing where there is no such variable or it holds no real numbers. Throws std::runtime_error where it is
  /// damaged.
  std::optional<NetcdfArray> numbers(const std::string& name) const;
  /// Words of a one-dimensional variable; empty where there is none. Throws likewise.
  std::vector<std::string> words(const std::string& name) const;

 private:
  const NetcdfVariable* find(const std::string& name) const;

  NetcdfContents contents_;
};

}  // namespace overbend
