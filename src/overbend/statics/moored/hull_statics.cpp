#include "statics/moored/hull_statics.h"

#include <algorithm>
#include <numbers>

#include "hull/hull_report.h"
#include "model/site/wave_groups.h"
#include "model/waves/rao_table.h"
#include "moorings/equilibrium.h"

namespace overbend {
namespace {

const char* freedom_name(int mode) {
  return kFreedomNames[static_cast<std::size_t>(mode)];
}

std::string join_mode_names(const std::vector<int>& modes) {
  std::string names;
  for (const int mode : modes) names += (names.empty() ? "" : ", ") + std::string(freedom_name(mode));
  return names;
}

void add_radiation_results(const RadiationReport& report, HullResults& out) {
  out.states = report.states;
  for (const RadiationEntryReport& entry : report.entries) {
    out.entries.push_back({freedom_name(entry.i), freedom_name(entry.j), entry.tail_exponent, entry.added_mass_file,
                           entry.added_mass_used, entry.damping_error, entry.mass_error});
  }
  for (const RadiationGroupReport& group : report.groups) {
    out.groups.push_back({join_mode_names(group.modes), group.order > 0 ? "state space" : "convolution", group.order,
                          group.min_fitted_damping, group.min_fitted_damping_omega, group.added_damping});
  }
}

/// Damping of the file, linearly interpolated; constant below the first frequency.
double file_damping(const HydrodynamicData& data, int mode, double omega) {
  const std::vector<RadiationPoint>& points = data.radiation;
  if (points.empty()) return 0.0;
  const auto after = std::upper_bound(points.begin(), points.end(), omega,
                                      [](double w, const RadiationPoint& point) { return w < point.omega; });
  if (after == points.begin()) return points.front().damping(mode, mode);
  if (after == points.end()) return points.back().damping(mode, mode);
  const RadiationPoint &low = *(after - 1), &high = *after;
  const double share = (omega - low.omega) / (high.omega - low.omega);
  return (1.0 - share) * low.damping(mode, mode) + share * high.damping(mode, mode);
}

void add_damping_results(const HullReport& report, const HydrodynamicData& data, HullResults& out) {
  for (const ModeDamping& mode : report.damping) {
    if (!(mode.critical > 0.0)) continue;
    const auto name = std::find(kFreedomNames.begin(), kFreedomNames.end(), mode.mode);
    const int freedom = static_cast<int>(name - kFreedomNames.begin());
    const double file = file_damping(data, freedom, 2.0 * std::numbers::pi / mode.period) / mode.critical;
    out.damping.push_back({mode.mode, mode.period, mode.critical, mode.radiation, mode.drift, mode.current,
                           mode.viscous, mode.station_keeping, mode.total(), file});
  }
}

SteadyLoad horizontal(const Vec6& force) {
  return {force(0), force(1), force(5)};
}

}  // namespace

Mat6 station_stiffness(const MooredState* rest, const Vec3& centre_of_gravity) {
  if (rest == nullptr || rest->mooring_stiffness.size() != 36 || rest->mooring_force.size() != 6) return Mat6::Zero();
  using Rows = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  const Mat6 about_midship = Eigen::Map<const Rows>(rest->mooring_stiffness.data());
  const Vec3 pull = Eigen::Map<const Vec3>(rest->mooring_force.data());
  return stiffness_about(about_midship, pull, centre_of_gravity);
}

std::optional<HullStatics> compute_hull_statics(const Model& model, const MooredState* rest) {
  const Description& d = model.description;
  const std::optional<CoupledHullDescription>& coupled = d.vessel.coupled;
  if (!coupled || !coupled->data || d.vessel.motion != VesselMotion::coupled) return std::nullopt;
  const Sea sea = make_sea(d.environment.waves, d.environment.water_depth, default_seed(d.environment.waves));
  const Mat6 stiffness = station_stiffness(rest, coupled->centre_of_gravity);
  const MadeHull made = make_hull(model, sea, 0.0, stiffness);
  const HullReport report = hull_report(made, model, sea, stiffness);
  HullStatics account{{}, report.assumptions, report.findings};
  HullResults& out = account.results;
  add_radiation_results(report.radiation, out);
  add_damping_results(report, *coupled->data, out);
  const double heading = made.hull.lies(5);
  out.drift = horizontal(mean_drift(made.hull.waves, heading));
  out.current = horizontal(report.steady.current);
  out.wind = horizontal(wind_force(made.hull.wind, heading));
  out.below_table = report.below_table;
  out.above_table = report.above_table;
  out.min_current_force = report.min_current_force;
  out.max_current_force = report.max_current_force;
  return account;
}

}  // namespace overbend
