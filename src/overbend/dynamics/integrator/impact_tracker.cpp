#include "dynamics/integrator/impact_tracker.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {
namespace {

constexpr double kResolvedTimes = 2.0;      ///< Duration of short steps after a touch, in contact times.
constexpr double kReducedResolution = 2.0;  ///< Factor on the step past the peak of an impact and in slow impacts.
/// Duration, in contact times, after which a persisting contact no longer counts as an impact.
constexpr double kMaxContactTimes = 2.0;
constexpr double kAtRest = 0.05;    ///< Share of the approach velocity below which the pipe counts as at rest.
constexpr double kNever = 1e300;    ///< [s]
constexpr double kNotFound = -1.0;  ///< Penetration if the pipe does not pass the roller [m].
constexpr int kSaved = 10;          ///< Numbers per roller.

}  // namespace

ImpactTracker::ImpactTracker(const std::vector<BodyRoller>& rollers, const ImpactSettings& settings)
    : rollers_(&rollers), settings_(settings), tracks_(rollers.size()) {
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    tracks_[i].penetration = 0.0;  // contacts present at the start are no impacts
  }
}

double ImpactTracker::contact_time(std::size_t roller) const {
  const BodyRoller& r = (*rollers_)[roller];
  return std::numbers::pi * std::sqrt(r.mass / r.law.stiffness);
}

/// Peak force of the mass moved by the impact on the roller's spring, undamped [N].
double ImpactTracker::undamped_force(std::size_t roller, double velocity) const {
  const BodyRoller& r = (*rollers_)[roller];
  return velocity * std::sqrt(r.law.stiffness * r.mass);
}

bool ImpactTracker::exceeds_min_force(std::size_t roller, double velocity) const {
  return undamped_force(roller, velocity) > settings_.min_force;
}

/// Impact that begins with a step of `h` that ends at `time` in contact. A captured impact is over within about this
/// step: its approach velocity is known from the previous step, and its peak is estimated conservatively, as if the
/// roller had no damping and already bore its full force of the end of the step.
Impact ImpactTracker::make_impact(std::size_t roller, const RollerContact& contact, double time, double h) const {
  const Track& before = tracks_[roller];
  Impact impact;
  impact.roller = static_cast<int>(roller);
  impact.time = time - h * contact.penetration / (contact.penetration - before.penetration);
  impact.approach_velocity = std::max(contact.rate, (contact.penetration - before.penetration) / h);
  if (settings_.captured) {
    impact.approach_velocity = std::max(impact.approach_velocity, before.rate);
    impact.peak_force = undamped_force(roller, impact.approach_velocity) + contact.normal;
  }
  return impact;
}

/// Load on a box at the peak of captured impacts that began with this step, as if all its rollers were struck at once
/// [N].
double ImpactTracker::peak_box_load(std::size_t roller, const std::vector<RollerContact>& contacts) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if ((*rollers_)[i].box != (*rollers_)[roller].box) continue;
    sum += tracks_[i].begun ? tracks_[i].impact.peak_force : contacts[i].normal;
  }
  return sum;
}

/// Time to the touch of a roller that the pipe is clear of, if the gap continues to close as over the last step of `h`
/// [s]. A longer step would end after the pipe has been stopped, which is too coarse for an impact.
double ImpactTracker::time_to_touch(std::size_t roller, const RollerContact& contact, double h) const {
  const Track& before = tracks_[roller];
  if (!contact.closest.found || contact.penetration >= 0.0 || before.penetration >= 0.0 ||
      before.penetration == kNotFound) {
    return kNever;
  }
  const double gap = -contact.penetration, acceleration = (contact.rate - before.rate) / h;
  const double squared = contact.rate * contact.rate + 2.0 * acceleration * gap;
  if (!(squared > 0.0)) return kNever;
  const double velocity = std::sqrt(squared);  // at the touch
  return contact.rate + velocity > 0.0 && exceeds_min_force(roller, velocity) ? 2.0 * gap / (contact.rate + velocity)
                                                                              : kNever;
}

ImpactLimit ImpactTracker::check(const std::vector<RollerContact>& contacts, double h) const {
  ImpactLimit limit;
  if (settings_.captured) return limit;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const double before = tracks_[i].penetration, current = contacts[i].penetration;
    if (before >= 0.0 || current <= 0.0) {
      continue;
    }
    const double velocity = std::max(contacts[i].rate, (current - before) / h);
    const double resolved = contact_time(i) / settings_.steps;
    if (exceeds_min_force(i, velocity) && h > 1.01 * resolved) {
      limit.reject = true;
      limit.step = std::min(limit.step, std::max(-before / velocity, resolved));
    }
  }
  limit.reject = limit.reject && limit.step < 0.95 * h;
  return limit;
}

/// Maximum step during an impact [s]; `force` is the current roller force. The peak has been recorded once the force is
/// below it. A contact that outlasts its contact time moves more than its mass, more slowly.
double ImpactTracker::max_step_during_impact(const Impact& impact, double force) const {
  const double time = contact_time(static_cast<std::size_t>(impact.roller));
  const bool sparser = force < impact.peak_force || impact.duration > time;
  return (sparser ? kReducedResolution : 1.0) * time / settings_.steps;
}

void ImpactTracker::accept(const std::vector<RollerContact>& contacts, double time, double h,
                           std::vector<EndedImpact>& ended) {
  step_limit_ = kNever;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    Track& track = tracks_[i];
    track.begun = false;
    if (!settings_.captured) {
      step_limit_ =
          std::min(step_limit_, std::max(time_to_touch(i, contacts[i], h), contact_time(i) / settings_.steps));
    }
    const double penetration = contacts[i].closest.found ? contacts[i].penetration : kNotFound;
    if (!track.open && track.penetration < 0.0 && penetration > 0.0) {
      const Impact impact = make_impact(i, contacts[i], time, h);
      if (exceeds_min_force(i, impact.approach_velocity)) {
        track.open = track.begun = true;
        track.impact = impact;
      }
    }
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    Track& track = tracks_[i];
    const RollerContact& contact = contacts[i];
    if (track.open) {
      Impact& impact = track.impact;
      if (settings_.captured && track.begun) track.box_force = peak_box_load(i, contacts);
      impact.peak_force = std::max(impact.peak_force, contact.normal);
      impact.impulse += 0.5 * h * (track.force + contact.normal);
      impact.duration = time - impact.time;
      const double contact_times = impact.duration / contact_time(i);
      const bool left = contact.normal <= 0.0 && contact.rate <= 0.0;
      const bool rests = contact_times > 1.0 && std::abs(contact.rate) < kAtRest * impact.approach_velocity;
      if (left || rests || contact_times > kMaxContactTimes) {
        track.open = false;
        ended.push_back({impact, track.box_force});
      } else if (!settings_.captured && contact_times < kResolvedTimes) {
        step_limit_ = std::min(step_limit_, max_step_during_impact(impact, contact.normal));
      }
    }
    track.penetration = contact.closest.found ? contact.penetration : kNotFound;
    track.force = contact.normal;
    track.rate = contact.rate;
  }
}

std::vector<double> ImpactTracker::save() const {
  std::vector<double> out{step_limit_};
  for (const Track& t : tracks_) {
    out.insert(out.end(),
               {t.penetration, t.force, t.rate, t.open ? 1.0 : 0.0, t.impact.time, t.impact.approach_velocity,
                t.impact.peak_force, t.impact.duration, t.impact.impulse, t.box_force});
  }
  return out;
}

void ImpactTracker::restore(const std::vector<double>& saved) {
  step_limit_ = saved.at(0);
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const double* v = &saved.at(1 + kSaved * i);
    tracks_[i] = {v[0], v[1], v[2], v[3] != 0.0, false, {static_cast<int>(i), v[4], v[5], v[6], v[7], v[8], 0.0, 0.0},
                  v[9]};
  }
}

}  // namespace overbend
