/// Where a dynamic run lives on disk while it runs.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "results/dynamic_sink.h"

namespace overbend {

/// A run that was started and not finished.
struct StoredRun {
  double time = 0.0;    ///< Of its last checkpoint [s].
  std::string fault;    ///< Why it cannot be resumed; empty if no reason is known.
  bool active = false;  ///< A process is at work on it.
};

struct ResumedRun;

/// The hidden folder `.run` inside the folder of results: rows, snapshots and impacts in flat files of little-endian
/// doubles, and the last checkpoint with the lengths of those files. Memory does not grow with the run. Whenever the
/// process dies, the folder contains a run at its last checkpoint. One process at a time may hold it. Unless
/// it says otherwise a function throws std::runtime_error with the reason when the disk refuses.
class RunStore : public DynamicSink {
 public:
  /// Starts a new run; an older one in the folder is discarded. Makes the folder of results where it is missing. Throws
  /// std::runtime_error also when another process holds the run. What is not the model's text but part of the input
  /// (tables of motion) belongs into `model_text` as well: the run can be resumed with the same text only.
  static RunStore create(const std::filesystem::path& output_dir, const std::string& model_text, std::uint64_t seed);

  /// What there is to take up; nullopt when there is nothing. Does not throw.
  static std::optional<StoredRun> find(const std::filesystem::path& output_dir);

  /// Takes up the run at its last checkpoint and drops what came after; nullopt when there is nothing to take up.
  /// Throws std::runtime_error when the model or the seed is another, the version of the program is another, the
  /// checkpoint or a data file is damaged, or another process holds the run; the folder is then unchanged.
  static std::optional<ResumedRun> resume(const std::filesystem::path& output_dir, const std::string& model_text,
                                          std::uint64_t seed);

  RunStore(RunStore&&) noexcept;
  RunStore& operator=(RunStore&&) noexcept;
  RunStore(const RunStore&) = delete;
  RunStore& operator=(const RunStore&) = delete;
  ~RunStore() override;

  /// After resume() it may be called again, with the same columns and size; else std::runtime_error.
  void begin(const std::vector<HistoryColumn>& columns, const SnapshotSize& size) override;
  void row(std::span<const double> values) override;  ///< Allocates nothing.
  void snapshot(double time, std::span<const double> values) override;
  void impact(const Impact& impact) override;
  void checkpoint(const DynamicCheckpoint& state) override;

  /// Adds a column that is made from the others when the run has ended; it has a value for each row, follows the
  /// recorded ones and is not on disk: a resumed run makes it anew. No row may be handed over afterwards.
  void derive(const HistoryColumn& column, std::vector<double> values);

  const std::vector<HistoryColumn>& columns() const;  ///< Recorded, then derived.
  int stations() const;
  int line_points() const;  ///< Of mooring lines, in a snapshot.
  std::int64_t rows() const;
  std::int64_t snapshots() const;
  std::int64_t impacts() const;

  /// One column of the table of histories, all rows. Neighbouring columns are read at once and kept (at most 32 MB
  /// beside the column itself), so that asking for all in turn does not read the file as often as there are columns.
  std::vector<double> column(std::size_t index) const;

  /// Snapshots `first` to `first + count`, one after the other: each its time and then the values handed over.
  std::vector<double> snapshot_block(std::int64_t first, std::int64_t count) const;
  /// Numbers of one snapshot, with its time.
  std::int64_t snapshot_size() const;
  std::vector<Impact> impact_block(std::int64_t first, std::int64_t count) const;

  /// Removes the run's folder, when the results are written or the run is not worth keeping, and the folder of results
  /// if create() made it and nothing else is in it. Does not throw. Nothing may be handed over afterwards.
  void remove() noexcept;

 private:
  struct Files;
  explicit RunStore(std::unique_ptr<Files> files);
  std::unique_ptr<Files> files_;
};

/// A resumed run: the state it continues from, and the store with its previous data.
struct ResumedRun {
  RunStore store;
  DynamicCheckpoint state;
};

}  // namespace overbend
