#include "hull/make_hull.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hull/damping_ratios.h"

namespace overbend {
namespace {

constexpr double kLevelTolerance = 1e-3;  // of the file's origin and the centre of gravity [m]
constexpr double kMunkFrequency = 0.1;    // where the added mass stands for that of slow drift [rad/s]

Eigen::Vector2d towards(double speed, double from_azimuth) {
  return {-speed * std::sin(from_azimuth), -speed * std::cos(from_azimuth)};
}

/// Velocity of the current at a height of W, linear between the rows.
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
    return coordinates_of(pose.p_WV + pose.R_WV * centre_of_gravity, pose.R_WV);
  };
  hull.reference_V = centre_of_gravity;
  hull.drawn = coordinates(model.drawn_pose);
  hull.lies = coordinates(model.mean_pose);
  if (const auto& dp = model.description.station_keeping) {
    hull.station_keeping.emplace(
        StationKeeping{.wanted = Vec3(hull.drawn(0), hull.drawn(1), hull.drawn(5)), .law = *dp});
  }
}

/// A table of the model with the areas it refers to: where they are not given those of a box that stands `height` high
/// in the flow. Throws for a table that was not read.
template <class Given>
CoefficientTable table_of(const Given& given, const VesselDescription& vessel, double height, const char* flow) {
  if (!given.axes || given.table.empty()) {
    throw std::invalid_argument("a table of " + std::string(flow) +
                                " coefficients needs its rows and the convention of its axes");
  }
  return {given.frontal_area.value_or(vessel.beam * height), given.lateral_area.value_or(vessel.length * height),
          given.length.value_or(vessel.length), coefficients_from_bow(given.table, *given.axes)};
}

/// Current on the hull: coefficients for the hull's size, the velocity at half the draught.
HullCurrent current_on(const Model& model, const CoupledHullDescription& hull) {
  const VesselDescription& vessel = model.description.vessel;
  const HullCurrentDescription& given = hull.current;
  HullCurrent c;
  c.form = given.form;
  c.velocity = current_at(model.current, -0.5 * vessel.draught);
  c.water_density = model.water_density;
  c.length = vessel.length;
  c.beam = vessel.beam;
  c.draught = vessel.draught;
  c.reference_V = hull.centre_of_gravity;
  c.transverse = given.transverse;
  c.longitudinal = given.longitudinal;
  c.wetted_surface = vessel.length * vessel.beam + 2.0 * vessel.draught * (vessel.length + vessel.beam);
  c.in_water = given.relative_to == CurrentRelativeTo::water;
  if (given.form == HullCurrentForm::ufc) {
    const UfcHull shape = ufc_hull(model, hull);
    c.transverse = ufc_transverse_coefficient(shape, model.description.environment.water_depth);
    c.longitudinal = kUfcFormDrag;
    c.wetted_surface = ufc_wetted_surface(shape);
  }
  if (given.form == HullCurrentForm::table) {
    c.table = table_of(given, vessel, vessel.draught, "current");
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
    wind.table = table_of(hull.wind, vessel, vessel.depth - vessel.draught, "wind");
  }
  return wind;
}

void put_loads(Hull& hull, const Model& model) {
  const Mat3 R = vessel_axes(model.description.vessel.heading, 0.0, 0.0);  // level, as in statics: down is down
  for (const VesselLoadDescription& load : model.description.vessel.loads) {
    hull.loads.push_back({load.at - hull.reference_V, R * load.force, R * load.moment});
  }
}

std::size_t mode_of(const std::string& name) {
  const auto found = std::find(kFreedomNames.begin(), kFreedomNames.end(), name);
  if (found == kFreedomNames.end()) throw std::invalid_argument("no mode of damping: " + name);
  return static_cast<std::size_t>(found - kFreedomNames.begin());
}

/// Of dynamic positioning, in surge, sway and yaw.
double positioning_stiffness(const Hull& hull, Eigen::Index mode) {
  if (!hull.station_keeping || (mode > 1 && mode < 5)) return 0.0;
  return hull.station_keeping->law.stiffness(mode == 5 ? 2 : mode);
}

void put_damping(Hull& hull, const CoupledHullDescription& given, const Mat6& station_stiffness) {
  for (const ModeDampingDescription& mode : given.damping) {
    const auto k = static_cast<Eigen::Index>(mode_of(mode.mode));
    hull.damping.linear(k, k) += mode.linear.value_or(0.0);
    hull.damping.quadratic(k) += mode.quadratic.value_or(0.0);
    if (!mode.ratio) continue;
    const double stiffness = hull.hydrostatics(k, k) + station_stiffness(k, k) + positioning_stiffness(hull, k);
    const double mass = k < 3 ? hull.body.mass : hull.body.inertia(k - 3, k - 3);
    if (!(stiffness > 0.0)) {
      throw std::invalid_argument("a share of critical damping in " + mode.mode +
                                  " needs a stiffness, which this hull has not: give the coefficients instead");
    }
    hull.damping.linear(k, k) += *mode.ratio * critical_damping(*given.data, static_cast<int>(k), mass, stiffness);
  }
}

void put_waves(Hull& hull, const Model& model, const Sea& sea, const CoupledHullDescription& given) {
  const HydrodynamicData& data = *given.data;
  hull.waves = make_hull_waves(data, sea, given.wave_drift, model.description.vessel.draught, hull.lies(5));
  if (given.wave_drift_damping == WaveDriftDamping::aranha) {
    hull.drift_damping = wave_drift_damping(data, sea, hull.lies(5));
  }
  if (given.current.form == HullCurrentForm::strips || given.current.form == HullCurrentForm::ufc) {
    const Mat6 A = added_mass_at(data, kMunkFrequency);
    hull.munk = A(1, 1) - A(0, 0);
  }
}

void check(const CoupledHullDescription& given) {
  if (!given.data) {
    throw std::invalid_argument("the hydrodynamic coefficients, " + given.hydrodynamics + ", could not be read");
  }
  if ((given.data->origin_V - given.centre_of_gravity).norm() > kLevelTolerance) {
    throw std::invalid_argument("the coefficients in " + given.data->source +
                                " must refer to the hull's centre of gravity");
  }
}

Hull afloat(const Model& model, const Sea& sea, const CoupledHullDescription& given) {
  check(given);
  Hull hull = hull_in_surroundings(model, given, sea);
  hull.body.mass = given.mass;
  hull.body.inertia = (given.mass * given.gyration.cwiseAbs2()).asDiagonal();
  hull.hydrostatics.block<3, 3>(2, 2) = given.data->hydrostatic_stiffness.block<3, 3>(2, 2);
  return hull;
}

Hull afloat(const Model& model, const HydrostaticsDescription& given) {
  Hull hull;
  place(hull, model, Vec3::Zero());
  hull.hydrostatics.diagonal().segment<3>(2) = Vec3(given.heave, given.roll, given.pitch);
  return hull;
}

void remember_waves(MadeHull& made, const CoupledHullDescription& given, const Mat6& station_stiffness) {
  Hull& hull = made.hull;
  Radiated radiated = make_radiation(*given.data, given.radiation);
  hull.radiation = std::move(radiated.model);
  made.radiation = std::move(radiated.report);
  made.findings = made.radiation.findings;
  hull.slow_period = given.slow_period;
  put_damping(hull, given, station_stiffness);
}

}  // namespace

UfcHull ufc_hull(const Model& model, const CoupledHullDescription& given) {
  const VesselDescription& vessel = model.description.vessel;
  return {vessel.length, vessel.beam, vessel.draught, vessel.beam * vessel.draught, given.mass / model.water_density};
}

Hull hull_in_surroundings(const Model& model, const CoupledHullDescription& given, const Sea& sea) {
  Hull hull;
  place(hull, model, given.centre_of_gravity);
  hull.current = current_on(model, given);
  hull.wind = wind_on(model.description.vessel, given);
  if (given.data) put_waves(hull, model, sea, given);
  return hull;
}

Hull make_hull_at_rest(const Model& model, const Sea& sea) {
  const VesselDescription& vessel = model.description.vessel;
  if (!vessel.coupled && !vessel.hydrostatics) {
    throw std::invalid_argument("a hull that floats free needs vessel.motion.coupled or vessel.hydrostatics");
  }
  Hull hull = vessel.coupled ? afloat(model, sea, *vessel.coupled) : afloat(model, *vessel.hydrostatics);
  put_loads(hull, model);
  return hull;
}

MadeHull make_hull(const Model& model, const Sea& sea, double build_up, const Mat6& station_stiffness) {
  MadeHull made;
  made.hull = make_hull_at_rest(model, sea);
  if (const auto& coupled = model.description.vessel.coupled) remember_waves(made, *coupled, station_stiffness);
  made.hull.build_up = build_up;
  return made;
}

}  // namespace overbend
