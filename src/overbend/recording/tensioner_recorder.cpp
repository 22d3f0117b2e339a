#include "recording/tensioner_recorder.h"

#include <algorithm>
#include <cmath>

#include "model/description/description_enum_names.h"

namespace overbend {
namespace {

std::size_t state_index(TensionerState state) {
  return static_cast<std::size_t>(state);
}

}  // namespace

TensionerRecorder::TensionerRecorder(const TensionerLaw& law) : law_(&law) {}

void TensionerRecorder::add(const AttachmentState& tensioner, double paid_out, double time, double step) {
  const TensionerMachine& machine = tensioner.machine;
  if (time > 0.0) {
    const std::array<double, 2> sample{machine.tension, paid_out};
    statistics_.add(sample, step);
    time_[state_index(last_)] += step;  // the state during the step
    out_of_range_ += law_->high > law_->low && out_of_range(*law_, machine.tension) ? step : 0.0;
    count_[state_index(machine.state)] += machine.state != last_ ? 1.0 : 0.0;
  }
  last_ = machine.state;
}

TensionerDynamics TensionerRecorder::results() const {
  TensionerDynamics r;
  r.mode = enum_name(law_->mode);
  const std::vector<double> deviation = statistics_.standard_deviation();
  const auto spread = [&](std::size_t i) {
    return SummaryStatistics{statistics_.min()[i], statistics_.max()[i], statistics_.mean()[i], deviation[i]};
  };
  r.tension = spread(0);
  r.travel = spread(1);
  r.wanted = law_->wanted;
  r.range_low = law_->low;
  r.range_high = law_->high;
  r.travel_limit = std::isfinite(law_->limit) ? law_->limit : 0.0;
  r.time_out_of_range = out_of_range_;
  r.time_holding = time_[state_index(TensionerState::hold)];
  r.time_delayed = time_[state_index(TensionerState::delay)];
  r.time_paying_out = time_[state_index(TensionerState::pay_out)];
  r.time_hauling_in = time_[state_index(TensionerState::haul_in)];
  r.time_at_limit = time_[state_index(TensionerState::at_limit)];
  r.pay_out_count = static_cast<std::int64_t>(count_[state_index(TensionerState::pay_out)]);
  r.haul_in_count = static_cast<std::int64_t>(count_[state_index(TensionerState::haul_in)]);
  r.limit_count = static_cast<std::int64_t>(count_[state_index(TensionerState::at_limit)]);
  return r;
}

std::vector<double> TensionerRecorder::save() const {
  std::vector<double> out{static_cast<double>(last_), out_of_range_};
  out.insert(out.end(), time_.begin(), time_.end());
  out.insert(out.end(), count_.begin(), count_.end());
  const std::vector<double> statistics = statistics_.save();
  out.insert(out.end(), statistics.begin(), statistics.end());
  return out;
}

void TensionerRecorder::restore(const std::vector<double>& saved) {
  constexpr std::ptrdiff_t kStates = kTensionerStates;
  last_ = static_cast<TensionerState>(static_cast<int>(saved.at(0)));
  out_of_range_ = saved.at(1);
  std::copy_n(saved.begin() + 2, kStates, time_.begin());
  std::copy_n(saved.begin() + 2 + kStates, kStates, count_.begin());
  statistics_.restore(std::span(saved).subspan(2 + 2 * kStates));
}

}  // namespace overbend
