/// How HDF5 reaches the disk when it writes for us.
#pragma once

#include <hdf5.h>

namespace overbend {

/// A file access list (to be closed with H5Pclose) under which writes never fail for the library. HDF5 does not survive
/// a file that it cannot flush: it stays half closed, and the end of the program crashes over it. So the first fault
/// is noted in `*fault` (as errno has it), what cannot be written is dropped, and whoever writes looks there; the file
/// is worthless then. `fault` must outlive the file. Negative where the library refuses.
hid_t forgiving_access(int* fault);

}  // namespace overbend
