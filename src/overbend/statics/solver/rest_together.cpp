#include "statics/solver/rest_together.h"

#include <algorithm>
#include <cmath>

#include "base/interruption.h"
#include "statics/solver/lines_statics.h"

namespace overbend {
namespace {

/// Time of the step without inertia, in which friction stretches and slides: so long that no rate makes a force [s].
constexpr double kLongTime = 1e6;
constexpr double kGrowthHeld = 10.0;  ///< Of the residual, that an iteration may bring: cables stiffen as they turn.
constexpr double kGrowthFree = 2.0;   ///< The same where bodies move: the pipe must not leave its rollers behind.
constexpr int kHalvings = 8;
constexpr int kTries = 300;       ///< Iterations of a line by itself.
constexpr int kTogether = 20;     ///< Of all lines at once, before each is tried by itself.
constexpr double kAlmost = 0.05;  ///< Unbalanced force from which Newton's method is tried again in the fallback.

void add(MotionValues& values, double d) {
  values.q += d;
  values.v += d / kLongTime;
}

/// Friction of the rollers as in statics, or by the slip.
void set_static_friction(Assembly& assembly, bool of_statics) {
  ContactEasing easing;
  easing.friction = !of_statics;
  easing.rub = assembly.system().rub;
  for (std::size_t i = 0; i < assembly.system().lines.size(); ++i) assembly.line(i).contacts().ease(easing);
}

class Rest {
 public:
  Rest(Assembly& assembly, SystemState& state, const RestSettings& settings)
      : assembly_(assembly),
        settings_(settings),
        before_(state),
        now_(state),
        tried_(state),
        dq_(assembly.increments()) {}

  RestReport find(SystemState& result) {
    rest_lines();
    all_together();
    while (!report_.converged && report_.rounds < settings_.max_rounds) {
      ++report_.rounds;
      move_bodies();
      if (report_.residual < kAlmost) {
        all_together();
      }
    }
    if (!report_.converged) {
      report_.residual = residual_of(now_, false);  // the last evaluation may have been of a try that was given up
    }
    result = now_;
    at_rest(result);
    return report_;
  }

 private:
  /// Residual of a state; with its tangent where it is asked for.
  double residual_of(SystemState& at, bool tangent) {
    check_interruption();
    assembly_.set_time(at.time, at);
    assembly_.impose_ends(at);
    assembly_.evaluate(at, before_, {1.0 / kLongTime, 0.0, kLongTime}, tangent);
    assembly_.hold(tangent);
    const double residual = assembly_.relative_residual();
    report_.worst_place = assembly_.worst_place();
    return residual;
  }

  /// Share of the correction that keeps bodies within their bounds.
  double bounded_share() const {
    double share = 1.0;
    for (std::size_t i = 0; i < now_.bodies.size(); ++i) {
      const Vec6 dh = Eigen::Map<const Vec6>(dq_.back().data() + 6 * i);
      share = std::min({share, settings_.largest_move / std::max(dh.head<3>().norm(), 1e-300),
                        settings_.largest_turn / std::max(dh.tail<3>().norm(), 1e-300)});
    }
    return share;
  }

  /// Guides stand so where the correction was made; a try turns them with its bodies.
  void keep_directions() {
    directions_.clear();
    for (const EndMotion& end : assembly_.surroundings().ends) {
      directions_.push_back(end.direction);
    }
  }

  void move(double share, bool lines, SystemState& to) const {
    to = now_;
    for (std::size_t line = 0; line < (lines ? to.lines.size() : 0); ++line) {
      LineState& at = to.lines[line];
      for (std::size_t i = 0; i < at.q.size(); ++i) {
        at.q[i] += share * dq_[line][i];
        at.v[i] += share * dq_[line][i] / kLongTime;
      }
    }
    for (std::size_t i = 0; i < to.bodies.size(); ++i) {
      const Vec6 dh = share * Eigen::Map<const Vec6>(dq_.back().data() + 6 * i);
      to.bodies[i].h += dh;
      to.bodies[i].v += dh / kLongTime;
    }
    for (std::size_t i = 0; i < (lines ? to.attachments.size() : 0); ++i) {
      const Attachment& held = assembly_.system().attachments[i];
      const std::size_t line = static_cast<std::size_t>(held.line);
      const double* part = dq_[line].data() + 6 * assembly_.line(line).end_node(held.end);
      const Vec3& direction = directions_[i];
      add(to.attachments[i].guide, share * direction.dot(Vec3(Eigen::Map<const Vec3>(part + 3))));
      if (static_cast<int>(i) == assembly_.system().machine) {
        add(to.attachments[i].travel, -share * direction.dot(Vec3(Eigen::Map<const Vec3>(part))));
      }
    }
  }

  void newton(int most, double growth) {
    for (int i = 0; i < most; ++i) {
      report_.residual = residual_of(now_, true);
      report_.converged = report_.residual < settings_.tolerance && assembly_.contacts_settled();
      if (report_.converged || !(report_.residual < 1e30) || !assembly_.solve_factored(dq_)) {
        return;
      }
      ++report_.iterations;
      assembly_.end_iteration(now_);
      keep_directions();
      double share = bounded_share();
      move(share, true, tried_);
      for (int k = 0; k < kHalvings && !(residual_of(tried_, false) < growth * report_.residual); ++k) {
        share *= 0.5;
        move(share, true, tried_);
      }
      std::swap(now_, tried_);
    }
  }

  /// Newton's method for all; where it fails all is as it was.
  void all_together() {
    const SystemState from = now_;
    newton(settings_.max_iterations, kGrowthFree);
    if (!report_.converged) {
      now_ = from;
    }
  }

  /// Lines between held ends, each by itself and searched along its steps: points of the bed's friction that now stick
  /// and now slide send a whole Newton step to and fro. What lies on rollers is left as it is.
  void rest_one_by_one() {
    residual_of(now_, false);  // ends in their places
    for (std::size_t i = 0; i < now_.lines.size(); ++i) {
      if (assembly_.line(i).contacts().count() > 0) continue;
      LineState line = now_.lines[i];
      const NewtonReport rest =
          rest_line(assembly_, i, before_.lines[i], kLongTime, line, {settings_.tolerance, kTries});
      report_.iterations += rest.iterations;
      if (rest.converged()) now_.lines[i] = std::move(line);
    }
  }

  /// Lines on held bodies. Few iterations of all lines at once: on a bed that rubs they may be thrown about, further
  /// with each, until they come to rest by chance somewhere else, and drag the bodies there.
  void rest_lines() {
    const std::vector<std::pair<int, int>> held = hold_all();
    const SystemState from = now_;
    newton(std::min(kTogether, settings_.max_iterations), kGrowthHeld);
    if (!report_.converged) {
      now_ = from;
      rest_one_by_one();
      newton(settings_.max_iterations, kGrowthHeld);
    }
    for (const auto& [body, freedom] : held) {
      assembly_.hold_body(body, freedom, false);
    }
    report_.converged = false;
  }

  /// A round of the fallback: lines on held bodies, then the bodies by half a step.
  void move_bodies() {
    rest_lines();
    report_.residual = residual_of(now_, true);
    if (assembly_.solve_factored(dq_)) {
      move(0.5 * bounded_share(), false, tried_);
      std::swap(now_, tried_);
    }
  }

  /// Holds what is free of the bodies; returns what it held.
  std::vector<std::pair<int, int>> hold_all() {
    std::vector<std::pair<int, int>> held;
    for (const int body : free_bodies(assembly_.system())) {
      for (int freedom = 0; freedom < 6; ++freedom) {
        if (!assembly_.body_held(body, freedom)) {
          assembly_.hold_body(body, freedom, true);
          held.emplace_back(body, freedom);
        }
      }
    }
    return held;
  }

  void at_rest(SystemState& state) {
    for (LineState& line : state.lines) {
      std::fill(line.v.begin(), line.v.end(), 0.0);
    }
    for (HullState& body : state.bodies) {
      body.v.setZero();
    }
    for (AttachmentState& end : state.attachments) {
      end.guide.v = end.travel.v = 0.0;
    }
  }

  Assembly& assembly_;
  RestSettings settings_;
  const SystemState before_;
  SystemState now_, tried_;
  Increments dq_;
  std::vector<Vec3> directions_;
  RestReport report_;
};

}  // namespace

RestReport rest_together(Assembly& assembly, SystemState& state, const RestSettings& settings) {
  set_static_friction(assembly, true);
  const RestReport report = Rest(assembly, state, settings).find(state);
  set_static_friction(assembly, false);
  return report;
}

void mobilise_roller_friction(Assembly& assembly, SystemState& state) {
  if (!assembly.system().rub.any()) return;
  const SystemState before = state;
  set_static_friction(assembly, true);
  assembly.evaluate(state, before, {}, false);
  set_static_friction(assembly, false);
}

}  // namespace overbend
