#include "dynamics/time_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overbend {
namespace {

constexpr double kPoorContraction = 0.3;  ///< Old factors that leave more of the residual than this are renewed.
constexpr int kOldestFactors = 20;        ///< Steps that factors may serve.
constexpr int kSlowStep = 5;              ///< Iterations after which old factors no longer serve.

/// Diagonal mass for the error estimate: half of each element's to its nodes, and what the cubic gives the tangents.
std::vector<double> lumped_mass(const DynamicLine& line) {
  std::vector<double> mass(6 * static_cast<std::size_t>(line.mesh.nodes()), 0.0);
  for (std::size_t e = 0; e < line.mesh.length.size(); ++e) {
    const double h = line.mesh.length[e];
    const double m = (line.elements.mass[e] + line.elements.added_normal[e]) * h;
    for (std::size_t node = e; node < e + 2; ++node) {
      for (std::size_t i = 0; i < 3; ++i) {
        mass[6 * node + i] += 0.5 * m;
        mass[6 * node + 3 + i] += m * h * h / 105.0;
      }
    }
  }
  return mass;
}

GuideValues corrected_for_step(GuideValues guide, double ratio) {
  guide.alg = guide.acc + ratio * (guide.alg - guide.acc);
  return guide;
}

}  // namespace

TimeStepper::TimeStepper(DynamicSystem& system, const StepSettings& settings)
    : system_(&system),
      settings_(settings),
      scheme_(settings.spectral_radius),
      dq_(system.residual().size()),
      lumped_mass_(lumped_mass(system.line())) {}

void TimeStepper::predict(const DynamicState& now, double h, TensionerDrive drive, const SpeedBounds& bounds,
                          DynamicState& next) const {
  next = now;  // same sizes: nothing is allocated
  next.machine.drive = drive;
  next.time = now.time + h;
  next.last_step = h;
  // The algorithmic acceleration stands apart from the true one in proportion to the step it was made with.
  const double ratio = now.last_step > 0.0 ? h / now.last_step : 1.0;
  const double by_alg = 1.0 / (1.0 - scheme_.alpha_m);
  for (std::size_t i = 0; i < now.q.size(); ++i) {
    const double alg = now.acc[i] + ratio * (now.alg[i] - now.acc[i]);
    const double next_alg = by_alg * (now.acc[i] - scheme_.alpha_m * alg);
    next.alg[i] = next_alg;
    next.q[i] = now.q[i] + h * now.v[i] + h * h * ((0.5 - scheme_.beta) * alg + scheme_.beta * next_alg);
    next.v[i] = now.v[i] + h * ((1.0 - scheme_.gamma) * alg + scheme_.gamma * next_alg);
  }
  next.anchor_guide = advance(scheme_, corrected_for_step(now.anchor_guide, ratio), h, now.anchor_guide.acc);
  next.top_guide = advance(scheme_, corrected_for_step(now.top_guide, ratio), h, now.top_guide.acc);
  predict_travel(now, h, bounds, next);
}

void TimeStepper::predict_travel(const DynamicState& now, double h, const SpeedBounds& bounds,
                                 DynamicState& next) const {
  const double ratio = now.last_step > 0.0 ? h / now.last_step : 1.0;
  const Travel from{now.travel.q, now.travel.v, now.travel.acc};
  const auto drive_to = [&](double speed) {
    const Travel to = driven(system_->line().tensioner, from, speed, h);
    next.travel = {to.length, to.speed, to.acceleration, to.acceleration};
  };
  switch (next.machine.drive) {
    case TensionerDrive::brake:
      next.travel = {now.travel.q, 0.0, 0.0, 0.0};
      return;
    case TensionerDrive::governor:
      next.travel = advance(scheme_, corrected_for_step(now.travel, ratio), h, now.travel.acc);
      return;
    case TensionerDrive::slowest:
      drive_to(bounds.slowest);
      return;
    case TensionerDrive::fastest:
      drive_to(bounds.fastest);
      return;
  }
}

void TimeStepper::correct(DynamicState& next, double h) const {
  const double velocity = scheme_.velocity_share(h), acceleration = scheme_.acceleration_share(h);
  const double algorithmic = 1.0 / (h * h * scheme_.beta);
  for (std::size_t i = 0; i < next.q.size(); ++i) {
    next.q[i] += dq_[i];
    next.v[i] += velocity * dq_[i];
    next.acc[i] += acceleration * dq_[i];
    next.alg[i] += algorithmic * dq_[i];
  }
  const auto correct_guide = [&](MotionValues& guide, const Vec3& direction, std::size_t first) {
    const double d = direction.x() * dq_[first] + direction.y() * dq_[first + 1] + direction.z() * dq_[first + 2];
    guide.q += d;
    guide.v += velocity * d;
    guide.acc += acceleration * d;
    guide.alg += algorithmic * d;
  };
  correct_guide(next.anchor_guide, system_->surroundings().anchor.direction, 3);
  correct_guide(next.top_guide, system_->surroundings().top.direction, dq_.size() - 3);
  if (next.machine.drive == TensionerDrive::governor) {
    correct_guide(next.travel, -system_->surroundings().top.direction, dq_.size() - 6);
  }
}

bool TimeStepper::must_factor(double h) const {
  return !factored_ || factored_step_ != h || factors_age_ >= kOldestFactors;
}

/// Whether another correction may be made with the factors there are, brought up to the contacts.
bool TimeStepper::factors_serve(const StepReport& report, double residual_before, const DynamicState& next,
                                const StepShares& shares) {
  if (report.iterations >= kSlowStep) {
    return false;
  }
  if (system_->contact_signature() != factored_contacts_) {
    return system_->renew_contacts(next, shares);
  }
  return report.residual <= kPoorContraction * residual_before;
}

StepReport TimeStepper::step(const DynamicState& now, double h, DynamicState& next) {
  constexpr int kMostDrives = 4;  // two that each ask for the other differ by nothing
  const TensionerLaw& law = system_->line().tensioner;
  const Travel travel{now.travel.q, now.travel.v, now.travel.acc};
  const double authority = tensioner_authority(system_->line(), now.time + 0.5 * h);
  const SpeedBounds bounds = reachable_speeds(law, now.machine, travel, authority, h);
  TensionerDrive drive = first_drive(law, now.machine);
  StepReport report;
  for (int tries = 0; tries < kMostDrives; ++tries) {
    const StepReport part = step_with(drive, bounds, now, h, next);
    const int iterations = report.iterations + part.iterations,
              factorisations = report.factorisations + part.factorisations;
    report = part;
    report.iterations = iterations;
    report.factorisations = factorisations;
    const TensionerDrive fitting = fitting_drive(law, bounds, drive, next.travel.v, system_->machine_tension());
    if (!report.converged() || fitting == drive) {
      break;
    }
    drive = fitting;
  }
  return report;
}

StepReport TimeStepper::step_with(TensionerDrive drive, const SpeedBounds& bounds, const DynamicState& now, double h,
                                  DynamicState& next) {
  StepReport report;
  const bool governed = drive == TensionerDrive::governor;
  factored_ = factored_ && governed == factored_governed_;
  factored_governed_ = governed;
  predict(now, h, drive, bounds, next);
  system_->set_time(next.time, next);
  system_->set_drive(drive);
  system_->impose_ends(next);
  const StepShares shares{scheme_.velocity_share(h), scheme_.acceleration_share(h), h};
  bool factor = must_factor(h);
  double before = std::numeric_limits<double>::infinity();
  while (report.iterations <= settings_.max_iterations) {
    const ContactMode contacts = report.iterations == 0 ? ContactMode::kept : ContactMode::free;
    system_->evaluate(next, now, shares, factor, contacts);
    system_->hold(factor);
    report.residual = system_->relative_residual();
    report.worst_node = system_->worst_node();
    if (!(report.residual < 1e6)) {
      report.end = StepEnd::lost;
      break;
    }
    if (report.residual < settings_.tolerance && system_->contacts_settled()) {
      report.end = StepEnd::converged;
      break;
    }
    if (!factor && !factors_serve(report, before, next, shares)) {
      factor = true;
      continue;
    }
    ++report.iterations;
    before = report.residual;
    if (factor) {
      ++report.factorisations;
      if (!system_->solve_factored(dq_)) {
        report.end = StepEnd::singular;
        break;
      }
      factors_age_ = 0;
    } else {
      system_->solve_again(dq_);
    }
    factored_ = true;
    factored_contacts_ = system_->contact_signature();
    factored_step_ = h;
    factor = false;
    system_->end_iteration(next);
    correct(next, h);
    system_->impose_ends(next);
  }
  ++factors_age_;
  if (!report.converged() || report.iterations > kSlowStep) {
    factored_ = false;
  }
  return report;
}

double TimeStepper::local_error(const DynamicState& now, const DynamicState& next) {
  const double h = next.last_step;
  const double factor = std::abs(1.0 / 6.0 - scheme_.beta) * h * h * scheme_.acceleration_share(h);
  for (std::size_t i = 0; i < dq_.size(); ++i) {
    dq_[i] = factor * lumped_mass_[i] * (next.acc[i] - now.acc[i]);
  }
  const std::size_t top = dq_.size() - 6;
  std::fill_n(dq_.begin(), system_->line().anchor.hold_place ? 6 : 0, 0.0);
  std::fill_n(dq_.begin() + static_cast<std::ptrdiff_t>(top), system_->line().top.hold_place ? 6 : 0, 0.0);
  resolve(system_->tangent(), dq_.data());
  double worst = 0.0;
  for (std::size_t i = 0; i < dq_.size(); i += 6) {
    worst = std::max(worst, dq_[i] * dq_[i] + dq_[i + 1] * dq_[i + 1] + dq_[i + 2] * dq_[i + 2]);
  }
  return std::sqrt(worst);
}

}  // namespace overbend
