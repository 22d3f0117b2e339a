#include "recording/thrust_recorder.h"

#include <fmt/format.h>

#include <cmath>

#include "base/shown_unit.h"

namespace overbend {
namespace {

constexpr std::size_t kOfThrust = 3, kYaw = 2;
constexpr std::array<const char*, kOfThrust> kNames = {"surge", "sway", "yaw"};
constexpr double kNoLimit = 1e299;  // StationKeepingDescription uses 1e300 for no limit

}  // namespace

void ThrustRecorder::start(const SystemState& state) {
  if (keeping_ != nullptr) now_ = station_thrust(*keeping_, state.bodies.front().slow, state.time);
}

void ThrustRecorder::add(const SystemState& state, double step) {
  if (keeping_ == nullptr) return;
  start(state);
  if (state.time <= 0.0) return;
  const Vec3& limit = keeping_->law.limit;
  std::array<double, 3 * kOfThrust> sample;
  for (std::size_t i = 0; i < kOfThrust; ++i) {
    const auto d = static_cast<Eigen::Index>(i);
    const double asked = std::abs(now_.asked[d]);
    sample[i] = now_.given[d];
    sample[kOfThrust + i] = asked;
    sample[2 * kOfThrust + i] = asked > limit[d] ? 1.0 : 0.0;
  }
  statistics_.add(sample, step);
}

std::vector<ThrustDynamics> ThrustRecorder::results() const {
  std::vector<ThrustDynamics> out;
  if (keeping_ == nullptr) return out;
  const std::vector<double> deviation = statistics_.standard_deviation();
  for (std::size_t i = 0; i < kOfThrust; ++i) {
    ThrustDynamics& direction = out.emplace_back();
    direction.name = kNames[i];
    direction.given = {statistics_.min()[i], statistics_.max()[i], statistics_.mean()[i], deviation[i]};
    direction.max_demand = statistics_.max()[kOfThrust + i];
    const double limit = keeping_->law.limit[static_cast<Eigen::Index>(i)];
    if (limit < kNoLimit) direction.limit = limit;
    direction.time_at_limit = statistics_.mean()[2 * kOfThrust + i] * statistics_.weight();
  }
  return out;
}

Findings ThrustRecorder::findings() const {
  Findings list;
  for (const ThrustDynamics& direction : results()) {
    if (!direction.limit || direction.time_at_limit <= 0.0) continue;
    const char* const unit = direction.name == kNames[kYaw] ? "N m" : "N";
    list.push_back(Finding{
        FindingCode::thrust_at_limit,
        fmt::format(
            "dynamic positioning is at its limit in {0} for {1:.3g} s, {2:.2g} % of the run: the demand is up to {3}, "
            "the limit {4} (station_keeping.dp.{0}.thrust_limit): at the limit it provides neither stiffness nor "
            "damping",
            direction.name, direction.time_at_limit, 100.0 * direction.time_at_limit / statistics_.weight(),
            shown_digits(direction.max_demand, unit, 4), shown_digits(*direction.limit, unit, 4))}
                       .on("dynamic positioning, " + direction.name)
                       .with("duration", direction.time_at_limit, "s"));
  }
  return list;
}

}  // namespace overbend
