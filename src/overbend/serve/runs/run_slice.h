/// Part of the execution of a run where there are no threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>

namespace overbend {

/// Limits the time of a part of a run. It is not over before the run has advanced, and then lasts at least four
/// times as long as the preparation took: otherwise a run whose preparation takes longer than a part would never end,
/// or mostly prepare.
class RunSlice {
 public:
  using Clock = std::chrono::steady_clock;

  void begin(Clock::duration duration) {
    begin_ = Clock::now();
    duration_ = duration;
    end_ = Clock::time_point::max();
  }

  /// To be called when a step or a case was computed, from any thread.
  void note_advance() {
    if (!is_active()) return;
    const Clock::time_point time = Clock::now();
    Clock::time_point unset = Clock::time_point::max();
    end_.compare_exchange_strong(unset, time + std::max(duration_, 4 * (time - begin_)));
  }

  bool is_active() const { return duration_ != Clock::duration::zero(); }
  bool has_advanced() const { return end_.load() != Clock::time_point::max(); }
  bool is_over() const { return Clock::now() > end_.load(); }

 private:
  Clock::time_point begin_{};
  Clock::duration duration_ = Clock::duration::zero();
  std::atomic<Clock::time_point> end_{Clock::time_point::max()};
};

}  // namespace overbend
