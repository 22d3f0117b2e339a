#include "report/page/json_number.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "resultfiles/dynamic/long_data_reader.h"
#include "serve/http/base64.h"
#include "serve/runs/run_data.h"

namespace overbend {
namespace {

/// The stations of every frame from the tensioner on, as float32 in base64. `parts` are interleaved.
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

/// Mooring lines with the number of their points.
Json lines(const std::vector<MooringLineDynamics>& moorings) {
  Json list = Json::array();
  for (const MooringLineDynamics& line : moorings) {
    list.push_back({{"name", line.name}, {"points", line.points.size()}});
  }
  return list;
}

/// The points of the lines of every frame, line by line from the fairlead to the anchor, as float32 in base64; the
/// file has them the other way round.
std::string line_places(const SnapshotBlock& block, const std::vector<MooringLineDynamics>& moorings) {
  std::vector<float> numbers;
  const auto count = static_cast<std::size_t>(block.line_points);
  numbers.reserve(3 * block.time.size() * count);
  for (std::size_t frame = 0; frame < block.time.size(); ++frame) {
    std::size_t first = frame * count;
    for (const MooringLineDynamics& line : moorings) {
      for (std::size_t i = line.points.size(); i-- > 0;) {
        for (const auto* part : {&block.line_x, &block.line_y, &block.line_z}) {
          numbers.push_back(static_cast<float>((*part)[first + i]));
        }
      }
      first += line.points.size();
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
    const std::vector<MooringLineDynamics> moorings = read_dynamic_results(h5).results.moorings;
    answer["lines"] = lines(moorings);
    answer["line_place"] = line_places(block, moorings);
  }
  return answer;
}

}  // namespace overbend
