/// HDF5 file driver for writing.
#pragma once

#include <hdf5.h>

#include <system_error>

namespace overbend {

/// Returns a file access list (to be closed with H5Pclose) under which writes never fail for the library; negative on
/// failure. HDF5 does not recover from a file that it cannot flush: it remains half closed and crashes at the end of
/// the program. Therefore the first error is stored in `*error` and later writes are dropped; the caller must
/// check `*error`, and discard the file if it is set. `error` must outlive the file.
hid_t make_tolerant_access(std::error_code* error);

}  // namespace overbend
