#include "recording/start_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mechanics/build_up.h"

namespace overbend {
namespace {

constexpr double kQuietShare = 0.1;     ///< Of sea and motions, up to which they explain little.
constexpr double kOfVessel = 3.0;       ///< Displacement of the pipe that one of the vessel may explain.
constexpr double kWorthAWarning = 0.5;  ///< Displacement beyond that [m].

bool in_calm_water(const Description& d) {
  return d.environment.waves.type == WaveType::none && d.vessel.motion == VesselMotion::fixed;
}

}  // namespace

StartWatch::StartWatch(const Model& model, double build_up, bool moved)
    : shoe_V_(model.description.vessel.stern_shoe_x, 0.0, model.description.vessel.stern_shoe_z),
      build_up_(build_up),
      calm_(in_calm_water(model.description) && !moved) {}

bool StartWatch::quiet(double time) const {
  return calm_ || half_cosine(time, build_up_).value < kQuietShare;
}

Vec3 StartWatch::shoe(const VesselPose& vessel) const {
  return vessel.p_WV + vessel.R_WV * shoe_V_;
}

void StartWatch::start(const NodeValues& nodes, const VesselPose& vessel) {
  x_ = nodes.x;
  y_ = nodes.y;
  z_ = nodes.z;
  shoe_W_ = shoe(vessel);
}

void StartWatch::add(const NodeValues& nodes, const VesselPose& vessel, double time) {
  if (!quiet(time)) return;
  const double explained = kOfVessel * (shoe(vessel) - shoe_W_).norm();
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const double gone =
        std::sqrt(std::pow(nodes.x[i] - x_[i], 2) + std::pow(nodes.y[i] - y_[i], 2) + std::pow(nodes.z[i] - z_[i], 2));
    if (gone - explained <= largest_) continue;
    largest_ = gone - explained;
    node_ = static_cast<double>(i);
    time_ = time;
  }
}

std::optional<StartWatch::Departure> StartWatch::departure() const {
  if (largest_ <= kWorthAWarning) return std::nullopt;
  return Departure{static_cast<std::size_t>(node_), largest_, time_};
}

void StartWatch::restore(const std::vector<double>& saved) {
  largest_ = saved.at(0);
  node_ = saved.at(1);
  time_ = saved.at(2);
}

}  // namespace overbend
