#include "app/progress.h"

#include <fmt/format.h>

#include <cmath>
#include <iostream>

#include "platform/process.h"

namespace overbend {
namespace {

constexpr double kTerminalPause = 0.2;  ///< Interval between updates [s].
constexpr double kPlainPause = 30.0;

std::string clock_text(double seconds) {
  const long s = std::lround(seconds);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

double seconds_since(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

}  // namespace

Progress::Progress(double from, double to)
    : from_(from),
      to_(to),
      first_position_(from),
      terminal_(is_terminal(StandardStream::error)),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
  if (terminal_ && shown_) {
    std::cerr << "\r\033[K" << std::flush;
  }
}

void Progress::show(double position, const std::string& text) {
  if (!begun_) {
    begun_ = true;
    first_position_ = position;
  }
  if (seconds_since(last_) < (terminal_ ? kTerminalPause : kPlainPause) && position < to_) {
    return;
  }
  last_ = Clock::now();
  const double done = (position - from_) / (to_ - from_);
  const double left =
      position > first_position_ ? seconds_since(start_) * (to_ - position) / (position - first_position_) : 0.0;
  const std::string line = fmt::format("{:5.1f} %  {}  {} remaining", 100.0 * done, text, clock_text(left));
  if (terminal_) {
    constexpr int kWidth = 24;
    const int filled = static_cast<int>(done * kWidth);
    std::cerr << "\r\033[K[" << std::string(static_cast<std::size_t>(filled), '#')
              << std::string(static_cast<std::size_t>(kWidth - filled), '.') << "] " << line << std::flush;
    shown_ = true;
  } else {
    std::cerr << line << "\n";
  }
}

}  // namespace overbend
