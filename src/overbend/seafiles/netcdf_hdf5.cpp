#include "seafiles/netcdf_hdf5.h"

#include <hdf5.h>
#include <hdf5_hl.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <stdexcept>

#include "base/child_work.h"
#include "base/file_lock.h"
#include "seafiles/netcdf_bytes.h"

namespace overbend {
namespace {

/// Owning handle of an HDF5 object.
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

std::vector<std::size_t> read_sizes(hid_t variable) {
  const Handle space(H5Dget_space(variable), H5Sclose);
  if (!space || H5Sget_simple_extent_type(space.get()) == H5S_NULL) return {0};
  const int rank = H5Sget_simple_extent_ndims(space.get());
  if (rank < 0) throw std::runtime_error("has no dimensions");
  std::vector<hsize_t> sizes(static_cast<std::size_t>(rank));
  if (rank > 0) H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr);
  return {sizes.begin(), sizes.end()};
}

/// Stores the name of a dimension scale, without the leading slash.
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

std::optional<double> attribute(hid_t variable, const char* name) {
  if (H5Aexists(variable, name) <= 0) return std::nullopt;
  const Handle attribute(H5Aopen(variable, name, H5P_DEFAULT), H5Aclose);
  const Handle space(H5Aget_space(attribute.get()), H5Sclose);
  double value = 0.0;
  const bool single = H5Sget_simple_extent_npoints(space.get()) == 1;
  if (!single || H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value) < 0) return std::nullopt;
  return value;
}

/// Chunks of a variable.
struct Chunks {
  hsize_t wanted = 1, found = 0;
  std::size_t size = 0;  ///< Size of one chunk without filters [bytes].
};

Chunks count_chunks(hid_t variable, hid_t plan, const std::vector<std::size_t>& sizes) {
  std::vector<hsize_t> extent(std::max<std::size_t>(sizes.size(), 1), 0);
  const int rank = H5Pget_chunk(plan, static_cast<int>(extent.size()), extent.data());
  if (rank != static_cast<int>(sizes.size())) throw std::runtime_error("has chunks of other dimensions");
  const Handle type(H5Dget_type(variable), H5Tclose), space(H5Dget_space(variable), H5Sclose);
  Chunks chunks;
  chunks.size = H5Tget_size(type.get());
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (extent[k] == 0 || extent[k] > kMaxNetcdfValues) throw std::runtime_error("has chunks without a size");
    chunks.wanted *= (sizes[k] + extent[k] - 1) / extent[k];
    chunks.size *= extent[k];
  }
  if (H5Dget_num_chunks(variable, space.get(), &chunks.found) < 0) chunks.found = 0;
  return chunks;
}

/// True if a chunk stored without filters is shorter than its size: HDF5 would read beyond its buffer.
bool is_short(hid_t variable, hsize_t number, std::size_t size, bool filtered) {
  const Handle space(H5Dget_space(variable), H5Sclose);
  hsize_t offset[H5S_MAX_RANK] = {}, stored = 0;
  unsigned skipped = 0;
  haddr_t address = 0;
  if (H5Dget_chunk_info(variable, space.get(), number, offset, &skipped, &address, &stored) < 0) return true;
  return (!filtered || skipped != 0) && stored < size;
}

/// Throws if values were never written or chunks are missing, for which HDF5 would return zeros.
void require_written(hid_t variable, const std::vector<std::size_t>& sizes) {
  constexpr hsize_t kManyChunks = 4096;  // for more chunks only the number is checked, because each look-up is linear
  const Handle plan(H5Dget_create_plist(variable), H5Pclose);
  if (H5Pget_layout(plan.get()) != H5D_CHUNKED) {
    if (H5Dget_storage_size(variable) == 0) throw std::runtime_error("was never written");
    return;
  }
  const Chunks chunks = count_chunks(variable, plan.get(), sizes);
  if (chunks.found != chunks.wanted) {
    throw std::runtime_error("has " + std::to_string(chunks.found) + " of its " + std::to_string(chunks.wanted) +
                             " chunks");
  }
  const bool filtered = H5Pget_nfilters(plan.get()) > 0;
  for (hsize_t i = 0; i < chunks.found && chunks.found <= kManyChunks; ++i) {
    if (is_short(variable, i, chunks.size, filtered)) throw std::runtime_error("has a chunk that is too short");
  }
}

void read_numbers(hid_t variable, NetcdfVariable& found, std::size_t count) {
  std::vector<double>& values = found.array.values;
  values.resize(count);
  if (count == 0) return;
  if (H5Dread(variable, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    throw std::runtime_error("cannot be read");
  }
  unpack(values,
         {attribute(variable, "scale_factor"), attribute(variable, "add_offset"), attribute(variable, "_FillValue")});
}

void read_texts(hid_t variable, hid_t type, NetcdfVariable& found, std::size_t count) {
  if (count == 0) return;
  if (H5Tis_variable_str(type) <= 0) {
    const std::size_t length = H5Tget_size(type);
    if (length == 0 || count > kMaxNetcdfValues / length) throw std::runtime_error("has too much text");
    std::string letters(count * length, '\0');
    if (H5Dread(variable, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, letters.data()) < 0) {
      throw std::runtime_error("cannot be read");
    }
    // NetCDF stores text as single characters with a second dimension.
    const std::vector<std::size_t>& sizes = found.array.sizes;
    found.texts = split_texts(letters, length == 1 && sizes.size() == 2 ? sizes[1] : length);
    return;
  }
  std::vector<char*> texts(count, nullptr);
  if (H5Dread(variable, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, static_cast<void*>(texts.data())) < 0) {
    throw std::runtime_error("cannot be read");
  }
  for (const char* text : texts) found.texts.emplace_back(text == nullptr ? "" : text);
}

void read_values(hid_t variable, NetcdfVariable& found) {
  const Handle type(H5Dget_type(variable), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type.get());
  const bool numbers = kind == H5T_FLOAT || kind == H5T_INTEGER;
  if (!numbers && kind != H5T_STRING) return;
  found.kind = numbers ? NetcdfVariable::Kind::numbers : NetcdfVariable::Kind::texts;
  found.array.sizes = read_sizes(variable);
  const std::optional<std::size_t> count = count_values(found.array.sizes);
  if (!count) throw std::runtime_error("has too many values");
  for (unsigned k = 0; k < found.array.sizes.size(); ++k) {
    found.array.dimensions.push_back(dimension_name(variable, k));
  }
  if (*count > 0) require_written(variable, found.array.sizes);
  numbers ? read_numbers(variable, found, *count) : read_texts(variable, type.get(), found, *count);
}

herr_t keep_name(hid_t, const char* name, const H5L_info_t* link, void* names) {
  if (link->type == H5L_TYPE_HARD) static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

constexpr int kMaxGroupDepth = 8;
constexpr std::size_t kMaxVariables = 100'000;

/// Reads the variables of a group and of the groups in it; `path` precedes their names: "body1/properties/".
void read_group(hid_t group, const std::string& path, int depth, NetcdfContents& contents) {
  std::vector<std::string> names;
  if (H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, keep_name, &names) < 0) {
    throw std::runtime_error("a damaged netCDF-4 file: its variables cannot be listed");
  }
  for (const std::string& name : names) {
    if (contents.size() >= kMaxVariables) throw std::runtime_error("a netCDF-4 file of too many variables");
    const Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
    NetcdfVariable variable;
    if (!object) variable.error = "cannot be opened";
    const H5I_type_t type = object ? H5Iget_type(object.get()) : H5I_DATASET;
    if (type == H5I_GROUP && depth < kMaxGroupDepth) read_group(object.get(), path + name + "/", depth + 1, contents);
    if (type != H5I_DATASET) continue;
    try {
      if (object) read_values(object.get(), variable);
    } catch (const std::runtime_error& error) {
      variable.error = error.what();
    }
    contents.emplace(path + name, std::move(variable));
  }
}

NetcdfContents read_contents(hid_t file) {
  NetcdfContents contents;
  read_group(file, "", 0, contents);
  return contents;
}

std::string read_in_child(const std::string& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // keeps HDF5 from printing its error stack
  H5PLset_loading_state(0);                     // forbids loading plugins named in a file
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file) throw std::runtime_error("a file that is not netCDF");
  return serialise_contents(read_contents(file.get()));
}

/// Limits of time and memory, far above what reading needs.
ChildLimits limits_for(const std::string& path) {
  constexpr std::uintmax_t kPerSecond = std::uintmax_t{10} << 20U, kMax = std::uintmax_t{1} << 33U;
  std::error_code error;
  const std::uintmax_t length = std::min(std::filesystem::file_size(path, error), kMax);
  ChildLimits limits;
  limits.cpu_time = std::chrono::seconds(1 + (error ? 0 : length / kPerSecond));
  limits.wall_time = 60 * limits.cpu_time;
  limits.memory += error ? 0 : static_cast<std::size_t>(length);
  return limits;
}

}  // namespace

NetcdfContents read_netcdf_hdf5(const std::string& path) {
  std::unique_lock<FileLock> hold(hdf5_lock());
  ChildWork work([&] { return read_in_child(path); }, limits_for(path));
  hold.unlock();
  try {
    return parse_contents(work.result());
  } catch (const ChildError& error) {
    throw std::runtime_error(std::string("a damaged netCDF-4 file: ") + error.what());
  }
}

}  // namespace overbend
