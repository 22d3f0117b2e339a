/// A chain of lumped masses that only pull on each other, by explicit steps: a second opinion on lines that go slack.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/vec.h"

namespace overbend::testing {

/// From a point of the bed to an end that heaves: the model of slack_lines_test.cpp in its own numbers.
struct LumpedChain {
  int links = 40;
  double length = 150.0, mass = 200.0, weight = 1500.0, EA = 5e8;  ///< [m], [kg/m], under water [N/m], [N]
  double diameter = 0.1, drag = 2.4, damping = 0.0;                ///< Properties of the links; damping as a time [s].
  double density = 10.05e3 / kGravity, depth = 100.0, friction = 0.5;
  double bed = 150e3, stick = 100e3;  ///< Under the links, and in friction [N/m2].
  Vec3 anchor{0.0, 0.0, -100.0}, top{120.0, 0.0, -20.0};
  double amplitude = 8.0, period = 6.0, build_up = 12.0;  ///< Heave of the top [m], [s].
};

/// Largest tension of the last link in each period from t = 0 on [N].
class LumpedChainRun {
 public:
  explicit LumpedChainRun(const LumpedChain& chain) : c_(chain), link_(c_.length / c_.links) {
    const double viscous = c_.damping > 0.0 ? link_ * link_ * c_.mass / (c_.EA * c_.damping) : 1.0;
    step_ = 0.2 * std::min({link_ * std::sqrt(c_.mass / c_.EA), viscous, 5e-3});
    added_ = (c_.mass * kGravity - c_.weight) / kGravity;
    for (int i = 0; i <= c_.links; ++i) {
      const double s = i * link_, on_bed = 62.0, up = std::max(s - on_bed, 0.0) / (c_.length - on_bed);
      const Vec3 foot(std::min(s, on_bed), 0.0, -c_.depth);
      x_.push_back((1.0 - up) * foot + up * c_.top);
    }
    v_.assign(x_.size(), Vec3::Zero());
    slip_ = force_ = tangent_ = v_;
    for (double time = 0.0; time < 40.0; time += step_) advance(c_.top, Vec3::Zero(), 1.0);
    std::ranges::fill(v_, Vec3::Zero());
    std::ranges::fill(slip_, Vec3::Zero());
  }

  double tension() const { return tension_; }

  std::vector<double> peaks(double end) {
    std::vector<double> peaks;
    for (double t = -c_.build_up; t < end; t += step_) {
      const double w = 2.0 * std::numbers::pi / c_.period, p = std::numbers::pi / c_.build_up;
      const double ramp = t < 0.0 ? 0.5 * (1.0 - std::cos(p * (t + c_.build_up))) : 1.0;
      const double ramp_rate = t < 0.0 ? 0.5 * p * std::sin(p * (t + c_.build_up)) : 0.0;
      const double heave = c_.amplitude * std::sin(w * t), rate = c_.amplitude * w * std::cos(w * t);
      advance(c_.top + heave * ramp * Vec3::UnitZ(), (rate * ramp + heave * ramp_rate) * Vec3::UnitZ(), 0.0);
      if (t <= 0.0) continue;
      peaks.resize(static_cast<std::size_t>(t / c_.period) + 1);
      peaks.back() = std::max(peaks.back(), tension_);
    }
    return peaks;
  }

 private:
  void pull(std::size_t i) {
    const Vec3 between = x_[i + 1] - x_[i];
    const double l = between.norm();
    const Vec3 u = between / l;
    const double strain = l / link_ - 1.0 + c_.damping * (v_[i + 1] - v_[i]).dot(u) / link_;
    tension_ = c_.EA * std::max(strain, 0.0);
    force_[i] += tension_ * u;
    force_[i + 1] -= tension_ * u;
    tangent_[i] += u;
    tangent_[i + 1] += u;
  }

  void move(std::size_t i, double brake) {
    const Vec3 t = tangent_[i].normalized(), across = v_[i] - v_[i].dot(t) * t;
    Vec3 f = force_[i] - 0.5 * c_.density * c_.drag * c_.diameter * link_ * across.norm() * across;
    const double normal = c_.bed * link_ * std::max(-c_.depth - x_[i].z(), 0.0);
    f.z() += normal - c_.weight * link_;
    slip_[i] += step_ * Vec3(v_[i].x(), v_[i].y(), 0.0);
    const double max_value = c_.friction * normal / (c_.stick * link_), size = slip_[i].norm();
    if (size > max_value) slip_[i] *= max_value / size;
    f -= c_.stick * link_ * slip_[i] + brake * c_.mass * link_ * v_[i];
    const Vec3 along = f.dot(t) * t;
    v_[i] += step_ / link_ * (along / c_.mass + (f - along) / (c_.mass + added_));
  }

  void advance(const Vec3& top, const Vec3& top_rate, double brake) {
    std::ranges::fill(force_, Vec3::Zero());
    std::ranges::fill(tangent_, Vec3::Zero());
    for (std::size_t i = 0; i + 1 < x_.size(); ++i) pull(i);
    for (std::size_t i = 1; i + 1 < x_.size(); ++i) move(i, brake);
    v_.back() = top_rate;
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += step_ * v_[i];
    x_.back() = top;
  }

  LumpedChain c_;
  double link_, step_ = 0.0, added_ = 0.0, tension_ = 0.0;
  std::vector<Vec3> x_, v_, force_, tangent_, slip_;
};

}  // namespace overbend::testing
