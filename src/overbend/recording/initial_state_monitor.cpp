#include "recording/initial_state_monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mechanics/build_up.h"
#include "model/site/wave_groups.h"

namespace overbend {
namespace {

constexpr double kMaxQuietRamp = 0.1;       ///< Ramp factor of sea and motions up to which the run is observed [-].
constexpr double kExplainedByVessel = 3.0;  ///< Displacement of the pipe explained by a unit displacement of the vessel
                                            ///< [-].
constexpr double kMinReportedDeparture = 0.5;  ///< Further displacement from which a departure is reported [m].

bool in_calm_water(const Description& d) {
  return is_calm(d.environment.waves) && d.vessel.motion == VesselMotion::fixed;
}

}  // namespace

InitialStateMonitor::InitialStateMonitor(const Model& model, double build_up, bool moved)
    : shoe_V_(model.description.vessel.stern_shoe_x, 0.0, model.description.vessel.stern_shoe_z),
      build_up_(build_up),
      calm_(in_calm_water(model.description) && !moved) {}

bool InitialStateMonitor::quiet(double time) const {
  return calm_ || half_cosine(time, build_up_).value < kMaxQuietRamp;
}

Vec3 InitialStateMonitor::shoe(const VesselPose& vessel) const {
  return vessel.p_WV + vessel.R_WV * shoe_V_;
}

void InitialStateMonitor::start(const NodeValues& nodes, const VesselPose& vessel) {
  x_ = nodes.x;
  y_ = nodes.y;
  z_ = nodes.z;
  shoe_W_ = shoe(vessel);
}

void InitialStateMonitor::add(const NodeValues& nodes, const VesselPose& vessel, double time) {
  if (!quiet(time)) return;
  const double explained = kExplainedByVessel * (shoe(vessel) - shoe_W_).norm();
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const double gone =
        std::sqrt(std::pow(nodes.x[i] - x_[i], 2) + std::pow(nodes.y[i] - y_[i], 2) + std::pow(nodes.z[i] - z_[i], 2));
    if (gone - explained <= max_departure_) continue;
    max_departure_ = gone - explained;
    node_ = static_cast<double>(i);
    time_ = time;
  }
}

std::optional<InitialStateMonitor::Departure> InitialStateMonitor::departure() const {
  if (max_departure_ <= kMinReportedDeparture) return std::nullopt;
  return Departure{static_cast<std::size_t>(node_), max_departure_, time_};
}

void InitialStateMonitor::restore(const std::vector<double>& saved) {
  max_departure_ = saved.at(0);
  node_ = saved.at(1);
  time_ = saved.at(2);
}

}  // namespace overbend
