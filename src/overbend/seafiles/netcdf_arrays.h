/// Arrays of a netCDF file, classic or netCDF-4 (HDF5): numbers with named dimensions, and lists of text.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// Values in row-major order: the last dimension varies fastest.
struct NetcdfArray {
  std::vector<std::string> dimensions;  ///< Names; empty for a single number.
  std::vector<std::size_t> sizes;
  std::vector<double> values;
};

/// A variable as read: numbers, text or another type.
struct NetcdfVariable {
  enum class Kind { numbers, texts, other };
  Kind kind = Kind::other;
  NetcdfArray array;  ///< Without values for text.
  std::vector<std::string> texts;
  std::string error;  ///< Reason why the values could not be read; empty if they were read.
};

using NetcdfContents = std::map<std::string, NetcdfVariable>;

/// Maximum number of values of a variable, far above what is needed.
inline constexpr std::size_t kMaxNetcdfValues = std::size_t{1} << 26U;

/// Returns the number of values; nothing if there are more than kMaxNetcdfValues.
std::optional<std::size_t> count_values(const std::vector<std::size_t>& sizes);

/// Attributes scale_factor, add_offset and _FillValue.
struct NetcdfPacking {
  std::optional<double> scale, offset, fill;
};
/// Applies scale and offset to `values`; the fill value becomes NaN.
void unpack(std::vector<double>& values, const NetcdfPacking& packing);

/// Splits consecutive texts of `length` characters; each ends at its first null character.
std::vector<std::string> split_texts(const std::string& letters, std::size_t length);

/// A file with all its variables in memory.
class NetcdfFile {
 public:
  /// Throws std::runtime_error if the file cannot be read.
  explicit NetcdfFile(const std::string& path);

  /// True if a variable of this name exists; those in groups of an HDF5 file are named "body1/properties/cg".
  bool has(const std::string& name) const { return contents_.contains(name); }
  /// Returns a variable of real numbers; nothing if there is none. Throws std::runtime_error if it is damaged.
  std::optional<NetcdfArray> numbers(const std::string& name) const;
  /// Returns the texts of a one-dimensional variable; empty if there is none. Throws std::runtime_error if it is
  /// damaged.
  std::vector<std::string> texts(const std::string& name) const;

 private:
  const NetcdfVariable* find(const std::string& name) const;

  NetcdfContents contents_;
};

}  // namespace overbend
