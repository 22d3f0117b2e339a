#include "resultfiles/hdf5/hdf5_file.h"

#include <hdf5_hl.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <system_error>
#include <type_traits>

#include "base/interruption.h"
#include "resultfiles/hdf5/hdf5_driver.h"
#include "resultfiles/hdf5/missing_values.h"
#include "runstore/append_file.h"
#include "runstore/file_seal.h"

namespace overbend {
namespace {

constexpr unsigned kCompression = 4;  // deflate level: a higher one is slower with little gain

// The library's types are looked up at first use and cannot be constants.
template <class Number>
hid_t memory_type() {
  return std::is_same_v<Number, int> ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE;
}
template <class Number>
hid_t file_type() {
  return std::is_same_v<Number, int> ? H5T_STD_I32LE : H5T_IEEE_F64LE;
}

void require(herr_t code, const std::string& what) {
  if (code < 0) throw std::runtime_error(what);
}

/// Without this the library prints its error stack and loads plugins that a file names.
void set_up_library() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);
}

/// Buffer for type conversion, no larger than needed. HDF5 otherwise clears a megabyte for each dataset of text, a
/// considerable part of the time for small files.
hid_t small_buffer(std::size_t count) {
  constexpr std::size_t kMaxValueSize = 64, kMinBufferSize = 4096, kDefaultBufferSize = 1U << 20U;  // [bytes]
  const hid_t list = H5Pcreate(H5P_DATASET_XFER);
  if (list >= 0) {
    H5Pset_buffer(list, std::clamp(count * kMaxValueSize, kMinBufferSize, kDefaultBufferSize), nullptr, nullptr);
  }
  return list;
}

/// UTF-8 of variable length, which h5py reads as str.
Hdf5Handle text_type() {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "HDF5 has no text type");
  require(H5Tset_size(type, H5T_VARIABLE), "HDF5 text size");
  require(H5Tset_cset(type, H5T_CSET_UTF8), "HDF5 text encoding");
  return type;
}

std::size_t value_count(hid_t dataset) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "HDF5 dataspace");
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  require(count < 0 ? -1 : 0, "HDF5 dataspace without a size");
  return static_cast<std::size_t>(count);
}

/// Declares the fill value of missing values.
void write_fill_value(hid_t file, const std::string& path) {
  const std::string what = "attribute _FillValue of " + path + " cannot be written to results.h5";
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, what);
  const Hdf5Handle attribute(
      H5Acreate_by_name(file, path.c_str(), "_FillValue", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, what);
  const double absent = std::numeric_limits<double>::quiet_NaN();
  require(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &absent), what);
}

}  // namespace

Hdf5Handle::Hdf5Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close) {
  if (id < 0) throw std::runtime_error(what);
}

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& source) noexcept {
  if (this != &source) {
    reset();
    id_ = std::exchange(source.id_, -1);
    close_ = source.close_;
  }
  return *this;
}

bool Hdf5Handle::reset() noexcept {
  const hid_t id = std::exchange(id_, -1);
  return id < 0 || close_(id) >= 0;
}

Hdf5Writer::Hdf5Writer(const std::filesystem::path& file) : path_(file) {
  set_up_library();
  const std::string what = "the file " + file.filename().string() + " cannot be created";
  const Hdf5Handle access(make_tolerant_access(error_.get()), H5Pclose, what);
  file_ = Hdf5Handle(H5Fcreate(file.string().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, what);
}

Hdf5Writer Hdf5Writer::reopen(const std::filesystem::path& file) {
  set_up_library();
  unseal_file(file);
  const std::string what = "the file " + file.filename().string() + " cannot be changed";
  Hdf5Writer writer;
  writer.path_ = file;
  const Hdf5Handle access(make_tolerant_access(writer.error_.get()), H5Pclose, what);
  writer.file_ = Hdf5Handle(H5Fopen(file.string().c_str(), H5F_ACC_RDWR, access), H5Fclose, what);
  return writer;
}

void Hdf5Writer::link(const std::string& path, const std::string& target) {
  require(H5Lcreate_soft(target.c_str(), file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT),
          path + " cannot be linked in results.h5");
}

void Hdf5Writer::remove(const std::string& path) {
  require(H5Ldelete(file_, path.c_str(), H5P_DEFAULT), path + " cannot be removed from results.h5");
}

void Hdf5Writer::overwrite(const std::string& path, const std::vector<double>& values) {
  const Hdf5Handle set = dataset(path);
  const std::string what = "dataset " + path + " cannot be written to results.h5";
  require(value_count(set) == values.size() ? 0 : -1, what);
  require(H5Dwrite(set, memory_type<double>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), what);
  require_disk();
}

void Hdf5Writer::require_disk() const {
  if (*error_) throw FileError("the file results.h5 cannot be written: " + error_->message());
}

Hdf5Handle Hdf5Writer::dataset(const std::string& path) const {
  return {H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, "results.h5 has no dataset " + path};
}

void Hdf5Writer::group(const std::string& path, const std::string& description) {
  const std::string what = "group " + path + " cannot be created in results.h5";
  const Hdf5Handle ordered(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, what);
  require(H5Pset_link_creation_order(ordered, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), what);
  Hdf5Handle group(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, ordered, H5P_DEFAULT), H5Gclose, what);
  attribute(path, "description", description);
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, const std::string& text) {
  const std::string what = "attribute " + name + " of " + object + " cannot be written to results.h5";
  const Hdf5Handle type = text_type();
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, what);
  const Hdf5Handle attribute(
      H5Acreate_by_name(file_, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, what);
  const char* pointer = text.c_str();
  require(H5Awrite(attribute, type, static_cast<const void*>(&pointer)), what);
}

void Hdf5Writer::write_raw(const std::string& path, const ResultField& field, hid_t memory_type, hid_t file_type,
                           const std::vector<hsize_t>& shape, const void* values) {
  check_interruption();
  const std::string what = "dataset " + path + " cannot be written to results.h5";
  const Hdf5Handle space(
      shape.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
      H5Sclose, what);
  Hdf5Handle set(H5Dcreate2(file_, path.c_str(), file_type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                 what);
  if (const hssize_t count = H5Sget_simple_extent_npoints(space); count > 0) {
    const Hdf5Handle transfer(small_buffer(static_cast<std::size_t>(count)), H5Pclose, what);
    require(H5Dwrite(set, memory_type, H5S_ALL, H5S_ALL, transfer, values), what);
  }
  set.reset();
  describe(path, field);
}

void Hdf5Writer::describe(const std::string& path, const ResultField& field) {
  attribute(path, "units", std::string(field.units));
  attribute(path, "frame", field.frame);
  attribute(path, "description", std::string(field.description).append(field.aspect));
  require_disk();
  if (may_be_missing_in_file(path)) write_fill_value(file_, path);
}

template <class Number>
void Hdf5Writer::create(const std::string& path, const ResultField& field, const std::vector<hsize_t>& shape,
                        hsize_t chunk_rows) {
  const std::string what = "dataset " + path + " cannot be created in results.h5";
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, what);
  const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  std::vector<hsize_t> chunk = shape;
  chunk[0] = std::clamp<hsize_t>(chunk_rows, 1, shape[0]);
  require(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), what);
  if (H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0) {
    require(H5Pset_shuffle(properties), what);  // groups bytes of equal significance: smooth histories take half the
                                                // space
    require(H5Pset_deflate(properties, kCompression), what);
  }
  Hdf5Handle set(H5Dcreate2(file_, path.c_str(), file_type<Number>(), space, H5P_DEFAULT, properties, H5P_DEFAULT),
                 H5Dclose, what);
  set.reset();
  describe(path, field);
}

template <class Number>
void Hdf5Writer::write_rows(const std::string& path, hsize_t first, const std::vector<Number>& values) {
  check_interruption();
  const std::string what = "dataset " + path + " cannot be written to results.h5";
  const Hdf5Handle set = dataset(path);
  const Hdf5Handle space(H5Dget_space(set), H5Sclose, what);
  std::vector<hsize_t> count(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 1)));
  H5Sget_simple_extent_dims(space, count.data(), nullptr);
  const hsize_t row = std::accumulate(count.begin() + 1, count.end(), hsize_t{1}, std::multiplies<>());
  std::vector<hsize_t> start(count.size(), 0);
  start[0] = first;
  count[0] = values.size() / row;
  require(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), what);
  const Hdf5Handle memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose, what);
  require(H5Dwrite(set, memory_type<Number>(), memory, space, H5P_DEFAULT, values.data()), what);
  require_disk();
}

template void Hdf5Writer::create<double>(const std::string&, const ResultField&, const std::vector<hsize_t>&, hsize_t);
template void Hdf5Writer::create<int>(const std::string&, const ResultField&, const std::vector<hsize_t>&, hsize_t);
template void Hdf5Writer::write_rows<double>(const std::string&, hsize_t, const std::vector<double>&);
template void Hdf5Writer::write_rows<int>(const std::string&, hsize_t, const std::vector<int>&);

bool Hdf5Writer::has(const std::string& path) const {
  return H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5Writer::write(const std::string& path, const ResultField& field, const std::vector<double>& values,
                       const std::vector<hsize_t>& shape) {
  write_raw(path, field, memory_type<double>(), file_type<double>(), shape, values.data());
}

void Hdf5Writer::write(const std::string& path, const ResultField& field, const std::vector<int>& values,
                       const std::vector<hsize_t>& shape) {
  write_raw(path, field, memory_type<int>(), file_type<int>(), shape, values.data());
}

void Hdf5Writer::write(const std::string& path, const ResultField& field, const std::vector<std::int64_t>& values,
                       const std::vector<hsize_t>& shape) {
  write_raw(path, field, H5T_NATIVE_INT64, H5T_STD_I64LE, shape, values.data());
}

void Hdf5Writer::write(const std::string& path, const ResultField& field, const std::vector<std::uint64_t>& values,
                       const std::vector<hsize_t>& shape) {
  write_raw(path, field, H5T_NATIVE_UINT64, H5T_STD_U64LE, shape, values.data());
}

void Hdf5Writer::write(const std::string& path, const ResultField& field, const std::vector<std::string>& values,
                       const std::vector<hsize_t>& shape) {
  std::vector<const char*> pointers;
  pointers.reserve(values.size());
  for (const std::string& text : values) pointers.push_back(text.c_str());
  const Hdf5Handle type = text_type();
  write_raw(path, field, type, type, shape, static_cast<const void*>(pointers.data()));
}

void Hdf5Writer::make_scale(const std::string& path, const std::string& name) {
  require(H5DSset_scale(dataset(path), name.c_str()), path + " cannot be a dimension scale");
}

void Hdf5Writer::attach_scale(const std::string& path, const std::string& scale, unsigned dimension) {
  require(H5DSattach_scale(dataset(path), dataset(scale), dimension), scale + " cannot be the scale of " + path);
}

void Hdf5Writer::close() {
  const bool flushed = H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0, closed = file_.reset();
  require_disk();
  if (!closed || !flushed) throw std::runtime_error("results.h5 cannot be written completely");
  seal_file(path_);
}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file) : name_(file.string()) {
  set_up_library();
  require_sealed(file);  // the library itself crashes on damaged metadata
  file_ = Hdf5Handle(H5Fopen(file.string().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                     "the file '" + name_ + "' cannot be read as HDF5");
}

Hdf5Handle Hdf5Reader::dataset(const std::string& path) const {
  check_interruption();
  return {H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, "the file '" + name_ + "' has no dataset " + path};
}

bool Hdf5Reader::has(const std::string& path) const {
  return H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0;
}

std::vector<double> Hdf5Reader::doubles(const std::string& path) const {
  const Hdf5Handle set = dataset(path);
  std::vector<double> values(value_count(set));
  require(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          path + " does not contain numbers");
  return values;
}

hsize_t Hdf5Reader::lines(const std::string& path) const {
  const Hdf5Handle set = dataset(path);
  const Hdf5Handle space(H5Dget_space(set), H5Sclose, "HDF5 dataspace");
  std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
  if (shape.empty()) return 1;
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape[0];
}

std::vector<double> Hdf5Reader::doubles(const std::string& path, hsize_t first, hsize_t count) const {
  const Hdf5Handle set = dataset(path);
  const Hdf5Handle space(H5Dget_space(set), H5Sclose, "HDF5 dataspace");
  std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
  require(shape.empty() ? -1 : H5Sget_simple_extent_dims(space, shape.data(), nullptr), path + " has no rows");
  require(first + count <= shape[0] ? 0 : -1, path + " has too few rows");
  std::vector<hsize_t> start(shape.size(), 0);
  start[0] = first;
  shape[0] = count;
  hsize_t total = 1;
  for (const hsize_t extent : shape) total *= extent;
  std::vector<double> values(total);
  if (values.empty()) return values;
  require(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, shape.data(), nullptr), path);
  const Hdf5Handle memory(H5Screate_simple(1, &total, nullptr), H5Sclose, "HDF5 dataspace");
  require(H5Dread(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values.data()),
          path + " does not contain numbers");
  return values;
}

std::vector<int> Hdf5Reader::ints(const std::string& path) const {
  const Hdf5Handle set = dataset(path);
  std::vector<int> values(value_count(set));
  require(H5Dread(set, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          path + " does not contain integers");
  return values;
}

std::vector<std::int64_t> Hdf5Reader::counts(const std::string& path) const {
  const Hdf5Handle set = dataset(path);
  std::vector<std::int64_t> values(value_count(set));
  require(H5Dread(set, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          path + " does not contain integers");
  return values;
}

std::uint64_t Hdf5Reader::seed(const std::string& path) const {
  const Hdf5Handle set = dataset(path);
  std::uint64_t value = 0;
  if (value_count(set) != 1) throw std::runtime_error(path + " is not a single number");
  require(H5Dread(set, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value),
          path + " does not contain an integer");
  return value;
}

std::vector<std::string> Hdf5Reader::texts(const std::string& path) const {
  const Hdf5Handle set = dataset(path);
  const Hdf5Handle type = text_type();
  const Hdf5Handle space(H5Dget_space(set), H5Sclose, "HDF5 dataspace");
  std::vector<char*> pointers(value_count(set), nullptr);
  if (pointers.empty()) return {};
  require(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, static_cast<void*>(pointers.data())),
          path + " does not contain texts");
  std::vector<std::string> values;
  for (const char* text : pointers) values.emplace_back(text == nullptr ? "" : text);
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, static_cast<void*>(pointers.data()));
  return values;
}

namespace {

std::string text_attribute(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return {};
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, "HDF5 attribute");
  const Hdf5Handle type = text_type();
  char* text = nullptr;
  require(H5Aread(attribute, type, static_cast<void*>(&text)), std::string("the attribute ") + name + " is not a text");
  std::string value = text == nullptr ? "" : text;
  H5free_memory(text);
  return value;
}

std::string object_file_path(hid_t object) {
  const ssize_t length = H5Iget_name(object, nullptr, 0);
  if (length <= 0) return {};
  std::string path(static_cast<std::size_t>(length) + 1, '\0');
  H5Iget_name(object, path.data(), path.size());
  path.pop_back();
  return path;
}

/// Returns the path of the scale of a dimension; empty without one.
std::string dimension_scale_path(hid_t set, unsigned dimension) {
  const auto first = [](hid_t, unsigned, hid_t scale, void* path) {
    *static_cast<std::string*>(path) = object_file_path(scale);
    return herr_t{1};
  };
  std::string path;
  if (H5DSget_num_scales(set, dimension) > 0) H5DSiterate_scales(set, dimension, nullptr, first, &path);
  return path;
}

}  // namespace

/// Links in creation order if the group stores it: files of older versions do not.
H5_index_t link_order(const Hdf5Handle& file, const std::string& group) {
  unsigned order = 0;
  const hid_t found = H5Gopen2(file, group.c_str(), H5P_DEFAULT);
  if (found < 0) return H5_INDEX_NAME;
  const Hdf5Handle open(found, H5Gclose, group);
  const Hdf5Handle made(H5Gget_create_plist(open), H5Pclose, group);
  H5Pget_link_creation_order(made, &order);
  return (order & H5P_CRT_ORDER_INDEXED) != 0 ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
}

std::vector<std::string> Hdf5Reader::names(const std::string& group) const {
  const auto add = [](hid_t parent, const char* name, const H5L_info_t*, void* list) {
    H5O_info_t info{};
    if (H5Oget_info_by_name(parent, name, &info, H5P_DEFAULT) < 0) return herr_t{-1};
    static_cast<std::vector<std::string>*>(list)->emplace_back(std::string(name) +
                                                               (info.type == H5O_TYPE_GROUP ? "/" : ""));
    return herr_t{0};
  };
  std::vector<std::string> list;
  require(
      H5Literate_by_name(file_, group.c_str(), link_order(file_, group), H5_ITER_INC, nullptr, add, &list, H5P_DEFAULT),
      "the file '" + name_ + "' has no group " + group);
  return list;
}

Dataset Hdf5Reader::whole(const std::string& path) const {
  const Hdf5Handle set = dataset(path);
  const Hdf5Handle space(H5Dget_space(set), H5Sclose, "HDF5 dataspace");
  const Hdf5Handle type(H5Dget_type(set), H5Tclose, "HDF5 type");
  Dataset found;
  found.shape.resize(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
  if (!found.shape.empty()) H5Sget_simple_extent_dims(space, found.shape.data(), nullptr);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind == H5T_STRING) {
    found.values = texts(path);
  } else if (kind == H5T_INTEGER) {
    found.values = counts(path);
  } else {
    found.values = doubles(path);
  }
  found.units = text_attribute(set, "units");
  found.description = text_attribute(set, "description");
  found.frame = text_attribute(set, "frame");
  for (unsigned i = 0; i < found.shape.size(); ++i) {
    found.scales.push_back(H5DSis_scale(set) > 0 ? path : dimension_scale_path(set, i));
  }
  return found;
}

}  // namespace overbend
