#include "runstore/run_store.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <system_error>

#include "base/interruption.h"
#include "base/require.h"
#include "platform/lock.h"
#include "runstore/append_file.h"
#include "runstore/checkpoint_file.h"
#include "runstore/run_record.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFolder = ".run";
constexpr std::size_t kCacheNumbers = std::size_t{4} << 20;  // 32 MB
constexpr std::size_t kImpactNumbers = 8;
constexpr std::size_t kPoseNumbers = 12;
constexpr std::size_t kStationNumbers = 5;
constexpr std::size_t kPointNumbers = 4;  ///< Per point of a mooring line.

/// Locks the run until the file closes, also when the process is killed.
File lock(const fs::path& folder) {
  const fs::path path = folder / "lock";
  std::error_code error;
  File file(path, File::kRead | File::kWrite | File::kCreate, error);
  if (error) throw_file_error(path, "written", error);
  error = lock_file(file, LockKind::exclusive);
  if (!error) return file;
  if (error != std::errc::resource_unavailable_try_again) throw_file_error(path, "locked", error);
  throw std::runtime_error("another run is active in the folder '" + folder.parent_path().string() + "'");
}

/// True if a process holds the lock. Does not throw.
bool is_locked(const fs::path& folder) {
  std::error_code error;
  const File file(folder / "lock", File::kRead, error);
  return file.is_open() && lock_file(file, LockKind::shared) == std::errc::resource_unavailable_try_again;
}

bool same_columns(const std::vector<HistoryColumn>& a, const std::vector<HistoryColumn>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const HistoryColumn& p, const HistoryColumn& q) {
    return p.name == q.name && p.units == q.units && p.extreme == q.extreme && p.spectrum == q.spectrum &&
           p.is_minimum == q.is_minimum;
  });
}

std::array<double, kImpactNumbers> impact_numbers(const Impact& i) {
  return {static_cast<double>(i.roller),
          i.time,
          i.approach_velocity,
          i.peak_force,
          i.duration,
          i.impulse,
          i.dent_depth,
          i.line_load};
}

Impact make_impact(const double* n) {
  return {static_cast<int>(n[0]), n[1], n[2], n[3], n[4], n[5], n[6], n[7]};
}

void require_same_input(const RunCheckpoint& stored, const std::string& hash, std::uint64_t seed) {
  if (stored.model_hash != hash) {
    throw std::runtime_error(
        "the model file has changed since the run was started, or its --duration, or which controllers drive its "
        "machines; start again with --restart");
  }
  if (stored.seed != seed) {
    throw std::runtime_error("the stored run has seed " + std::to_string(stored.seed) + ", this one " +
                             std::to_string(seed) + "; start again with --restart");
  }
}

}  // namespace

struct RunStore::Files {
  fs::path folder;       ///< Absolute.
  bool made = false;     ///< True if this run created the folder of results.
  File guard;            ///< Lock of the folder.
  RunCheckpoint record;  ///< Its state is empty: the solver holds it.
  bool begun = false;
  AppendFile rows, snapshots, impacts;
  std::vector<double> cache;  ///< Columns from `cached` on, column after column.
  std::size_t cached = 0, cached_rows = 0;
  std::vector<HistoryColumn> all;            ///< Recorded and derived; empty while none is derived.
  std::vector<std::vector<double>> derived;  ///< Their values.

  fs::path checkpoint() const { return folder / "checkpoint"; }
  void open();
  void require_begun() const { require(begun, "a run has begun before data are added"); }
  std::size_t columns() const { return record.columns.size(); }
  std::size_t snapshot_numbers() const {
    return 1 + kStationNumbers * static_cast<std::size_t>(record.snapshot.stations) + kPoseNumbers +
           kPointNumbers * static_cast<std::size_t>(record.snapshot.line_points);
  }
  std::size_t row_count() const { return columns() == 0 ? 0 : rows.size() / (columns() * sizeof(double)); }
  void fill_cache(std::size_t first);
  std::vector<double> block(AppendFile& file, std::size_t size, std::int64_t first, std::int64_t count);
};

void RunStore::Files::open() {
  rows = AppendFile(folder / "rows", record.row_bytes, record.row_sums);
  snapshots = AppendFile(folder / "snapshots", record.snapshot_bytes, record.snapshot_sums);
  impacts = AppendFile(folder / "impacts", record.impact_bytes, record.impact_sums);
  begun = true;
}

/// Loads as many columns from `first` on as the cache holds, at least one.
void RunStore::Files::fill_cache(std::size_t first) {
  rows.flush();
  const std::size_t count = row_count(), width = columns();
  const std::size_t together =
      std::clamp(kCacheNumbers / std::max<std::size_t>(count, 1), std::size_t{1}, width - first);
  const std::size_t rows_at_once = std::max<std::size_t>(1, (std::size_t{1} << 16) / width);
  cache.assign(together * count, 0.0);
  std::vector<double> part;
  for (std::size_t row = 0; row < count; row += rows_at_once) {
    check_interruption();
    part.resize(std::min(rows_at_once, count - row) * width);
    rows.read(row * width * sizeof(double), part);
    for (std::size_t i = 0; i < part.size() / width; ++i) {
      for (std::size_t c = 0; c < together; ++c) cache[c * count + row + i] = part[i * width + first + c];
    }
  }
  cached = first;
  cached_rows = count;
}

std::vector<double> RunStore::Files::block(AppendFile& file, std::size_t size, std::int64_t first, std::int64_t count) {
  file.flush();
  const auto begin = static_cast<std::size_t>(first), length = static_cast<std::size_t>(count);
  std::vector<double> values(length * size);
  file.read(begin * size * sizeof(double), values);
  return values;
}

RunStore::RunStore(std::unique_ptr<Files> files) : files_(std::move(files)) {}
RunStore::RunStore(RunStore&&) noexcept = default;
RunStore& RunStore::operator=(RunStore&&) noexcept = default;
RunStore::~RunStore() = default;

RunStore RunStore::create(const fs::path& output_dir, const std::string& model_text, std::uint64_t seed) {
  auto files = std::make_unique<Files>();
  files->folder = fs::absolute(output_dir) / kFolder;
  files->made = !fs::exists(output_dir);
  std::error_code error;
  fs::create_directories(files->folder, error);
  if (error) {
    throw std::runtime_error("the folder '" + output_dir.string() + "' cannot be written: " + error.message());
  }
  files->guard = lock(files->folder);
  // The checkpoint goes first: without it the other files are not a run if this is interrupted.
  for (const char* name : {"checkpoint", "checkpoint.new", "rows", "snapshots", "impacts"}) {
    fs::remove(files->folder / name);
  }
  sync_folder(files->folder.parent_path());
  files->record.version = program_identity();
  files->record.model_hash = text_hash(model_text);
  files->record.seed = seed;
  return RunStore(std::move(files));
}

std::optional<StoredRun> RunStore::find(const fs::path& output_dir) {
  const fs::path file = output_dir / kFolder / "checkpoint";
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  const bool active = is_locked(output_dir / kFolder);
  try {
    return StoredRun{read_checkpoint(file).state.time, "", active};
  } catch (const std::exception& error) {
    return StoredRun{0.0, error.what(), active};
  }
}

std::optional<ResumedRun> RunStore::resume(const fs::path& output_dir, const std::string& model_text,
                                           std::uint64_t seed) {
  auto files = std::make_unique<Files>();
  files->folder = fs::absolute(output_dir) / kFolder;
  if (!fs::exists(files->checkpoint())) return std::nullopt;
  files->guard = lock(files->folder);
  files->record = read_checkpoint(files->checkpoint());
  require_same_input(files->record, text_hash(model_text), seed);
  files->open();
  DynamicCheckpoint state = std::exchange(files->record.state, {});
  return ResumedRun{RunStore(std::move(files)), std::move(state)};
}

void RunStore::begin(const std::vector<HistoryColumn>& columns, const SnapshotSize& size) {
  if (files_->begun) {
    if (same_columns(columns, files_->record.columns) && size == files_->record.snapshot) return;
    throw std::runtime_error("the stored run has other histories or stations; start again with --restart");
  }
  require(!columns.empty() && size.stations >= 0 && size.line_points >= 0, "a run has at least one column");
  files_->record.columns = columns;
  files_->record.snapshot = size;
  files_->open();
}

void RunStore::row(std::span<const double> values) {
  files_->require_begun();
  require(files_->derived.empty(), "rows come before what is derived from them");
  require(values.size() == files_->columns(), "a row has as many values as there are columns");
  files_->rows.append(values);
}

void RunStore::snapshot(double time, std::span<const double> values) {
  files_->require_begun();
  require(values.size() + 1 == files_->snapshot_numbers(), "a snapshot has the numbers of its stations");
  files_->snapshots.append(std::span(&time, 1));
  files_->snapshots.append(values);
}

void RunStore::impact(const Impact& impact) {
  files_->require_begun();
  files_->impacts.append(impact_numbers(impact));
}

void RunStore::checkpoint(const DynamicCheckpoint& state) {
  Files& f = *files_;
  f.require_begun();
  for (AppendFile* file : {&f.rows, &f.snapshots, &f.impacts}) file->sync();
  RunCheckpoint record = f.record;
  record.row_bytes = f.rows.size();
  record.snapshot_bytes = f.snapshots.size();
  record.impact_bytes = f.impacts.size();
  record.row_sums = f.rows.sums();
  record.snapshot_sums = f.snapshots.sums();
  record.impact_sums = f.impacts.sums();
  record.state = state;
  write_checkpoint(record, f.checkpoint());
}

void RunStore::derive(const HistoryColumn& column, std::vector<double> values) {
  Files& f = *files_;
  require(values.size() == f.row_count(), "a derived column has a value for each row");
  if (f.all.empty()) f.all = f.record.columns;
  f.all.push_back(column);
  f.derived.push_back(std::move(values));
}

const std::vector<HistoryColumn>& RunStore::columns() const {
  return files_->all.empty() ? files_->record.columns : files_->all;
}

int RunStore::stations() const {
  return files_->record.snapshot.stations;
}

int RunStore::line_points() const {
  return files_->record.snapshot.line_points;
}

std::int64_t RunStore::rows() const {
  return static_cast<std::int64_t>(files_->row_count());
}

std::int64_t RunStore::snapshots() const {
  return static_cast<std::int64_t>(files_->snapshots.size() / (files_->snapshot_numbers() * sizeof(double)));
}

std::int64_t RunStore::impacts() const {
  return static_cast<std::int64_t>(files_->impacts.size() / (kImpactNumbers * sizeof(double)));
}

std::vector<double> RunStore::column(std::size_t index) const {
  Files& f = *files_;
  if (index >= columns().size()) throw std::out_of_range("no such column");
  if (index >= f.columns()) return f.derived[index - f.columns()];
  const std::size_t count = f.row_count();
  if (count == 0) return {};
  if (f.cached_rows != count || index < f.cached || index >= f.cached + f.cache.size() / count) f.fill_cache(index);
  const auto begin = f.cache.begin() + static_cast<std::ptrdiff_t>((index - f.cached) * count);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

std::int64_t RunStore::snapshot_size() const {
  return static_cast<std::int64_t>(files_->snapshot_numbers());
}

std::vector<double> RunStore::snapshot_block(std::int64_t first, std::int64_t count) const {
  return files_->block(files_->snapshots, files_->snapshot_numbers(), first, count);
}

std::vector<Impact> RunStore::impact_block(std::int64_t first, std::int64_t count) const {
  const std::vector<double> numbers = files_->block(files_->impacts, kImpactNumbers, first, count);
  std::vector<Impact> impacts;
  for (std::size_t i = 0; i < numbers.size(); i += kImpactNumbers) impacts.push_back(make_impact(&numbers[i]));
  return impacts;
}

void RunStore::remove() noexcept {
  std::error_code ignored;  // the results are in place; a leftover folder is harmless
  fs::remove_all(files_->folder, ignored);
  if (files_->made) fs::remove(files_->folder.parent_path(), ignored);
}

}  // namespace overbend
