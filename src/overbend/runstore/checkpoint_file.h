/// Checkpoint file from which a dynamic run can be resumed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "results/dynamic_sink.h"

namespace overbend {

/// Content of a checkpoint: the state, the lengths of the stored data that belong to it, and the identity of the run.
struct RunCheckpoint {
  std::string version;     ///< See program_identity().
  std::string model_hash;  ///< See text_hash().
  std::uint64_t seed = 0;
  std::vector<HistoryColumn> columns;
  SnapshotSize snapshot;
  std::uint64_t row_bytes = 0, snapshot_bytes = 0, impact_bytes = 0;  ///< Lengths of the data files.
  std::vector<std::uint64_t> row_sums, snapshot_sums, impact_sums;    ///< Their checksums; see BlockSums.
  DynamicCheckpoint state;
};

/// Writes a temporary file and renames it, so that `file` is the old or the new checkpoint at any time, also on disk.
/// Throws std::runtime_error if the disk reports an error.
void write_checkpoint(const RunCheckpoint& checkpoint, const std::filesystem::path& file);

/// Returns the content written by write_checkpoint, bit for bit. Throws std::runtime_error if the file cannot be read,
/// is damaged (checksum over the whole file) or comes from another version, build or instruction set, whose results
/// differ in their bits.
RunCheckpoint read_checkpoint(const std::filesystem::path& file);

}  // namespace overbend
