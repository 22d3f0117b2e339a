#include "seafiles/netcdf_arrays.h"

#include <array>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "base/text.h"
#include "seafiles/netcdf_classic.h"
#include "seafiles/netcdf_hdf5.h"

namespace overbend {
namespace {

/// Returns the first four bytes, or fewer for a shorter file.
std::string read_head(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 4> head{};
  if (!file) throw std::runtime_error("a file that cannot be read");
  file.read(head.data(), head.size());
  return {head.data(), static_cast<std::size_t>(file.gcount())};
}

NetcdfContents read_contents(const std::string& path) {
  const std::string head = read_head(path);
  return head.starts_with("CDF") ? read_netcdf_classic(path) : read_netcdf_hdf5(path);
}

}  // namespace

std::optional<std::size_t> count_values(const std::vector<std::size_t>& sizes) {
  std::size_t count = 1;
  for (const std::size_t size : sizes) {
    if (size > kMaxNetcdfValues) return std::nullopt;
    count *= size;
    if (count > kMaxNetcdfValues) return std::nullopt;
  }
  return count;
}

void unpack(std::vector<double>& values, const NetcdfPacking& packing) {
  const double scale = packing.scale.value_or(1.0), offset = packing.offset.value_or(0.0);
  const bool packed = packing.scale || packing.offset;
  for (double& value : values) {
    if (packing.fill && value == *packing.fill) {
      value = std::numeric_limits<double>::quiet_NaN();
    } else if (packed) {
      value = scale * value + offset;
    }
  }
}

std::vector<std::string> split_texts(const std::string& letters, std::size_t length) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; length > 0 && i + length <= letters.size(); i += length) {
    const std::string_view word = std::string_view(letters).substr(i, length);
    texts.emplace_back(trim(word.substr(0, word.find('\0'))));
  }
  return texts;
}

NetcdfFile::NetcdfFile(const std::string& path) : contents_(read_contents(path)) {}

const NetcdfVariable* NetcdfFile::find(const std::string& name) const {
  const auto found = contents_.find(name);
  if (found == contents_.end()) return nullptr;
  if (!found->second.error.empty()) throw std::runtime_error("a variable " + name + " that " + found->second.error);
  return &found->second;
}

std::optional<NetcdfArray> NetcdfFile::numbers(const std::string& name) const {
  const NetcdfVariable* variable = find(name);
  if (variable == nullptr || variable->kind != NetcdfVariable::Kind::numbers) return std::nullopt;
  return variable->array;
}

std::vector<std::string> NetcdfFile::texts(const std::string& name) const {
  const NetcdfVariable* variable = find(name);
  return variable == nullptr ? std::vector<std::string>() : variable->texts;
}

}  // namespace overbend
