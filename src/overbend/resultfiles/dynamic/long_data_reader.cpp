#include "resultfiles/dynamic/long_data_reader.h"

#include <algorithm>

#include "resultfiles/hdf5/dataset_path.h"
#include "resultfiles/hdf5/hdf5_readers.h"

namespace overbend {

std::vector<HistoryColumn> read_history_columns(const std::filesystem::path& h5) {
  const Hdf5Reader file(h5);
  TableReader table(file, "/dynamic/thinned");
  std::vector<HistoryColumn> columns(table.rows("index"));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    table.start_row(i);
    table(ResultField{"name"}, columns[i].name);
    table(ResultField{"units"}, columns[i].units);
    table(ResultField{"meaning"}, columns[i].description);
  }
  return columns;
}

std::vector<double> read_history(const std::filesystem::path& h5, const std::string& name) {
  return Hdf5Reader(h5).doubles("/dynamic/histories/" + dataset_path(name));
}

SnapshotBlock read_snapshots(const std::filesystem::path& h5, std::int64_t first, std::int64_t count) {
  const Hdf5Reader file(h5);
  SnapshotBlock block;
  if (!file.has("/dynamic/snapshots")) return block;
  block.total = static_cast<std::int64_t>(file.lines("/dynamic/snapshots/time"));
  const auto from = static_cast<hsize_t>(std::clamp<std::int64_t>(first, 0, block.total));
  const auto max_count =
      static_cast<hsize_t>(std::clamp<std::int64_t>(count, 0, block.total - static_cast<std::int64_t>(from)));
  const auto read = [&](const char* name) {
    return file.doubles(std::string("/dynamic/snapshots/") + name, from, max_count);
  };
  block.time = read("time");
  if (file.has("/dynamic/stations/s")) {  // without it there is no pipe
    block.stations = static_cast<std::int64_t>(file.lines("/dynamic/stations/s"));
    block.x = read("x");
    block.y = read("y");
    block.z = read("z");
    block.effective_tension = read("effective_tension");
    block.von_mises = read("von_mises");
  }
  block.vessel_position = read("vessel_position");
  block.vessel_axes = read("vessel_axes");
  if (!file.has("/dynamic/snapshots/line_x")) return block;
  block.line_points = static_cast<std::int64_t>(file.lines("/dynamic/moorings/points/index"));
  block.line_x = read("line_x");
  block.line_y = read("line_y");
  block.line_z = read("line_z");
  block.line_tension = read("line_tension");
  return block;
}

}  // namespace overbend
