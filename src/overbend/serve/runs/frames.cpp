#include "report/page/json_number.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "resultfiles/dynamic/long_data_reader.h"
#include "serve/http/base64.h"
#include "serve/runs/run_data.h"

namespace overbend {
namespace {

/// Returns values at the stations of every frame, from the tensioner to the anchor, as float32 in base64. `parts` are
/// interleaved.
std::string stations(const SnapshotBlock& block, std::initializer_list<const std::vector<double>*> parts) {
  std::vector<float> numbers;
  const auto count = static_cast<std::size_t>(block.stations);
  numbers.reserve(block.time.size() * count * parts.size());
  for (std::size_t frame = 0; frame < block.time.size(); ++frame) {
    for (std::size_t i = count; i-- > 0;) {
      for (const std::vector<double>* part : parts) numbers.push_back(static_cast<float>((*part)[frame * count + i]));
    }
  }
  return base64_floats(numbers);
}

Json pose(const SnapshotBlock& block, std::size_t frame) {
  Json numbers = Json::array();
  for (std::size_t i = 0; i < 3; ++i) numbers.push_back(seven_digits(block.vessel_position[3 * frame + i]));
  for (std::size_t i = 0; i < 9; ++i) numbers.push_back(seven_digits(block.vessel_axes[9 * frame + i]));
  return numbers;
}

/// A line stored in the snapshots.
struct SnapshotLine {
  std::string name;
  std::size_t points = 0;
  bool backwards = false;  ///< The page uses the reverse order of the file.
};

/// Returns the mooring lines (from the fairlead on the page, from the anchor in the file) and the separate lines (from
/// end A).
std::vector<SnapshotLine> snapshot_lines(const DynamicResults& results) {
  std::vector<SnapshotLine> lines;
  for (const MooringLineDynamics& line : results.moorings) lines.push_back({line.name, line.points.size(), true});
  for (const LineDynamics& line : results.lines) lines.push_back({line.name, line.min_tension_at_nodes.size(), false});
  return lines;
}

Json lines_json(const std::vector<SnapshotLine>& lines) {
  Json list = Json::array();
  for (const SnapshotLine& line : lines) list.push_back({{"name", line.name}, {"points", line.points}});
  return list;
}

/// Returns the points of all lines of every frame, line by line, as float32 in base64.
std::string line_places(const SnapshotBlock& block, const std::vector<SnapshotLine>& lines) {
  std::vector<float> numbers;
  const auto count = static_cast<std::size_t>(block.line_points);
  numbers.reserve(3 * block.time.size() * count);
  for (std::size_t frame = 0; frame < block.time.size(); ++frame) {
    std::size_t first = frame * count;
    for (const SnapshotLine& line : lines) {
      for (std::size_t i = 0; i < line.points; ++i) {
        const std::size_t point = first + (line.backwards ? line.points - 1 - i : i);
        for (const auto* part : {&block.line_x, &block.line_y, &block.line_z}) {
          numbers.push_back(static_cast<float>((*part)[point]));
        }
      }
      first += line.points;
    }
  }
  return base64_floats(numbers);
}

}  // namespace

Json frames_json(const std::filesystem::path& h5, std::int64_t first, std::int64_t count) {
  const SnapshotBlock block = read_snapshots(h5, first, count);
  Json times = Json::array(), poses = Json::array();
  for (std::size_t frame = 0; frame < block.time.size(); ++frame) {
    times.push_back(seven_digits(block.time[frame]));
    poses.push_back(pose(block, frame));
  }
  Json answer = {{"total", block.total},
                 {"from", first},
                 {"stations", block.stations},
                 {"time", times},
                 {"pose", poses},
                 {"place", stations(block, {&block.x, &block.y, &block.z})},
                 {"effective_tension", stations(block, {&block.effective_tension})},
                 {"von_mises", stations(block, {&block.von_mises})}};
  if (block.line_points > 0) {
    const std::vector<SnapshotLine> lines = snapshot_lines(read_dynamic_results(h5).results);
    answer["lines"] = lines_json(lines);
    answer["line_place"] = line_places(block, lines);
  }
  return answer;
}

}  // namespace overbend
