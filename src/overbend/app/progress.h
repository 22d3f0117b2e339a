/// Progress of a long computation with the estimated remaining time.
#pragma once

#include <chrono>
#include <string>

namespace overbend {

/// Writes to stderr: on a terminal a single line that is updated, otherwise a plain line every 30 s.
class Progress {
 public:
  /// `from` and `to` are the range of the positions passed to show().
  Progress(double from, double to);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(double position, const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;

  double from_, to_;
  double first_position_;  ///< Position of the first call; a resumed run does not begin at `from`.
  bool terminal_, begun_ = false, shown_ = false;
  Clock::time_point start_, last_;
};

}  // namespace overbend
