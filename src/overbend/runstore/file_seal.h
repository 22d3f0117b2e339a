/// Checksum at the end of a file, for files whose library does not survive damage.
#pragma once

#include <filesystem>

namespace overbend {

/// Appends mark, length and checksum of the content, 24 bytes that HDF5 ignores. Throws std::runtime_error if the disk
/// reports an error.
void seal_file(const std::filesystem::path& file);

/// Removes the seal of a file before a change. Throws std::runtime_error if the disk reports an error.
void unseal_file(const std::filesystem::path& file);

/// Throws std::runtime_error with the file and the reason if it cannot be read, has no seal or differs from the sealed
/// content. A verified file is not read again while its length and time of change are the same.
void require_sealed(const std::filesystem::path& file);

}  // namespace overbend
