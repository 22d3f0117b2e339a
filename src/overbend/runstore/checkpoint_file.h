/// The file from which a dynamic run can be resumed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "results/dynamic_sink.h"

namespace overbend {

/// Content of a checkpoint: the state, how much of the stored data belongs to it, and whose run it is.
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

/// Writes beside and renames, so that `file` is the old checkpoint or the new one at any instant, on disk too. Throws
/// std::runtime_error when the disk refuses.
void write_checkpoint(const RunCheckpoint& checkpoint, const std::filesystem::path& file);

/// Gives back what write_checkpoint wrote, bit for bit. Throws std::runtime_error when the file cannot be read, is
/// damaged (by a checksum over all of it) or comes from another version or build of the program or another instruction
/// set, which would go on with other bits.
RunCheckpoint read_checkpoint(const std::filesystem::path& file);

}  // namespace overbend
