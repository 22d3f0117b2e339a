#include "resultfiles/dynamic/dynamic_blocks.h"

#include <algorithm>
#include <array>

#include "resultfiles/hdf5/dataset_path.h"
#include "resultfiles/tables/finite_visitor.h"
#include "results/fields/dynamic_tables.h"

namespace overbend {
namespace {

constexpr hsize_t kHistoryChunk = 16384;
constexpr std::int64_t kImpactBlock = 16384;
constexpr std::int64_t kMinSnapshots = 16, kSnapshotNumbers = 65536;  // in one chunk: each chunk is compressed by
                                                                      // itself
// A scale keeps a list of its datasets in an attribute, which HDF5 limits to 64 kB.
constexpr std::size_t kMaxScaledDatasets = 2000;

void require_finite(const std::string& place, const std::string& name, const std::vector<double>& values) {
  const FiniteVisitor visit{place};
  const ResultField field{name};
  for (const double value : values) visit(field, value);
}

void write_history(Hdf5Writer& file, const RunStore& store, std::size_t index) {
  const HistoryColumn& column = store.columns()[index];
  const std::vector<double> values = store.column(index);
  require_finite("dynamic.histories.", column.name, values);
  const std::string path = "/dynamic/histories/" + dataset_path(column.name);
  make_groups_above(file, path, "Histories");
  file.create<double>(path, ResultField{"", column.units, column.description}, {values.size()}, kHistoryChunk);
  file.write_rows(path, 0, values);
}

void write_histories(Hdf5Writer& file, const RunStore& store) {
  if (store.rows() == 0) return;
  file.group("/dynamic/histories", "Quantities over time, a dataset each");
  const std::string time = "/dynamic/histories/" + dataset_path(store.columns()[0].name);
  for (std::size_t i = 0; i < store.columns().size(); ++i) {
    write_history(file, store, i);
    if (i == 0) file.make_scale(time, "time");
    if (i > 0 && i < kMaxScaledDatasets) {
      file.attach_scale("/dynamic/histories/" + dataset_path(store.columns()[i].name), time);
    }
  }
}

/// Columns of a table that is written in blocks of rows.
class BlockTable {
 public:
  BlockTable(Hdf5Writer& file, std::string group, hsize_t rows) : file_(file), group_(std::move(group)), rows_(rows) {}

  void operator()(const ResultField& field, double value) { column(field).numbers.push_back(value); }
  void operator()(const ResultField& field, int value) { column(field).integers.push_back(value); }
  void end_row() { next_ = 0; }

  /// Writes the rows collected since the last call.
  void write() {
    std::size_t count = 0;
    for (Column& c : columns_) {
      const std::string path = group_ + "/" + c.field.name;
      count = std::max(c.numbers.size(), c.integers.size());
      if (c.integers.empty()) {
        write(path, c.field, c.numbers);
      } else {
        write(path, c.field, c.integers);
      }
    }
    first_ += count;
  }

 private:
  struct Column {
    ResultField field;
    std::vector<double> numbers;
    std::vector<int> integers;
  };
  Column& column(const ResultField& field) {
    if (next_ == columns_.size()) columns_.push_back({field, {}, {}});
    return columns_[next_++];
  }
  template <class Number>
  void write(const std::string& path, const ResultField& field, std::vector<Number>& values) {
    if (first_ == 0) file_.create<Number>(path, field, {rows_}, kImpactBlock);
    file_.write_rows(path, first_, values);
    values.clear();
  }

  Hdf5Writer& file_;
  std::string group_;
  hsize_t rows_, first_ = 0;
  std::size_t next_ = 0;
  std::vector<Column> columns_;
};

void write_impacts(Hdf5Writer& file, const RunStore& store) {
  const std::int64_t count = store.impacts();
  if (count == 0) return;
  file.group("/dynamic/impacts", "All impacts of the pipe on rollers");
  BlockTable table(file, "/dynamic/impacts", static_cast<hsize_t>(count));
  FiniteVisitor finite{"dynamic.impacts."};
  for (std::int64_t first = 0; first < count; first += kImpactBlock) {
    for (const Impact& impact : store.impact_block(first, std::min(kImpactBlock, count - first))) {
      visit_impact(impact, finite);
      visit_impact(impact, table);
      table.end_row();
    }
    table.write();
  }
}

const std::array<ResultField, 5>& station_fields() {
  static const std::array<ResultField, 5> fields = {
      ResultField{"x", "m", "Place", kWorldFrame}, ResultField{"y", "m", "Place", kWorldFrame},
      ResultField{"z", "m", "Place", kWorldFrame}, ResultField{"effective_tension", "N", "Effective tension"},
      ResultField{"von_mises", "Pa", "Largest von Mises stress over the section"}};
  return fields;
}

const std::array<ResultField, 4>& line_fields() {
  static const std::array<ResultField, 4> fields = {
      ResultField{"line_x", "m", "Position on a mooring line", kWorldFrame},
      ResultField{"line_y", "m", "Position on a mooring line", kWorldFrame},
      ResultField{"line_z", "m", "Position on a mooring line", kWorldFrame},
      ResultField{"line_tension", "N", "Effective tension of a mooring line"}};
  return fields;
}

/// A dataset of the snapshots: `width` numbers of each from `offset` on, with the given stride.
struct SnapshotPart {
  ResultField field;
  std::vector<hsize_t> shape;
  std::size_t offset = 0, width = 1, stride = 1;
  const char* over = nullptr;  ///< Scale of the second dimension.

  std::string path() const { return "/dynamic/snapshots/" + field.name; }
};

std::vector<SnapshotPart> snapshot_parts(const RunStore& store) {
  const auto count = static_cast<hsize_t>(store.snapshots());
  const auto stations = static_cast<std::size_t>(store.stations());
  std::vector<SnapshotPart> parts = {{ResultField{"time", "s", "Time; 0 is the end of the build-up"}, {count}}};
  const std::size_t stride = station_fields().size();  // the values of a station are contiguous
  for (std::size_t i = 0; i < stride && stations > 0; ++i) {
    parts.push_back({station_fields()[i], {count, stations}, 1 + i, stations, stride, "/dynamic/stations/s"});
  }
  const std::size_t pose = 1 + stride * stations;
  parts.push_back({ResultField{"vessel_position", "m", "Origin of the vessel", kWorldFrame}, {count, 3}, pose, 3});
  parts.push_back({ResultField{"vessel_axes", "1", "Columns: vessel axes forward, port, up", kWorldFrame},
                   {count, 3, 3},
                   pose + 3,
                   9});
  const auto points = static_cast<std::size_t>(store.line_points());
  const std::size_t first = pose + 12, each = line_fields().size();
  for (std::size_t i = 0; i < each && points > 0; ++i) {
    parts.push_back({line_fields()[i], {count, points}, first + i, points, each, "/dynamic/moorings/points/index"});
  }
  return parts;
}

std::vector<double> extract_numbers(const SnapshotPart& part, const std::vector<double>& block, std::size_t size) {
  std::vector<double> values;
  values.reserve(block.size() / size * part.width);
  for (std::size_t start = 0; start < block.size(); start += size) {
    for (std::size_t i = 0; i < part.width; ++i) values.push_back(block[start + part.offset + i * part.stride]);
  }
  return values;
}

void write_snapshots(Hdf5Writer& file, const RunStore& store) {
  if (store.snapshots() == 0) return;
  file.group("/dynamic/snapshots", "Snapshots of the line and the vessel");
  const std::vector<SnapshotPart> parts = snapshot_parts(store);
  const auto size = static_cast<std::size_t>(store.snapshot_size());
  const std::int64_t rows = std::max(kMinSnapshots, kSnapshotNumbers / static_cast<std::int64_t>(size));
  for (const SnapshotPart& part : parts) {
    file.create<double>(part.path(), part.field, part.shape, static_cast<hsize_t>(rows));
  }
  for (std::int64_t first = 0; first < store.snapshots(); first += rows) {
    const std::vector<double> block = store.snapshot_block(first, std::min(rows, store.snapshots() - first));
    require_finite("dynamic.snapshots", "", block);
    for (const SnapshotPart& part : parts) {
      file.write_rows(part.path(), static_cast<hsize_t>(first), extract_numbers(part, block, size));
    }
  }
  file.make_scale(parts.front().path(), "time");
  for (const SnapshotPart& part : parts) {
    if (&part != &parts.front()) file.attach_scale(part.path(), parts.front().path());
    if (part.over != nullptr && file.has(part.over)) file.attach_scale(part.path(), part.over, 1);
  }
}

}  // namespace

void write_long_data(Hdf5Writer& file, const RunStore& store) {
  write_histories(file, store);
  write_impacts(file, store);
  write_snapshots(file, store);
}

}  // namespace overbend
