#include "dynamics/integrator/time_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace overbend {
namespace {

/// Maximum number of further iterations that cost less than new factors of all lines within a step.
constexpr double kMaxFurtherIterations = 4.0;
constexpr int kMaxIterationsOnOldFactors = 7;  ///< Maximum number of iterations of a step without new factors.
constexpr int kMaxFactorAge = 20;              ///< Maximum age of factors in steps.
constexpr int kSlowStepIterations = 3;  ///< Number of iterations beyond which the next step begins with new factors.
constexpr int kMaxPayoutRounds = 30;    ///< Maximum number of rounds of the end payouts.

/// Cost of factoring a line, by its share of the nodes, in iterations of all lines; one more iteration is needed in any
/// case.
std::vector<double> iterations_for_factors(const System& system) {
  int nodes = 0;
  for (const Line& line : system.lines) nodes += line.mesh.nodes();
  std::vector<double> iterations;
  for (const Line& line : system.lines) {
    iterations.push_back(std::max(kMaxFurtherIterations * line.mesh.nodes() / nodes, 1.0));
  }
  return iterations;
}

/// Detects a two-cycle of the Newton iteration: a contact that opens in one state and closes in the other under a force
/// that jumps has no equilibrium within this step, and further iterations find none.
class ResidualCycleDetector {
 public:
  bool seen(double residual) {
    const bool again = same(residual, last_[1]) && same(last_[0], last_[2]);
    last_ = {residual, last_[0], last_[1]};
    return again;
  }

 private:
  static bool same(double a, double b) {
    constexpr double kSameResidual = 0.01;
    return std::abs(a - b) <= kSameResidual * a;
  }
  std::array<double, 3> last_{-1.0, -2.0, -4.0};  ///< Residuals, the latest first; initial values all different.
};

/// True if a line runs back through its guide: the equations also balance there, with the last element inside out.
bool any_end_inverted(const System& system, const SystemState& state) {
  for (std::size_t i = 0; i < state.attachments.size(); ++i) {
    if (system.attachments[i].hold_direction && state.attachments[i].guide.q <= 0.0) return true;
  }
  return false;
}

}  // namespace

TimeStepper::TimeStepper(Assembly& assembly, const StepSettings& settings)
    : assembly_(&assembly),
      settings_(settings),
      scheme_(settings.spectral_radius),
      end_payouts_(assembly.system()),
      moves_(assembly.tensioners().size()),
      factored_governed_(moves_.size()),
      max_further_iterations_(iterations_for_factors(assembly.system())),
      slow_lines_(max_further_iterations_.size()),
      dq_(assembly.increments()),
      error_(assembly.system(), scheme_, settings.short_element) {}

void TimeStepper::correct(SystemState& next, double h) const {
  const double velocity = scheme_.velocity_share(h), acceleration = scheme_.acceleration_share(h);
  const double algorithmic = 1.0 / (h * h * scheme_.beta);
  for (std::size_t line = 0; line < next.lines.size(); ++line) {
    overbend::correct(scheme_, h, dq_[line], next.lines[line]);
  }
  for (std::size_t i = 0; i < next.bodies.size(); ++i) {
    HullState& body = next.bodies[i];
    const Vec6 dh = Eigen::Map<const Vec6>(dq_.back().data() + 6 * i);
    body.h += dh;
    body.v += velocity * dh;
    body.acc += acceleration * dh;
  }
  const auto correct_values = [&](MotionValues& values, const Vec3& direction, const double* dq) {
    const double d = direction.x() * dq[0] + direction.y() * dq[1] + direction.z() * dq[2];
    values.q += d;
    values.v += velocity * d;
    values.acc += acceleration * d;
    values.algorithmic_acceleration += algorithmic * d;
  };
  const System& system = assembly_->system();
  for (std::size_t i = 0; i < next.attachments.size(); ++i) {
    const Attachment& held = system.attachments[i];
    const std::size_t line = static_cast<std::size_t>(held.line);
    const Vec3& direction = assembly_->surroundings().ends[i].direction;
    const double* dq = dq_[line].data() + 6 * held_node(held, system.lines[line]);
    correct_values(next.attachments[i].guide, direction, dq + 3);
    if (system.attachments[i].tensioner && next.attachments[i].machine.drive == TensionerDrive::governor) {
      correct_values(next.attachments[i].travel, -direction, dq);
    }
  }
}

bool TimeStepper::must_factor(double h) const {
  return !factored_ || factored_step_ != h || factors_age_ >= kMaxFactorAge;
}

/// Factors the latest tangent for a step of `h`; returns false if it is singular.
bool TimeStepper::make_factors(double h, StepReport& report) {
  ++report.factorisations;
  factored_ = assembly_->factor();
  factored_contacts_ = assembly_->contact_signature();
  factored_step_ = h;
  factors_age_ = 0;
  return factored_;
}

/// True if the convergence rate with the present factors reaches the tolerance too late. `part`: a line or, last, the
/// bodies.
bool TimeStepper::converges_slowly(std::size_t part, double max_further_iterations) const {
  const double residual = assembly_->residuals()[part];
  return !(residual < settings_.tolerance) &&
         !(std::log(settings_.tolerance / residual) >= max_further_iterations * std::log(residual / before_[part]));
}

/// Marks the lines that need new factors. Lines with contacts are deferred if their contacts have just been renewed.
/// Returns false if all lines or the bodies need new factors.
bool TimeStepper::find_slow_lines(bool contacts_renewed) {
  const std::size_t lines = slow_lines_.size();
  for (std::size_t i = 0; i < lines; ++i) {
    const bool renewed = contacts_renewed && assembly_->line(i).contacts().count() > 0;
    slow_lines_[i] = !renewed && converges_slowly(i, max_further_iterations_[i]) ? 1 : 0;
  }
  const bool all = lines > 0 && std::find(slow_lines_.begin(), slow_lines_.end(), 0) == slow_lines_.end();
  return !all && (contacts_renewed || before_.size() == lines || !converges_slowly(lines, kMaxFurtherIterations));
}

/// True if another correction can use the present factors, updated for the contacts and renewed for slow lines. Factors
/// are kept while their convergence rate reaches the tolerance soon enough: new ones cost less at the start of the next
/// step, which is evaluated there anyway.
bool TimeStepper::can_reuse_factors(const StepReport& report, const SystemState& start, SystemState& next,
                                    const Weights& weights) {
  if (report.iterations >= kMaxIterationsOnOldFactors) {
    return false;
  }
  const bool contacts_changed = assembly_->contact_signature() != factored_contacts_;
  if (contacts_changed) {
    factored_contacts_ = assembly_->contact_signature();
    if (!assembly_->renew_contacts(next, weights)) return false;
  }
  return find_slow_lines(contacts_changed) && assembly_->renew_lines(next, start, weights, slow_lines_);
}

StepReport TimeStepper::step(const SystemState& start, double h, SystemState& next) {
  // per machine; two drive modes that each request the other differ by a negligible amount
  constexpr int kMaxDriveChanges = 4;
  const int max_tries = kMaxDriveChanges * std::max(1, static_cast<int>(moves_.size()));
  const System& system = assembly_->system();
  const double authority = tensioner_ramp_factor(system, start.time + 0.5 * h);
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    const std::size_t attachment = assembly_->tensioners()[i].attachment;
    const AttachmentState& held = start.attachments[attachment];
    const TensionerLaw& law = *system.attachments[attachment].tensioner;
    const Travel travel{held.travel.q, held.travel.v, held.travel.acc};
    moves_[i] = {first_drive(law, held.machine), reachable_speeds(law, held.machine, travel, authority, h)};
  }
  StepReport report;
  for (int tries = 0; tries < max_tries; ++tries) {
    const StepReport part = step_with_drives(start, h, next);
    const int iterations = report.iterations + part.iterations,
              factorisations = report.factorisations + part.factorisations;
    report = part;
    report.iterations = iterations;
    report.factorisations = factorisations;
    if (!report.converged() || !update_drives(next)) break;
  }
  return report;
}

/// True if a tensioner requires another drive mode than that of the step.
bool TimeStepper::update_drives(const SystemState& next) {
  bool changed = false;
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    const std::size_t attachment = assembly_->tensioners()[i].attachment;
    const TensionerLaw& law = *assembly_->system().attachments[attachment].tensioner;
    const TensionerDrive fitting = matching_drive(law, moves_[i].bounds, moves_[i].drive,
                                                  next.attachments[attachment].travel.v, assembly_->tension(i));
    changed = changed || fitting != moves_[i].drive;
    moves_[i].drive = fitting;
  }
  return changed;
}

StepReport TimeStepper::step_with_drives(const SystemState& start, double h, SystemState& next) {
  StepReport report;
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    const char governed = moves_[i].drive == TensionerDrive::governor ? 1 : 0;
    factored_ = factored_ && governed == factored_governed_[i];
    factored_governed_[i] = governed;
  }
  predict(scheme_, *assembly_, start, h, moves_, next);
  end_payouts_.begin(start, h, next);
  int rounds = 0, earlier = 0;
  assembly_->set_time(next.time, next);
  for (std::size_t i = 0; i < moves_.size(); ++i) assembly_->set_drive(i, moves_[i].drive);
  assembly_->impose_ends(next);
  const Weights weights{scheme_.velocity_share(h), scheme_.acceleration_share(h), h};
  bool factor = must_factor(h);
  before_.assign(slow_lines_.size() + (assembly_->free_bodies() > 0 ? 1 : 0), std::numeric_limits<double>::infinity());
  ResidualCycleDetector cycle_detector;
  while (report.iterations <= settings_.max_iterations) {
    const ContactMode contacts = report.iterations == 0 ? ContactMode::kept : ContactMode::free;
    assembly_->evaluate(next, start, weights, factor, contacts);
    assembly_->hold(factor);
    report.residual = assembly_->relative_residual();
    report.worst_place = assembly_->worst_place();
    if (!(report.residual < 1e6)) {
      report.end = StepStatus::lost;
      break;
    }
    if (report.residual < settings_.tolerance && assembly_->contacts_settled()) {
      if (!end_payouts_.empty() && rounds < kMaxPayoutRounds && !end_payouts_.settle(*assembly_, start, h, next)) {
        ++rounds;
        earlier += report.iterations;
        report.iterations = 0;
        std::fill(before_.begin(), before_.end(), std::numeric_limits<double>::infinity());
        cycle_detector = {};  // payout of an end may unbalance the same contact again
        assembly_->impose_ends(next);
        continue;
      }
      report.end = any_end_inverted(assembly_->system(), next) ? StepStatus::lost
                   : rounds < kMaxPayoutRounds                 ? StepStatus::converged
                                                               : StepStatus::too_many_iterations;
      end_accelerations(scheme_, start, next);
      assembly_->finish_step(start, h, next);
      break;
    }
    if (!factor && !can_reuse_factors(report, start, next, weights)) {
      factor = true;
      continue;
    }
    if (cycle_detector.seen(report.residual)) break;
    ++report.iterations;
    before_ = assembly_->residuals();
    if (factor && !make_factors(h, report)) {
      report.end = StepStatus::singular;
      break;
    }
    factor = false;
    assembly_->solve_again(dq_);
    assembly_->end_iteration(next);
    correct(next, h);
    assembly_->impose_ends(next);
  }
  ++factors_age_;
  if (!report.converged() || report.iterations > kSlowStepIterations) {
    factored_ = false;
  }
  report.iterations += earlier;
  return report;
}

}  // namespace overbend
