#include "seafiles/netcdf_classic.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "base/bit_cast.h"
#include "base/interruption.h"

namespace overbend {
namespace {

constexpr std::uint64_t kMaxHead = std::uint64_t{16} << 20U;  ///< [bytes]
constexpr std::uint64_t kNoRecord = ~std::uint64_t{0};

[[noreturn]] void reject(const std::string& why) {
  throw std::runtime_error("a damaged netCDF file: " + why);
}

/// Types of values, with the numbers used in files.
enum class Type : std::uint32_t {
  byte = 1,
  letter,
  int16,
  int32,
  float32,
  float64,
  ubyte,
  uint16,
  uint32,
  int64,
  uint64
};

std::size_t value_size(Type type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
  return kSizes[static_cast<std::size_t>(type) - 1];
}

/// Returns big-endian bytes as an unsigned number.
std::uint64_t whole(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = value << 8U | static_cast<unsigned char>(byte);
  return value;
}

double number(Type type, std::string_view bytes) {
  const std::uint64_t bits = whole(bytes);
  switch (type) {
    case Type::byte:
      return static_cast<std::int8_t>(bits);
    case Type::int16:
      return static_cast<std::int16_t>(bits);
    case Type::int32:
      return static_cast<std::int32_t>(bits);
    case Type::int64:
      return static_cast<double>(static_cast<std::int64_t>(bits));
    case Type::float32:
      return overbend::bit_cast<float>(static_cast<std::uint32_t>(bits));
    case Type::float64:
      return overbend::bit_cast<double>(bits);
    default:
      return static_cast<double>(bits);
  }
}

std::vector<double> numbers(Type type, std::string_view bytes) {
  const std::size_t size = value_size(type);
  std::vector<double> values;
  values.reserve(bytes.size() / size);
  for (std::size_t i = 0; i + size <= bytes.size(); i += size) values.push_back(number(type, bytes.substr(i, size)));
  return values;
}

struct Dimension {
  std::string name;
  std::uint64_t size = 0;  ///< 0: the record dimension.
};

/// Description of a variable in the header.
struct Described {
  std::string name;
  std::vector<std::size_t> dimensions;
  Type type = Type::byte;
  std::uint64_t begin = 0;  ///< Offset of its values in the file [bytes].
  NetcdfPacking packing;
};

struct Head {
  std::uint64_t records = 0;
  std::vector<Dimension> dimensions;
  std::vector<Described> variables;

  bool is_record_variable(const Described& described) const {
    return !described.dimensions.empty() && dimensions[described.dimensions.front()].size == 0;
  }
};

class HeadReader {
 public:
  explicit HeadReader(std::string_view bytes) : rest_(bytes) {}

  Head read() {
    if (!take(3).starts_with("CDF")) reject("it does not start with CDF");
    version_ = static_cast<unsigned>(whole(take(1)));
    if (version_ != 1 && version_ != 2 && version_ != 5) reject("its format version is " + std::to_string(version_));
    head_.records = count();
    if (head_.records == (version_ == 5 ? kNoRecord : 0xffffffffU)) head_.records = kNoRecord;
    each(kDimensions, [&] { head_.dimensions.push_back(dimension()); });
    each(kAttributes, [&] { attribute(nullptr); });
    each(kVariables, [&] { head_.variables.push_back(variable()); });
    return std::move(head_);
  }
  /// Returns the number of bytes after the header.
  std::size_t left() const { return rest_.size(); }

 private:
  static constexpr std::uint64_t kDimensions = 10, kVariables = 11, kAttributes = 12;

  std::string_view take(std::uint64_t length) {
    if (length > rest_.size()) reject("its header is truncated");
    const std::string_view bytes = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return bytes;
  }
  std::uint64_t count() { return whole(take(version_ == 5 ? 8 : 4)); }
  /// Takes `length` bytes and skips the padding to a multiple of four.
  std::string_view padded(std::uint64_t length) {
    const std::string_view bytes = take(length);
    take((4 - length % 4) % 4);
    return bytes;
  }
  std::string name() { return std::string(padded(count())); }

  /// Reads every item of a list. The tag of an empty list may be zero; an item takes at least four bytes.
  template <class Item>
  void each(std::uint64_t mark, const Item& item) {
    const std::uint64_t found = whole(take(4)), items = count();
    if (found != mark && (found != 0 || items != 0)) {
      reject("a list in its header has the tag " + std::to_string(found));
    }
    if (items > rest_.size() / 4) reject("a list in its header has " + std::to_string(items) + " items");
    for (std::uint64_t i = 0; i < items; ++i) item();
  }

  Type type() {
    const std::uint64_t found = whole(take(4));
    if (found < 1 || found > (version_ == 5 ? 11U : 6U)) reject("a value has the type " + std::to_string(found));
    return static_cast<Type>(found);
  }

  Dimension dimension() {
    Dimension dimension{name(), count()};
    return dimension;
  }

  void attribute(NetcdfPacking* packing) {
    const std::string called = name();
    const Type kind = type();
    const std::uint64_t length = count();
    if (length > rest_.size()) reject("an attribute has " + std::to_string(length) + " values");
    const std::string_view bytes = padded(length * value_size(kind));
    if (packing == nullptr || kind == Type::letter || length != 1) return;
    const double value = number(kind, bytes);
    if (called == "scale_factor") packing->scale = value;
    if (called == "add_offset") packing->offset = value;
    if (called == "_FillValue") packing->fill = value;
  }

  Described variable() {
    Described described;
    described.name = name();
    const std::uint64_t rank = count();
    if (rank > rest_.size() / 4) reject("a variable has " + std::to_string(rank) + " dimensions");
    for (std::uint64_t i = 0; i < rank; ++i) described.dimensions.push_back(dimension_number(i));
    each(kAttributes, [&] { attribute(&described.packing); });
    described.type = type();
    count();  // the stored size is redundant
    described.begin = whole(take(version_ == 1 ? 4 : 8));
    return described;
  }

  std::size_t dimension_number(std::uint64_t place) {
    const std::uint64_t number = count();
    if (number >= head_.dimensions.size()) reject("a variable has the dimension number " + std::to_string(number));
    if (head_.dimensions[number].size == 0 && place > 0) reject("records are not the first dimension of a variable");
    return static_cast<std::size_t>(number);
  }

  std::string_view rest_;
  unsigned version_ = 0;
  Head head_;
};

/// Location of the values of a variable: pieces of equal length, evenly spaced.
struct Extent {
  std::uint64_t begin = 0, piece = 0, pieces = 1, spacing = 0;  ///< [bytes]
};

class Values {
 public:
  Values(std::ifstream& file, std::uint64_t length, const Head& head) : file_(file), length_(length), head_(head) {
    std::size_t is_record_variable = 0;
    for (const Described& described : head.variables) {
      if (!head.is_record_variable(described)) continue;
      const std::uint64_t piece = record_bytes(described);
      ++is_record_variable;
      only_ = piece;
      record_ = std::min(length_ + 1, record_ + (piece + 3) / 4 * 4);
    }
    if (is_record_variable == 1) record_ = only_;  // records of a single variable are not padded
  }

  /// Rejects files in which values of variables overlap: a sign of damage that would otherwise go unnoticed.
  void require_apart(std::uint64_t head) const {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> places;  // begin and end in the first record [bytes]
    std::uint64_t first = length_, last = 0;
    for (const Described& described : head_.variables) {
      const std::uint64_t piece = record_bytes(described);
      if (piece == 0 || piece > length_ || described.begin > length_) continue;  // beyond the end of the file
      places.emplace_back(described.begin, described.begin + piece);
      if (!head_.is_record_variable(described)) continue;
      first = std::min(first, described.begin);
      last = std::max(last, described.begin + piece);
    }
    std::sort(places.begin(), places.end());
    std::uint64_t free = head;
    for (const auto& [from, to] : places) {
      if (from < free) reject("values of its variables overlap");
      free = to;
    }
    if (last > first && last - first > record_) reject("its records overlap");
  }

  NetcdfVariable read(const Described& described) {
    NetcdfVariable variable;
    const Extent extent = find_extent(described);
    NetcdfArray& array = variable.array;
    for (std::size_t k = 0; k < described.dimensions.size(); ++k) {
      const Dimension& dimension = head_.dimensions[described.dimensions[k]];
      array.dimensions.push_back(dimension.name);
      array.sizes.push_back(static_cast<std::size_t>(k == 0 && dimension.size == 0 ? extent.pieces : dimension.size));
    }
    const bool letters = described.type == Type::letter;
    variable.kind = letters ? NetcdfVariable::Kind::texts : NetcdfVariable::Kind::numbers;
    if (!fits(extent)) {
      variable.error = "lies beyond the end of the file";
    } else if (!count_values(array.sizes)) {
      variable.error = "has too many values";
    } else if (letters) {
      variable.texts = split_texts(read_bytes(extent), array.sizes.empty() ? 1 : array.sizes.back());
    } else {
      array.values = numbers(described.type, read_bytes(extent));
      unpack(array.values, described.packing);
    }
    return variable;
  }

 private:
  /// Returns the bytes of a variable, or of one record of it; more than the file has if the sizes are inconsistent.
  std::uint64_t record_bytes(const Described& described) const {
    std::uint64_t piece = value_size(described.type);
    for (std::size_t k = head_.is_record_variable(described) ? 1 : 0; k < described.dimensions.size(); ++k) {
      const std::uint64_t size = head_.dimensions[described.dimensions[k]].size;
      if (size > length_ || (piece *= size) > length_) return length_ + 1;
    }
    return piece;
  }

  Extent find_extent(const Described& described) const {
    Extent extent{described.begin, record_bytes(described)};
    if (!head_.is_record_variable(described)) return extent;
    extent.spacing = record_;
    extent.pieces = head_.records;
    if (head_.records == kNoRecord) {  // streamed file: the number of records is unknown
      extent.pieces =
          record_ > 0 && described.begin < length_ ? (length_ - described.begin + record_ - extent.piece) / record_ : 0;
    }
    return extent;
  }

  bool fits(const Extent& extent) const {
    if (extent.pieces == 0) return true;
    if (extent.begin > length_ || extent.piece > length_ - extent.begin) return false;
    const std::uint64_t room = length_ - extent.begin - extent.piece;
    return extent.pieces == 1 || (extent.spacing > 0 && extent.pieces - 1 <= room / extent.spacing);
  }

  std::string read_bytes(const Extent& extent) {
    std::string bytes(static_cast<std::size_t>(extent.piece * extent.pieces), '\0');
    for (std::uint64_t i = 0; i < extent.pieces; ++i) {
      check_interruption();
      file_.seekg(static_cast<std::streamoff>(extent.begin + i * extent.spacing));
      file_.read(bytes.data() + i * extent.piece, static_cast<std::streamsize>(extent.piece));
    }
    if (!file_) throw std::runtime_error("a file that cannot be read to its end");
    return bytes;
  }

  std::ifstream& file_;
  std::uint64_t length_;
  const Head& head_;
  std::uint64_t only_ = 0,
                record_ = 0;  ///< Length of a record: of the only record variable, and padded over all [bytes].
};

}  // namespace

NetcdfContents read_netcdf_classic(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw std::runtime_error("a file that cannot be read");
  const auto length = static_cast<std::uint64_t>(file.tellg());
  std::string bytes(static_cast<std::size_t>(std::min(length, kMaxHead)), '\0');
  file.seekg(0);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file) throw std::runtime_error("a file that cannot be read");
  HeadReader reader(bytes);
  const Head head = reader.read();
  Values values(file, length, head);
  values.require_apart(bytes.size() - reader.left());
  NetcdfContents contents;
  for (const Described& described : head.variables) {
    if (!contents.emplace(described.name, values.read(described)).second) {
      reject("it has two variables '" + described.name + "'");
    }
  }
  return contents;
}

}  // namespace overbend
