/// Wall time of a scope.
#pragma once

#include <chrono>

namespace overbend {

/// Adds the wall time of its lifetime to a sum [s].
class WallTime {
 public:
  explicit WallTime(double& sum) : sum_(sum) {}
  WallTime(const WallTime&) = delete;
  WallTime& operator=(const WallTime&) = delete;
  ~WallTime() { sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count(); }

 private:
  double& sum_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace overbend
