#include "report/static/mooring_scene.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

constexpr double kBeyondTouchdown = 60.0;  ///< length of laid pipe shown behind touchdown [m]
constexpr std::size_t kPipePoints = 200;

/// Azimuth of a horizontal direction, clockwise from north [rad].
double azimuth(const Vec3& direction_W) {
  return std::atan2(direction_W.x(), direction_W.y());
}

std::vector<Vec3> pipe_points(const StaticResults& lay) {
  std::vector<Vec3> all;
  for (auto station = lay.stations.rbegin(); station != lay.stations.rend(); ++station) {
    if (station->s < lay.touchdown.s - kBeyondTouchdown) break;
    all.push_back(station->p_W);
  }
  const std::size_t stride = all.size() / kPipePoints + 1;
  std::vector<Vec3> some;
  for (std::size_t i = 0; i < all.size(); i += stride) some.push_back(all[i]);
  if (!all.empty()) some.push_back(all.back());
  return some;
}

/// The vessel in its nominal pose, and the objects on the seabed and in the water around it.
MooringScene surroundings(const Description& description) {
  MooringScene scene;
  scene.length = description.vessel.length;
  scene.beam = description.vessel.beam;
  scene.heading = description.vessel.heading;
  scene.water_depth = description.environment.water_depth;
  if (description.moorings) scene.objects = description.moorings->objects;
  const EnvironmentDescription& sea = description.environment;
  for (const WavesDescription& waves : sea.waves) {
    if (waves.type != WaveType::none) scene.waves_from.push_back(waves.from);
  }
  if (!sea.current.empty() && sea.current.front().speed > 0.0) scene.current_to = sea.current.front().towards;
  return scene;
}

}  // namespace

MooringScene mooring_scene(const std::optional<Description>& description, const StaticResults& results) {
  MooringScene scene = description ? surroundings(*description) : MooringScene{};
  if (!results.has_pipe()) return scene;
  scene.pipe_W = pipe_points(results);
  scene.touchdown_W = results.touchdown.p_W;
  scene.length = results.vessel_length;
  scene.beam = results.vessel_beam;
  scene.water_depth = results.water_depth;
  if (!description) scene.heading = azimuth(results.R_WV.col(0));
  return scene;
}

}  // namespace overbend
