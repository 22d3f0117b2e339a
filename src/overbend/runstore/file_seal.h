/// A checksum at the end of a file, for files whose library does not survive damage.
#pragma once

#include <filesystem>

namespace overbend {

/// Appends mark, length and checksum of the content, 24 bytes that HDF5 passes over. Throws std::runtime_error when the
/// disk refuses.
void seal_file(const std::filesystem::path& file);

/// Takes the seal off a file that has one, to change it. Throws std::runtime_error when the disk refuses.
void unseal_file(const std::filesystem::path& file);

/// Throws std::runtime_error, with the file and the reason, where it cannot be read, has no seal or is not what was
/// sealed. A file that was found whole is not read again as long as its length and time of change are the same.
void require_sealed(const std::filesystem::path& file);

}  // namespace overbend
