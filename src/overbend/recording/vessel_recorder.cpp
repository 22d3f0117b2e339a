#include "recording/vessel_recorder.h"

#include <cmath>

namespace overbend {
namespace {

SummaryStatistics shifted(const SummaryStatistics& spread, double by) {
  return {spread.min + by, spread.max + by, spread.mean + by, spread.std};
}

}  // namespace

void VesselRecorder::evaluate(const VesselPose& pose) {
  now_ = shift_between(nominal_, pose);
  offset_ = std::hypot(now_[0] - start_[0], now_[1] - start_[1]);
}

void VesselRecorder::start(const VesselPose& pose) {
  start_ = shift_between(nominal_, pose);
  evaluate(pose);
}

void VesselRecorder::add(const VesselPose& pose, double time, double step) {
  evaluate(pose);
  if (time <= 0.0) return;
  const double product = (now_[0] - start_[0]) * (now_[1] - start_[1]);
  const std::array<double, kVesselFreedoms + 2> sample = {now_[0], now_[1], now_[2], now_[3],
                                                          now_[4], now_[5], offset_, product};
  statistics_.add(sample, step);
}

VesselDynamics VesselRecorder::results() const {
  VesselDynamics r;
  const std::vector<double> deviation = statistics_.standard_deviation();
  const auto spread = [&](std::size_t i) {
    return SummaryStatistics{statistics_.min()[i], statistics_.max()[i], statistics_.mean()[i], deviation[i]};
  };
  MotionStatistics* const freedoms[kVesselFreedoms] = {&r.surge, &r.sway, &r.heave, &r.roll, &r.pitch, &r.yaw};
  for (std::size_t i = 0; i < kVesselFreedoms; ++i) freedoms[i]->whole = spread(i);
  r.offset.whole = spread(kVesselFreedoms);
  r.along.whole = shifted(r.surge.whole, -start_[0]);
  r.across.whole = shifted(r.sway.whole, -start_[1]);
  r.covariance = statistics_.mean()[kVesselFreedoms + 1] - r.along.whole.mean * r.across.whole.mean;
  r.start_surge = start_[0];
  r.start_sway = start_[1];
  r.start_yaw = start_[5];
  return r;
}

}  // namespace overbend
