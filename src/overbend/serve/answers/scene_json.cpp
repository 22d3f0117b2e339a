#include <algorithm>
#include <cmath>

#include "dynamics/integrator/dynamics.h"
#include "mechanics/sea.h"
#include "model/bodies.h"
#include "model/site/seabed_shape.h"
#include "model/vessel/mooring_queries.h"
#include "report/page/json_number.h"
#include "serve/answers/static_json.h"

namespace overbend {
namespace {

constexpr std::size_t kMaxWaves = 1000;

/// Returns the position, or null if it does not exist.
Json where(bool exists, const Vec3& place) {
  return exists ? place_json(place) : Json(nullptr);
}

Json hull_box(const std::string& name, const VesselDescription& v, const VesselPose& pose) {
  return {{"name", name},      {"length", v.length},   {"beam", v.beam},
          {"height", v.depth}, {"draught", v.draught}, {"pose", pose_json(pose.p_WV, pose.R_WV)}};
}

Json vessel(const Model& model) {
  if (!has_vessel(model.description)) return nullptr;
  const VesselDescription& v = model.description.vessel;
  return hull_box(v.name, v, model.mean_pose);
}

/// Returns the bodies other than the vessel in their nominal poses.
Json bodies(const Model& model) {
  Json list = Json::array();
  for (const BodyDescription& body : model.description.bodies) {
    list.push_back(hull_box(body.name, body.hull, body_pose(body)));
  }
  return list;
}

Json structure(const Model& model, Structure which) {
  Json boxes = Json::array();
  for (const SupportBox& box : model.supports.boxes) {
    if (box.structure != which) continue;
    boxes.push_back({{"name", box.name},
                     {"place", place_json(point_from_ramp(model, model.mean_pose, box.point_S))},
                     {"direction", place_json(direction_from_ramp(model.mean_pose, box.direction_S))},
                     {"length", seven_digits(box.length)}});
  }
  return boxes;
}

Json current(const Model& model) {
  Json rows = Json::array();
  for (std::size_t i = model.current.z.size(); i-- > 0;) {
    rows.push_back({{"depth", seven_digits(-model.current.z[i])},
                    {"velocity", place_json({model.current.vx[i], model.current.vy[i], 0.0})}});
  }
  return rows;
}

/// Returns the largest wave components of the sea of a dynamic run.
Json waves(const Model& model, std::uint64_t seed) {
  const Description& d = model.description;
  Sea sea;
  try {
    sea = make_sea(d.environment.waves, d.environment.water_depth, seed);
  } catch (const std::logic_error&) {
    return Json::array();  // a dynamic run reports the error; the view shows still water
  }
  std::vector<WaveComponent> components = sea.components;
  std::stable_sort(components.begin(), components.end(),
                   [](const WaveComponent& a, const WaveComponent& b) { return a.amplitude > b.amplitude; });
  components.resize(std::min(components.size(), kMaxWaves));
  Json list = Json::array();
  for (const WaveComponent& wave : components) {
    list.push_back({{"amplitude", seven_digits(wave.amplitude)},
                    {"number", seven_digits(wave.wave_number)},
                    {"frequency", seven_digits(wave.omega)},
                    {"phase", seven_digits(wave.phase)},
                    {"direction", seven_digits(std::atan2(wave.ky, wave.kx))}});
  }
  return list;
}

/// Returns the seabed objects to which clearances are computed.
Json objects(const Description& d) {
  Json list = Json::array();
  if (!d.moorings) return list;
  for (const SeabedObjectDescription& object : d.moorings->objects) {
    Json points = Json::array();
    for (const Vec3& point : object.points) points.push_back(place_json(point));
    list.push_back({{"name", object.name}, {"points", points}});
  }
  return list;
}

/// Returns evenly selected indices of at most about `kMaxKnots` knots, including the last.
std::vector<std::size_t> drawn_knots(std::size_t count) {
  constexpr std::size_t kMaxKnots = 150;
  const std::size_t step = (count + kMaxKnots - 1) / kMaxKnots;
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i + 1 < count; i += step) drawn.push_back(i);
  drawn.push_back(count - 1);
  return drawn;
}

/// Returns heights of an uneven seabed for linear interpolation: along a profile with origin and direction, or at the
/// knots of a grid.
Json bed_shape(const SeabedSurface& bed) {
  const SeabedShape* shape = bed.shape();
  if (shape == nullptr) return nullptr;
  Json json = {{"x", Json::array()}, {"z", Json::array()}};
  if (shape->y.empty()) {
    constexpr int kParts = 8;  // of each interval
    json["origin"] = {seven_digits(shape->origin[0]), seven_digits(shape->origin[1])};
    json["along"] = {seven_digits(shape->along[0]), seven_digits(shape->along[1])};
    for (int i = 0; i <= kParts * (static_cast<int>(shape->x.size()) - 1); ++i) {
      const std::size_t from = std::min(static_cast<std::size_t>(i / kParts), shape->x.size() - 2);
      const double part = static_cast<double>(i) / kParts - static_cast<double>(from);
      const double x = shape->x[from] + part * (shape->x[from + 1] - shape->x[from]);
      json["x"].push_back(seven_digits(x));
      json["z"].push_back(
          seven_digits(bed.height(shape->origin[0] + x * shape->along[0], shape->origin[1] + x * shape->along[1])));
    }
    return json;
  }
  const std::vector<std::size_t> columns = drawn_knots(shape->x.size()), rows = drawn_knots(shape->y.size());
  for (const std::size_t column : columns) json["x"].push_back(seven_digits(shape->x[column]));
  for (const std::size_t row : rows) {
    json["y"].push_back(seven_digits(shape->y[row]));
    for (const std::size_t column : columns) {
      json["z"].push_back(seven_digits(shape->z[row * shape->x.size() + column]));
    }
  }
  return json;
}

/// Returns the outer radius of the pipe [m]; 0 without a pipe.
double outer_radius(const Model& model) {
  return model.sections.empty() ? 0.0 : 0.5 * model.pipe_section().outer_diameter;
}

}  // namespace

Json scene_json(const Model& model, std::optional<std::uint64_t> seed) {
  const TensionerDescription& tensioner = model.description.tensioner;
  const Vec3 p_S(tensioner.x, 0.0, tensioner.z);
  const Vec3 shoe = point_from_ramp(model, model.mean_pose, Vec3::Zero());
  const SeabedSurface& bed = model.seabed.surface;
  return {{"status", "ok"},
          {"vessel", vessel(model)},
          {"bodies", bodies(model)},
          {"ramp", structure(model, Structure::ramp)},
          {"stinger", structure(model, Structure::stinger)},
          {"stern_shoe", where(model.description.has_pipe, shoe)},
          {"tensioner", where(model.description.has_pipe, point_from_ramp(model, model.mean_pose, p_S))},
          {"water_depth", seven_digits(model.description.environment.water_depth)},
          {"seabed",
           {{"normal", place_json(bed.normal(shoe.x(), shoe.y()))},
            {"point", place_json({shoe.x(), shoe.y(), bed.height(shoe.x(), shoe.y())})},
            {"shape", bed_shape(bed)}}},
          {"current", current(model)},
          {"waves", waves(model, seed.value_or(dynamic_options(model).seed))},
          {"objects", objects(model.description)},
          {"pipe", {{"outer_radius", seven_digits(outer_radius(model))}}}};
}

}  // namespace overbend
