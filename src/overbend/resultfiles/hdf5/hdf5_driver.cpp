#include "resultfiles/hdf5/hdf5_driver.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <utility>

#include "platform/file.h"

namespace overbend {
namespace {

/// The library uses the base and passes it back; the other members are those of this driver.
struct DiskFile : H5FD_t {
  File file;
  std::error_code* error = nullptr;
  haddr_t end_allocated = 0, end_written = 0;
};

DiskFile* of(H5FD_t* file) {
  return static_cast<DiskFile*>(file);
}
const DiskFile* of(const H5FD_t* file) {
  return static_cast<const DiskFile*>(file);
}

/// Passes the address of the error code through the access list to open_file().
struct Access {
  std::error_code* error;
};

/// Keeps the first error.
void note(const DiskFile& file, std::error_code error) {
  if (!*file.error) *file.error = error;
}

unsigned file_flags(unsigned flags) {
  unsigned out = File::kRead;
  if ((flags & H5F_ACC_RDWR) != 0) out |= File::kWrite;
  if ((flags & H5F_ACC_TRUNC) != 0) out |= File::kTruncate;
  if ((flags & H5F_ACC_CREAT) != 0) out |= File::kCreate;
  if ((flags & H5F_ACC_EXCL) != 0) out |= File::kExclusive;
  return out;
}

H5FD_t* open_file(const char* name, unsigned flags, hid_t access_list, haddr_t /*largest*/) {
  const auto* access = static_cast<const Access*>(H5Pget_driver_info(access_list));
  if (access == nullptr) return nullptr;
  auto file = std::make_unique<DiskFile>();
  std::error_code error;
  file->file = File(name, file_flags(flags), error, std::filesystem::perms(0666));
  if (error) return nullptr;
  file->error = access->error;
  file->end_written = file->file.size(error);
  return file.release();
}

herr_t close_file(H5FD_t* handle) {
  const std::unique_ptr<DiskFile> file(of(handle));
  note(*file, file->file.close());
  return 0;
}

/// Order of files: the library checks whether a file is already open.
int compare_files(const H5FD_t* first, const H5FD_t* second) {
  const auto a = of(first)->file.identity(), b = of(second)->file.identity();
  if (!a || !b) return -1;
  const std::pair key_a(a->volume, a->number), key_b(b->volume, b->number);
  return key_a == key_b ? 0 : key_a < key_b ? -1 : 1;
}

/// Same flags as the library's own driver for plain files.
herr_t query(const H5FD_t* /*file*/, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t end_allocated(const H5FD_t* file, H5FD_mem_t /*type*/) {
  return of(file)->end_allocated;
}
herr_t set_end_allocated(H5FD_t* file, H5FD_mem_t /*type*/, haddr_t end) {
  of(file)->end_allocated = end;
  return 0;
}
haddr_t end_written(const H5FD_t* file, H5FD_mem_t /*type*/) {
  return of(file)->end_written;
}

/// Data beyond the end of the file read as zeros.
herr_t read_file(H5FD_t* handle, H5FD_mem_t /*type*/, hid_t /*list*/, haddr_t address, std::size_t size, void* to) {
  const std::span bytes(static_cast<std::byte*>(to), size);
  std::error_code error;
  const std::size_t count = of(handle)->file.read(address, bytes, error);
  if (error) return -1;
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(count), bytes.end(), std::byte{0});
  return 0;
}

herr_t write_file(H5FD_t* handle, H5FD_mem_t /*type*/, hid_t /*list*/, haddr_t address, std::size_t size,
                  const void* from) {
  DiskFile& file = *of(handle);
  if (!*file.error) *file.error = file.file.write(address, {static_cast<const std::byte*>(from), size});
  file.end_written = std::max(file.end_written, address + size);
  return 0;
}

herr_t truncate_file(H5FD_t* handle, hid_t /*list*/, hbool_t /*closing*/) {
  DiskFile& file = *of(handle);
  if (file.end_allocated == file.end_written) return 0;
  note(file, file.file.resize(file.end_allocated));
  file.end_written = file.end_allocated;
  return 0;
}

H5FD_class_t make_driver() {
  H5FD_class_t driver{};
#if H5_VERSION_GE(1, 13, 0)
  driver.version = H5FD_CLASS_VERSION;
  driver.value = static_cast<H5FD_class_value_t>(300);  // 256 to 511 are reserved for unregistered drivers
#endif
  driver.name = "forgiving";
  driver.maxaddr = static_cast<haddr_t>(std::numeric_limits<std::int64_t>::max());
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(Access);
  driver.open = open_file;
  driver.close = close_file;
  driver.cmp = compare_files;
  driver.query = query;
  driver.get_eoa = end_allocated;
  driver.set_eoa = set_end_allocated;
  driver.get_eof = end_written;
  driver.read = read_file;
  driver.write = write_file;
  driver.truncate = truncate_file;
  constexpr H5FD_mem_t kDichotomy[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;  // metadata and raw data separately
  std::copy(std::begin(kDichotomy), std::end(kDichotomy), std::begin(driver.fl_map));
  return driver;
}

}  // namespace

hid_t make_tolerant_access(std::error_code* error) {
  static const H5FD_class_t kClass = make_driver();
  static const hid_t kDriver = H5FDregister(&kClass);
  const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
  const Access access{error};
  if (list >= 0 && H5Pset_driver(list, kDriver, &access) < 0) {
    H5Pclose(list);
    return -1;
  }
  return list;
}

}  // namespace overbend
