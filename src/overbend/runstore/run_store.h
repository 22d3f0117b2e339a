/// Storage of a dynamic run on disk while it runs.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "results/dynamic_sink.h"

namespace overbend {

/// Run that was started and not finished.
struct StoredRun {
  double time = 0.0;    ///< Time of its last checkpoint [s].
  std::string error;    ///< Reason why it cannot be resumed; empty if none is known.
  bool active = false;  ///< True if a process is working on it.
};

struct ResumedRun;

/// Hidden folder `.run` inside the folder of results: rows, snapshots and impacts in flat files of little-endian
/// doubles, and the last checkpoint with the lengths of those files. Memory does not grow with the run. If the process
/// dies at any time, the folder contains the run at its last checkpoint. One process at a time may hold it. Unless
/// stated otherwise, functions throw std::runtime_error with the reason if the disk reports an error.
class RunStore : public DynamicSink {
 public:
  /// Starts a new run and discards an older one in the folder. Creates the folder of results if it is missing. Also
  /// throws std::runtime_error if another process holds the run. Input that is not part of the model's text (tables of
  /// motion) has to be included in `model_text`: the run can be resumed with the same text only.
  static RunStore create(const std::filesystem::path& output_dir, const std::string& model_text, std::uint64_t seed);

  /// Returns the stored run; nullopt if there is none. Does not throw.
  static std::optional<StoredRun> find(const std::filesystem::path& output_dir);

  /// Resumes the run at its last checkpoint and drops later data; nullopt if there is none. Throws std::runtime_error
  /// if the model, the seed or the version of the program differs, the checkpoint or a data file is damaged, or another
  /// process holds the run; the folder is then unchanged.
  static std::optional<ResumedRun> resume(const std::filesystem::path& output_dir, const std::string& model_text,
                                          std::uint64_t seed);

  RunStore(RunStore&&) noexcept;
  RunStore& operator=(RunStore&&) noexcept;
  RunStore(const RunStore&) = delete;
  RunStore& operator=(const RunStore&) = delete;
  ~RunStore() override;

  /// May be called again after resume() with the same columns and size; otherwise throws std::runtime_error.
  void begin(const std::vector<HistoryColumn>& columns, const SnapshotSize& size) override;
  void row(std::span<const double> values) override;  ///< Does not allocate.
  void snapshot(double time, std::span<const double> values) override;
  void impact(const Impact& impact) override;
  void checkpoint(const DynamicCheckpoint& state) override;

  /// Adds a column computed from the others at the end of the run, with one value per row. It follows the recorded
  /// columns and is not stored on disk: a resumed run computes it again. No rows may be added afterwards.
  void derive(const HistoryColumn& column, std::vector<double> values);

  const std::vector<HistoryColumn>& columns() const;  ///< Recorded, then derived.
  int stations() const;                               ///< Number of stations in a snapshot.
  int line_points() const;                            ///< Number of mooring line points in a snapshot.
  std::int64_t rows() const;
  std::int64_t snapshots() const;
  std::int64_t impacts() const;

  /// Returns one column of the histories, all rows. Neighbouring columns are read together and cached (at most 32 MB in
  /// addition to the column itself), so that reading all columns in turn does not read the file once per column.
  std::vector<double> column(std::size_t index) const;

  /// Returns snapshots `first` to `first + count` in sequence: each its time and then its values.
  std::vector<double> snapshot_block(std::int64_t first, std::int64_t count) const;
  /// Number of values of one snapshot, including its time.
  std::int64_t snapshot_size() const;
  std::vector<Impact> impact_block(std::int64_t first, std::int64_t count) const;

  /// Removes the run's folder, when the results are written or the run is not worth keeping, and the folder of results
  /// if create() made it and it is otherwise empty. Does not throw. No data may be added afterwards.
  void remove() noexcept;

 private:
  struct Files;
  explicit RunStore(std::unique_ptr<Files> files);
  std::unique_ptr<Files> files_;
};

/// Resumed run: the state it continues from, and the store with its previous data.
struct ResumedRun {
  RunStore store;
  DynamicCheckpoint state;
};

}  // namespace overbend
