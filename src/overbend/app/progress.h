/// How far long work has come, with the time it still needs.
#pragma once

#include <chrono>
#include <string>

namespace overbend {

/// Writes to stderr: on a terminal one line that is written over, elsewhere a plain line now and then.
class Progress {
 public:
  /// `from` and `to` are what `show` counts in.
  Progress(double from, double to);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(double at, const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;

  double from_, to_;
  double begun_at_;  ///< Where the first call stood: a run taken up again does not begin at `from`.
  bool terminal_, begun_ = false, shown_ = false;
  Clock::time_point start_, last_;
};

}  // namespace overbend
