#include "resultfiles/hdf5/hdf5_driver.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <memory>

namespace overbend {
namespace {

/// The library uses the base and passes it back; the other members are those of this driver.
struct DiskFile : H5FD_t {
  int id = -1;
  int* error = nullptr;
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
  int* error;
};

void note(const DiskFile& file) {
  if (*file.error == 0) *file.error = errno;
}

int system_flags(unsigned flags) {
  int out = (flags & H5F_ACC_RDWR) != 0 ? O_RDWR : O_RDONLY;
  if ((flags & H5F_ACC_TRUNC) != 0) out |= O_TRUNC;
  if ((flags & H5F_ACC_CREAT) != 0) out |= O_CREAT;
  if ((flags & H5F_ACC_EXCL) != 0) out |= O_EXCL;
  return out | O_CLOEXEC;
}

H5FD_t* open_file(const char* name, unsigned flags, hid_t access_list, haddr_t /*largest*/) {
  const auto* access = static_cast<const Access*>(H5Pget_driver_info(access_list));
  if (access == nullptr) return nullptr;
  const int id = ::open(name, system_flags(flags), 0666);
  if (id < 0) return nullptr;
  const off_t length = ::lseek(id, 0, SEEK_END);
  auto file = std::make_unique<DiskFile>();
  file->id = id;
  file->error = access->error;
  file->end_written = static_cast<haddr_t>(std::max<off_t>(length, 0));
  return file.release();
}

herr_t close_file(H5FD_t* handle) {
  const std::unique_ptr<DiskFile> file(of(handle));
  if (::close(file->id) != 0) note(*file);
  return 0;
}

/// Order of files: the library checks whether a file is already open.
int compare_files(const H5FD_t* first, const H5FD_t* second) {
  struct stat a {
  }, b{};
  if (::fstat(of(first)->id, &a) != 0 || ::fstat(of(second)->id, &b) != 0) return -1;
  if (a.st_dev != b.st_dev) return a.st_dev < b.st_dev ? -1 : 1;
  return a.st_ino == b.st_ino ? 0 : a.st_ino < b.st_ino ? -1 : 1;
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
  const DiskFile& file = *of(handle);
  auto* bytes = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t count = ::pread(file.id, bytes, size, static_cast<off_t>(address));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return -1;
    if (count == 0) break;
    bytes += count;
    address += static_cast<haddr_t>(count);
    size -= static_cast<std::size_t>(count);
  }
  std::memset(bytes, 0, size);
  return 0;
}

herr_t write_file(H5FD_t* handle, H5FD_mem_t /*type*/, hid_t /*list*/, haddr_t address, std::size_t size,
                  const void* from) {
  DiskFile& file = *of(handle);
  const auto* bytes = static_cast<const char*>(from);
  const haddr_t end = address + size;
  while (size > 0 && *file.error == 0) {
    const ssize_t count = ::pwrite(file.id, bytes, size, static_cast<off_t>(address));
    if (count < 0) {
      if (errno != EINTR) note(file);
      continue;
    }
    bytes += count;
    address += static_cast<haddr_t>(count);
    size -= static_cast<std::size_t>(count);
  }
  file.end_written = std::max(file.end_written, end);
  return 0;
}

herr_t truncate_file(H5FD_t* handle, hid_t /*list*/, hbool_t /*closing*/) {
  DiskFile& file = *of(handle);
  if (file.end_allocated == file.end_written) return 0;
  if (::ftruncate(file.id, static_cast<off_t>(file.end_allocated)) != 0) note(file);
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
  driver.maxaddr = static_cast<haddr_t>(std::numeric_limits<off_t>::max());
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

hid_t make_tolerant_access(int* error) {
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
