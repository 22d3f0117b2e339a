#include "hull/make_hull.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hull/damping_ratios.h"

namespace overbend {
namespace {

constexpr double kLevelTolerance = 1e-3;  // maximum distance of the file's origin from the centre of gravity [m]
constexpr double kMunkFrequency = 0.1;    // at which the added mass stands for that of slow drift [rad/s]

Eigen::Vector2d towards(double speed, double from_azimuth) {
  return {-speed * std::sin(from_azimuth), -speed * std::cos(from_azimuth)};
}

/// Current velocity at a height of W, linear between the rows.
Eigen::Vector2d current_at(const CurrentProfile& profile, double z) {
  if (profile.z.empty()) return Eigen::Vector2d::Zero();
  const auto after = std::upper_bound(profile.z.begin(), profile.z.end(), z);
  const auto high = std::min<std::size_t>(after - profile.z.begin(), profile.z.size() - 1);
  const std::size_t low = after == profile.z.begin() ? 0 : after - profile.z.begin() - 1;
  const double gap = profile.z[high] - profile.z[low];
  const double share = gap > 0.0 ? (z - profile.z[low]) / gap : 0.0;
  return {profile.vx[low] + share * (profile.vx[high] - profile.vx[low]),
          profile.vy[low] + share * (profile.vy[high] - profile.vy[low])};
}

void place(Hull& hull, const Model& model, const Vec3& centre_of_gravity) {
  const auto coordinates = [&](const VesselPose& pose) {
    return make_coordinates(pose.p_WV + pose.R_WV * centre_of_gravity, pose.R_WV);
  };
  hull.reference_V = centre_of_gravity;
  hull.drawn = coordinates(model.nominal_pose);
  hull.lies = coordinates(model.mean_pose);
  if (const auto& dp = model.description.station_keeping) {
    hull.station_keeping.emplace(
        StationKeeping{.wanted = Vec3(hull.drawn(0), hull.drawn(1), hull.drawn(5)), .law = *dp});
  }
}

/// A table of the model with its reference areas, by default those of a box that extends `height` across the flow.
/// Throws if the table was not read.
template <class Given>
CoefficientTable make_table(const Given& description, const VesselDescription& vessel, double height,
                            const char* flow) {
  if (!description.axes || description.table.empty()) {
    throw std::invalid_argument("a table of " + std::string(flow) +
                                " coefficients needs its rows and the convention of its axes");
  }
  return {description.frontal_area.value_or(vessel.beam * height),
          description.lateral_area.value_or(vessel.length * height), description.length.value_or(vessel.length),
          coefficients_from_bow(description.table, *description.axes)};
}

/// Current on the hull: coefficients for the hull's size, velocity at half the draught.
HullCurrent current_on(const Model& model, const CoupledHullDescription& hull) {
  const VesselDescription& vessel = model.description.vessel;
  const HullCurrentDescription& description = hull.current;
  HullCurrent c;
  c.form = description.form;
  c.velocity = current_at(model.current, -0.5 * vessel.draught);
  c.water_density = model.water_density;
  c.length = vessel.length;
  c.beam = vessel.beam;
  c.draught = vessel.draught;
  c.reference_V = hull.centre_of_gravity;
  c.transverse = description.transverse;
  c.longitudinal = description.longitudinal;
  c.wetted_surface = vessel.length * vessel.beam + 2.0 * vessel.draught * (vessel.length + vessel.beam);
  c.in_water = description.relative_to == CurrentRelativeTo::water;
  if (description.form == HullCurrentModel::ufc) {
    const UfcHull shape = ufc_hull(model, hull);
    c.transverse = ufc_transverse_coefficient(shape, model.description.environment.water_depth);
    c.longitudinal = kUfcFormDrag;
    c.wetted_surface = ufc_wetted_surface(shape);
  }
  if (description.form == HullCurrentModel::table) {
    c.table = make_table(description, vessel, vessel.draught, "current");
  }
  return c;
}

HullWind wind_on(const VesselDescription& vessel, const CoupledHullDescription& hull) {
  HullWind wind;
  wind.velocity = towards(hull.wind.speed, hull.wind.from);
  wind.density = hull.wind.air_density;
  wind.reference_V = hull.centre_of_gravity;
  wind.areas = hull.wind.areas;
  if (!hull.wind.table_file.empty()) {
    wind.table = make_table(hull.wind, vessel, vessel.depth - vessel.draught, "wind");
  }
  return wind;
}

void put_loads(Hull& hull, const Model& model) {
  // level, as in statics: vertical loads stay vertical
  const Mat3 R = vessel_axes(model.description.vessel.heading, 0.0, 0.0);
  for (const VesselLoadDescription& load : model.description.vessel.loads) {
    hull.loads.push_back({load.at - hull.reference_V, R * load.force, R * load.moment});
  }
}

std::size_t find_mode(const std::string& name) {
  const auto found = std::find(kFreedomNames.begin(), kFreedomNames.end(), name);
  if (found == kFreedomNames.end()) throw std::invalid_argument("unknown damping mode: " + name);
  return static_cast<std::size_t>(found - kFreedomNames.begin());
}

/// Stiffness of dynamic positioning in surge, sway and yaw.
double positioning_stiffness(const Hull& hull, Eigen::Index mode) {
  if (!hull.station_keeping || (mode > 1 && mode < 5)) return 0.0;
  return hull.station_keeping->law.stiffness(mode == 5 ? 2 : mode);
}

void put_damping(Hull& hull, const CoupledHullDescription& description, const Mat6& station_stiffness) {
  for (const ModeDampingDescription& mode : description.damping) {
    const auto k = static_cast<Eigen::Index>(find_mode(mode.mode));
    hull.damping.linear(k, k) += mode.linear.value_or(0.0);
    hull.damping.quadratic(k) += mode.quadratic.value_or(0.0);
    if (!mode.ratio) continue;
    const double stiffness = hull.hydrostatics(k, k) + station_stiffness(k, k) + positioning_stiffness(hull, k);
    const double mass = k < 3 ? hull.body.mass : hull.body.inertia(k - 3, k - 3);
    if (!(stiffness > 0.0)) {
      throw std::invalid_argument("a damping ratio in " + mode.mode +
                                  " needs a stiffness, which this hull does not have: give the coefficients instead");
    }
    hull.damping.linear(k, k) +=
        *mode.ratio * critical_damping(*description.data, static_cast<int>(k), mass, stiffness);
  }
}

void put_waves(Hull& hull, const Model& model, const Sea& sea, const CoupledHullDescription& description) {
  const HydrodynamicData& data = *description.data;
  hull.waves = make_hull_waves(data, sea, description.wave_drift, model.description.vessel.draught, hull.lies(5));
  if (description.wave_drift_damping == WaveDriftDamping::aranha) {
    hull.drift_damping = wave_drift_damping(data, sea, hull.lies(5));
  }
  if (description.current.form == HullCurrentModel::strips || description.current.form == HullCurrentModel::ufc) {
    const Mat6 A = added_mass_at(data, kMunkFrequency);
    hull.munk = A(1, 1) - A(0, 0);
  }
}

void check(const CoupledHullDescription& description) {
  if (!description.data) {
    throw std::invalid_argument("the hydrodynamic coefficients, " + description.hydrodynamics + ", could not be read");
  }
  if ((description.data->origin_V - description.centre_of_gravity).norm() > kLevelTolerance) {
    throw std::invalid_argument("the coefficients in " + description.data->source +
                                " must refer to the hull's centre of gravity");
  }
}

Hull make_floating_hull(const Model& model, const Sea& sea, const CoupledHullDescription& description) {
  check(description);
  Hull hull = make_hull_in_environment(model, description, sea);
  hull.body.mass = description.mass;
  hull.body.inertia = (description.mass * description.gyration.cwiseAbs2()).asDiagonal();
  hull.hydrostatics.block<3, 3>(2, 2) = description.data->hydrostatic_stiffness.block<3, 3>(2, 2);
  return hull;
}

Hull make_floating_hull(const Model& model, const HydrostaticsDescription& description) {
  Hull hull;
  place(hull, model, Vec3::Zero());
  hull.hydrostatics.diagonal().segment<3>(2) = Vec3(description.heave, description.roll, description.pitch);
  return hull;
}

void add_radiation(MadeHull& made, const CoupledHullDescription& description, const Mat6& station_stiffness) {
  Hull& hull = made.hull;
  Radiated radiated = make_radiation(*description.data, description.radiation);
  hull.radiation = std::move(radiated.model);
  made.radiation = std::move(radiated.report);
  made.findings = made.radiation.findings;
  hull.low_frequency_period = description.low_frequency_period;
  put_damping(hull, description, station_stiffness);
}

}  // namespace

UfcHull ufc_hull(const Model& model, const CoupledHullDescription& description) {
  const VesselDescription& vessel = model.description.vessel;
  return {vessel.length, vessel.beam, vessel.draught, vessel.beam * vessel.draught,
          description.mass / model.water_density};
}

Hull make_hull_in_environment(const Model& model, const CoupledHullDescription& description, const Sea& sea) {
  Hull hull;
  place(hull, model, description.centre_of_gravity);
  hull.current = current_on(model, description);
  hull.wind = wind_on(model.description.vessel, description);
  if (description.data) put_waves(hull, model, sea, description);
  return hull;
}

Hull make_hull_at_rest(const Model& model, const Sea& sea) {
  const VesselDescription& vessel = model.description.vessel;
  if (!vessel.coupled && !vessel.hydrostatics) {
    throw std::invalid_argument("a floating hull needs vessel.motion.coupled or vessel.hydrostatics");
  }
  Hull hull = vessel.coupled ? make_floating_hull(model, sea, *vessel.coupled)
                             : make_floating_hull(model, *vessel.hydrostatics);
  put_loads(hull, model);
  return hull;
}

MadeHull make_hull(const Model& model, const Sea& sea, double build_up, const Mat6& station_stiffness) {
  MadeHull made;
  made.hull = make_hull_at_rest(model, sea);
  if (const auto& coupled = model.description.vessel.coupled) add_radiation(made, *coupled, station_stiffness);
  made.hull.build_up = build_up;
  return made;
}

}  // namespace overbend
