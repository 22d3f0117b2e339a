#include "seafiles/netcdf_bytes.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace overbend {
namespace {

class Writer {
 public:
  void put(std::uint64_t value) { raw(&value, sizeof value); }
  void put(const std::string& text) {
    put(text.size());
    raw(text.data(), text.size());
  }
  template <class Item>
  void put(const std::vector<Item>& items) {
    put(items.size());
    if constexpr (std::is_arithmetic_v<Item>) {
      raw(items.data(), items.size() * sizeof(Item));
    } else {
      for (const Item& item : items) put(item);
    }
  }
  std::string take() { return std::move(bytes_); }

 private:
  void raw(const void* data, std::size_t length) { bytes_.append(static_cast<const char*>(data), length); }

  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  bool at_end() const { return rest_.empty(); }
  std::uint64_t number() {
    std::uint64_t value = 0;
    std::memcpy(&value, raw(sizeof value), sizeof value);
    return value;
  }
  std::string text() {
    const std::uint64_t length = number();
    return {raw(length), static_cast<std::size_t>(length)};
  }
  template <class Item>
  std::vector<Item> numbers() {
    const std::uint64_t count = number();
    if (count > rest_.size() / sizeof(Item)) reject();
    std::vector<Item> items(static_cast<std::size_t>(count));
    if (count > 0) std::memcpy(items.data(), raw(count * sizeof(Item)), items.size() * sizeof(Item));
    return items;
  }
  std::vector<std::string> texts() {
    std::vector<std::string> items;
    for (std::uint64_t count = number(); count > 0; --count) items.push_back(text());
    return items;
  }
  [[noreturn]] static void reject() {
    throw std::runtime_error("a damaged netCDF-4 file: its contents are inconsistent");
  }

 private:
  const char* raw(std::uint64_t length) {
    if (length > rest_.size()) reject();
    const char* data = rest_.data();
    rest_.remove_prefix(static_cast<std::size_t>(length));
    return data;
  }

  std::string_view rest_;
};

/// True if the number of values matches the sizes, as every user of the array assumes.
bool is_valid_tree(const NetcdfVariable& variable) {
  if (variable.kind != NetcdfVariable::Kind::numbers || !variable.error.empty()) return true;
  const NetcdfArray& array = variable.array;
  return array.dimensions.size() == array.sizes.size() && count_values(array.sizes) == array.values.size();
}

}  // namespace

std::string serialise_contents(const NetcdfContents& contents) {
  Writer out;
  for (const auto& [name, variable] : contents) {
    out.put(name);
    out.put(static_cast<std::uint64_t>(variable.kind));
    out.put(variable.array.dimensions);
    out.put(variable.array.sizes);
    out.put(variable.array.values);
    out.put(variable.texts);
    out.put(variable.error);
  }
  return out.take();
}

NetcdfContents parse_contents(std::string_view bytes) {
  Reader in(bytes);
  NetcdfContents contents;
  while (!in.at_end()) {
    const std::string name = in.text();
    NetcdfVariable variable;
    const std::uint64_t kind = in.number();
    if (kind > static_cast<std::uint64_t>(NetcdfVariable::Kind::other)) Reader::reject();
    variable.kind = static_cast<NetcdfVariable::Kind>(kind);
    variable.array.dimensions = in.texts();
    variable.array.sizes = in.numbers<std::size_t>();
    variable.array.values = in.numbers<double>();
    variable.texts = in.texts();
    variable.error = in.text();
    if (!is_valid_tree(variable)) Reader::reject();
    contents.insert_or_assign(name, std::move(variable));
  }
  return contents;
}

}  // namespace overbend
