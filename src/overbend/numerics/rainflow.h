/// Rainflow counting of many records at once, sample by sample, in constant memory.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace overbend {

/// A cycle of a record: `count` is 1, or 0.5 for half a cycle.
struct RainflowCycle {
  double range = 0.0, mean = 0.0, count = 0.0;
};

/// Uncounted turning points of one record, by the rule of ASTM E1049-85 5.4.4: from the second on, each range is
/// smaller than the one before it. The first sample and the last are turning points.
class RainflowStack {
 public:
  /// Maximum number of stored turning points. If there would be more, as in a swell that decays over many waves, the
  /// two consecutive ranges that differ least are counted as one cycle of the larger: slightly conservative, never
  /// less.
  static constexpr std::size_t kCapacity = 64;

  void start(double value) {
    depth_ = 1;
    points_[0] = value;
  }

  /// Adds the next turning point. `closed(RainflowCycle)` receives the cycles it closes.
  template <class Closed>
  void turn(double value, Closed&& closed) {
    points_[depth_++] = value;
    collapse(closed);
    if (depth_ > kCapacity) closed(make_room());
  }

  /// Reports the unclosed ranges as half cycles.
  template <class Closed>
  void residue(Closed&& closed) const {
    for (std::size_t i = 1; i < depth_; ++i) closed(cycle(points_[i - 1], points_[i], 0.5));
  }

  double top() const { return points_[depth_ - 1]; }
  std::size_t depth() const { return depth_; }

  /// Appends its numbers to `out`; `restore` reads them from `position` on and moves it past them. Throws
  /// std::out_of_range if they end too early or do not represent a stack.
  void save(std::vector<double>& out) const;
  void restore(std::span<const double> saved, std::size_t& position);

 private:
  static RainflowCycle cycle(double a, double b, double count) { return {std::abs(b - a), 0.5 * (a + b), count}; }

  /// Removes two consecutive ranges as one cycle: the earlier of their turning points replaces the later one.
  RainflowCycle make_room();

  template <class Closed>
  void collapse(Closed& closed) {
    while (depth_ >= 3) {
      const double newest = std::abs(points_[depth_ - 1] - points_[depth_ - 2]);
      const double before = std::abs(points_[depth_ - 2] - points_[depth_ - 3]);
      if (newest < before) return;
      if (depth_ == 3) {  // the earlier range contains the start
        closed(cycle(points_[0], points_[1], 0.5));
        points_[0] = points_[1];
        points_[1] = points_[2];
        depth_ = 2;
        return;
      }
      closed(cycle(points_[depth_ - 3], points_[depth_ - 2], 1.0));
      points_[depth_ - 3] = points_[depth_ - 1];
      depth_ -= 2;
    }
  }

  std::array<double, kCapacity + 1> points_{};
  std::size_t depth_ = 0;
};

/// Records that are sampled together. A reversal counts as a turning point once the record has returned by more than
/// the hysteresis: smaller ranges are ignored, larger ones keep their size.
class RainflowCounter {
 public:
  explicit RainflowCounter(std::size_t records = 0, double hysteresis = 0.0);

  /// Adds one sample of every record; `closed(record, RainflowCycle)` receives the cycles that it closes. Nothing is
  /// allocated.
  template <class Closed>
  void add(std::span<const double> values, Closed&& closed) {
    if (!started_) {
      start(values);
      return;
    }
    constexpr std::size_t kBlock = 8;
    for (std::size_t first = 0; first < extreme_.size(); first += kBlock) {
      const std::size_t end = std::min(first + kBlock, extreme_.size());
      bool turned = false;
      for (std::size_t i = first; i < end; ++i) {
        const double ahead = direction_[i] * (values[i] - extreme_[i]);
        extreme_[i] = ahead > 0.0 ? values[i] : extreme_[i];
        turned |= ahead < -hysteresis_;
      }
      if (!turned) continue;
      for (std::size_t i = first; i < end; ++i) turn_back(i, values[i], closed);
    }
  }

  /// Reports the unclosed ranges as if the records ended here. Counting can continue afterwards.
  template <class Closed>
  void residue(Closed&& closed) const {
    for (std::size_t i = 0; started_ && i < extreme_.size(); ++i) {
      const auto of_record = [&](const RainflowCycle& cycle) { closed(i, cycle); };
      RainflowStack stack = stacks_[i];
      if (std::abs(extreme_[i] - stack.top()) > hysteresis_) stack.turn(extreme_[i], of_record);
      stack.residue(of_record);
    }
  }

  std::size_t records() const { return extreme_.size(); }
  std::size_t deepest() const;  ///< Current maximum depth of the stacks.

  /// Returns the state as numbers; `restore` reproduces it bitwise in a counter of as many records. Throws
  /// std::out_of_range if `saved` is not such a list.
  std::vector<double> save() const;
  void restore(std::span<const double> saved);

 private:
  void start(std::span<const double> values);

  template <class Closed>
  void turn_back(std::size_t i, double value, Closed& closed) {
    if (direction_[i] * (value - extreme_[i]) >= -hysteresis_) return;
    RainflowStack& stack = stacks_[i];
    // Before the first reversal, the direction at the start is a guess.
    if (stack.depth() > 1 || std::abs(extreme_[i] - stack.top()) > hysteresis_) {
      stack.turn(extreme_[i], [&](const RainflowCycle& cycle) { closed(i, cycle); });
    }
    extreme_[i] = value;
    direction_[i] = -direction_[i];
  }

  double hysteresis_ = 0.0;
  bool started_ = false;
  std::vector<double> extreme_;    ///< Extreme value since the last turning point.
  std::vector<double> direction_;  ///< 1 or -1.
  std::vector<RainflowStack> stacks_;
};

}  // namespace overbend
