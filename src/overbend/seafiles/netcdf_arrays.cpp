#include "seafiles/netcdf_arrays.h"

#include <hdf5.h>
#include <hdf5_hl.h>

#include <stdexcept>

namespace overbend {
namespace {

/// A handle of the library that closes itself.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) {
      close_(id_);
    }
  }
  explicit operator bool() const { return id_ >= 0; }
  hid_t get() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

Handle open_variable(long long file, const std::string& name) {
  const bool there = H5Lexists(file, name.c_str(), H5P_DEFAULT) > 0;
  return {there ? H5Dopen2(file, name.c_str(), H5P_DEFAULT) : -1, H5Dclose};
}

std::vector<std::size_t> sizes_of(hid_t variable) {
  const Handle space(H5Dget_space(variable), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.get());
  std::vector<hsize_t> sizes(rank > 0 ? static_cast<std::size_t>(rank) : 0);
  if (rank > 0) {
    H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr);
  }
  return {sizes.begin(), sizes.end()};
}

std::size_t count_of(const std::vector<std::size_t>& sizes) {
  std::size_t count = 1;
  for (const std::size_t size : sizes) {
    count *= size;
  }
  return count;
}

/// Keeps the name of the scale of a dimension, without the leading slash.
herr_t keep_scale_name(hid_t, unsigned, hid_t scale, void* name) {
  char text[256] = {};
  if (H5Iget_name(scale, text, sizeof text) > 0) {
    *static_cast<std::string*>(name) = text[0] == '/' ? text + 1 : text;
  }
  return 1;
}

std::string dimension_name(hid_t variable, unsigned dimension) {
  std::string name;
  if (H5DSget_num_scales(variable, dimension) > 0) {
    H5DSiterate_scales(variable, dimension, nullptr, keep_scale_name, &name);
  }
  return name;
}

/// Words of fixed length, one after the other in `bytes`.
std::vector<std::string> split_words(const std::string& bytes, std::size_t length) {
  std::vector<std::string> words;
  for (std::size_t at = 0; length > 0 && at + length <= bytes.size(); at += length) {
    words.emplace_back(bytes.substr(at, length).c_str());  // up to the first zero
  }
  return words;
}

}  // namespace

NetcdfFile::NetcdfFile(const std::string& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // the library would print its own stack of errors
  file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file_ < 0) {
    throw std::runtime_error("no netCDF-4 file");
  }
}

NetcdfFile::~NetcdfFile() {
  H5Fclose(file_);
}

std::optional<NetcdfArray> NetcdfFile::numbers(const std::string& name) const {
  const Handle variable = open_variable(file_, name);
  if (!variable) {
    return std::nullopt;
  }
  const Handle type(H5Dget_type(variable.get()), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type.get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) {
    return std::nullopt;
  }
  NetcdfArray array;
  array.sizes = sizes_of(variable.get());
  for (unsigned k = 0; k < array.sizes.size(); ++k) {
    array.dimensions.push_back(dimension_name(variable.get(), k));
  }
  array.values.resize(count_of(array.sizes));
  if (H5Dread(variable.get(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) < 0) {
    return std::nullopt;
  }
  return array;
}

std::vector<std::string> NetcdfFile::words(const std::string& name) const {
  const Handle variable = open_variable(file_, name);
  if (!variable) {
    return {};
  }
  const Handle type(H5Dget_type(variable.get()), H5Tclose);
  if (H5Tget_class(type.get()) != H5T_STRING) {
    return {};
  }
  const std::size_t count = count_of(sizes_of(variable.get()));
  if (H5Tis_variable_str(type.get()) <= 0) {
    const std::size_t length = H5Tget_size(type.get());
    std::string bytes(count * length, '\0');
    H5Dread(variable.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
    // Single letters are the netCDF of words with a second dimension of letters.
    const std::vector<std::size_t> sizes = sizes_of(variable.get());
    return split_words(bytes, length == 1 && sizes.size() == 2 ? sizes[1] : length);
  }
  std::vector<char*> texts(count, nullptr);
  if (H5Dread(variable.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()) < 0) {
    return {};
  }
  std::vector<std::string> words;
  for (const char* text : texts) {
    words.emplace_back(text == nullptr ? "" : text);
  }
  const Handle space(H5Dget_space(variable.get()), H5Sclose);
  H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, texts.data());
  return words;
}

}  // namespace overbend
