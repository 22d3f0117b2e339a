#include "dynamics/integrator/time_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace overbend {
namespace {

constexpr double kMostFurther = 4.0;  ///< Iterations that cost less than new factors of all lines within a step.
constexpr int kMostOnOldFactors = 7;  ///< Iterations of a step, all in all.
constexpr int kOldestFactors = 20;    ///< Steps that factors may serve.
constexpr int kSlowStep = 3;          ///< Iterations, beyond which the next step begins with new factors.
constexpr int kMostRounds = 30;       ///< In which ends that give way find by how much.

/// What factors of a line cost, by its share of the nodes, in iterations of all lines; one more is needed anyway.
std::vector<double> iterations_for_factors(const System& system) {
  int nodes = 0;
  for (const Line& line : system.lines) nodes += line.mesh.nodes();
  std::vector<double> iterations;
  for (const Line& line : system.lines) {
    iterations.push_back(std::max(kMostFurther * line.mesh.nodes() / nodes, 1.0));
  }
  return iterations;
}

/// Sees iterations that go to and fro between two states: a contact that opens in one and closes in the other, of a
/// force that jumps, has no balance within this step, and more of them find none.
class ToAndFro {
 public:
  bool seen(double residual) {
    const bool again = same(residual, last_[1]) && same(last_[0], last_[2]);
    last_ = {residual, last_[0], last_[1]};
    return again;
  }

 private:
  static bool same(double a, double b) {
    constexpr double kAlike = 0.01;
    return std::abs(a - b) <= kAlike * a;
  }
  std::array<double, 3> last_{-1.0, -2.0, -4.0};  ///< Residuals, the latest first; at first no two alike.
};

/// Whether a line runs back through its guide: the equations balance there as well, with its last element inside out.
bool any_end_turned(const System& system, const SystemState& state) {
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
      giving_(assembly.system()),
      moves_(assembly.tensioners().size()),
      factored_governed_(moves_.size()),
      most_further_(iterations_for_factors(assembly.system())),
      slow_lines_(most_further_.size()),
      dq_(assembly.increments()),
      error_(assembly.system(), scheme_, settings.short_element) {}

void TimeStepper::correct(SystemState& next, double h) const {
  const double velocity = scheme_.velocity_share(h), acceleration = scheme_.acceleration_share(h);
  const double algorithmic = 1.0 / (h * h * scheme_.beta);
  for (std::size_t line = 0; line < next.lines.size(); ++line) {
    overbend::correct(scheme_, h, dq_[line], next.lines[line]);
  }
  for (std::size_t i = 0; i < next.bodies.size(); ++i) {
    HullState& at = next.bodies[i];
    const Vec6 dh = Eigen::Map<const Vec6>(dq_.back().data() + 6 * i);
    at.h += dh;
    at.v += velocity * dh;
    at.acc += acceleration * dh;
  }
  const auto correct_values = [&](MotionValues& values, const Vec3& direction, const double* dq) {
    const double d = direction.x() * dq[0] + direction.y() * dq[1] + direction.z() * dq[2];
    values.q += d;
    values.v += velocity * d;
    values.acc += acceleration * d;
    values.alg += algorithmic * d;
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
  return !factored_ || factored_step_ != h || factors_age_ >= kOldestFactors;
}

/// Factors the tangent made last, of a step of `h`; false where it is singular.
bool TimeStepper::make_factors(double h, StepReport& report) {
  ++report.factorisations;
  factored_ = assembly_->factor();
  factored_contacts_ = assembly_->contact_signature();
  factored_step_ = h;
  factors_age_ = 0;
  return factored_;
}

/// Whether the rate at which the factors bring a part's residual down leads to the tolerance too late: a line's, or at
/// the end the bodies'.
bool TimeStepper::slow(std::size_t part, double most_further) const {
  const double residual = assembly_->residuals()[part];
  return !(residual < settings_.tolerance) &&
         !(std::log(settings_.tolerance / residual) >= most_further * std::log(residual / before_[part]));
}

/// Lines that need new factors. Those with contacts wait for another look where these have just been renewed. False
/// where it is all lines or the bodies.
bool TimeStepper::find_slow_lines(bool contacts_renewed) {
  const std::size_t lines = slow_lines_.size();
  for (std::size_t i = 0; i < lines; ++i) {
    const bool renewed = contacts_renewed && assembly_->line(i).contacts().count() > 0;
    slow_lines_[i] = !renewed && slow(i, most_further_[i]) ? 1 : 0;
  }
  const bool all = lines > 0 && std::find(slow_lines_.begin(), slow_lines_.end(), 0) == slow_lines_.end();
  return !all && (contacts_renewed || before_.size() == lines || !slow(lines, kMostFurther));
}

/// Whether another correction may be made with the factors there are, brought up to the contacts and, of lines where
/// they are slow, made anew. They are kept where the rate at which they bring the residual down leads to the tolerance
/// soon enough: new ones cost less at the start of the next step, which is evaluated there anyway.
bool TimeStepper::factors_serve(const StepReport& report, const SystemState& now, SystemState& next,
                                const Weights& weights) {
  if (report.iterations >= kMostOnOldFactors) {
    return false;
  }
  const bool contacts_changed = assembly_->contact_signature() != factored_contacts_;
  if (contacts_changed) {
    factored_contacts_ = assembly_->contact_signature();
    if (!assembly_->renew_contacts(next, weights)) return false;
  }
  return find_slow_lines(contacts_changed) && assembly_->renew_lines(next, now, weights, slow_lines_);
}

StepReport TimeStepper::step(const SystemState& now, double h, SystemState& next) {
  constexpr int kMostDrives = 4;  // of a machine; two that each ask for the other differ by nothing
  const int most_tries = kMostDrives * std::max(1, static_cast<int>(moves_.size()));
  const System& system = assembly_->system();
  const double authority = tensioner_authority(system, now.time + 0.5 * h);
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    const std::size_t attachment = assembly_->tensioners()[i].attachment;
    const AttachmentState& held = now.attachments[attachment];
    const TensionerLaw& law = *system.attachments[attachment].tensioner;
    const Travel travel{held.travel.q, held.travel.v, held.travel.acc};
    moves_[i] = {first_drive(law, held.machine), reachable_speeds(law, held.machine, travel, authority, h)};
  }
  StepReport report;
  for (int tries = 0; tries < most_tries; ++tries) {
    const StepReport part = step_with_drives(now, h, next);
    const int iterations = report.iterations + part.iterations,
              factorisations = report.factorisations + part.factorisations;
    report = part;
    report.iterations = iterations;
    report.factorisations = factorisations;
    if (!report.converged() || !fit_drives(next)) break;
  }
  return report;
}

/// Whether a tensioner has another drive than the step was taken with.
bool TimeStepper::fit_drives(const SystemState& next) {
  bool changed = false;
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    const std::size_t attachment = assembly_->tensioners()[i].attachment;
    const TensionerLaw& law = *assembly_->system().attachments[attachment].tensioner;
    const TensionerDrive fitting = fitting_drive(law, moves_[i].bounds, moves_[i].drive,
                                                 next.attachments[attachment].travel.v, assembly_->tension(i));
    changed = changed || fitting != moves_[i].drive;
    moves_[i].drive = fitting;
  }
  return changed;
}

StepReport TimeStepper::step_with_drives(const SystemState& now, double h, SystemState& next) {
  StepReport report;
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    const char governed = moves_[i].drive == TensionerDrive::governor ? 1 : 0;
    factored_ = factored_ && governed == factored_governed_[i];
    factored_governed_[i] = governed;
  }
  predict(scheme_, *assembly_, now, h, moves_, next);
  giving_.begin(now, h, next);
  int rounds = 0, earlier = 0;
  assembly_->set_time(next.time, next);
  for (std::size_t i = 0; i < moves_.size(); ++i) assembly_->set_drive(i, moves_[i].drive);
  assembly_->impose_ends(next);
  const Weights weights{scheme_.velocity_share(h), scheme_.acceleration_share(h), h};
  bool factor = must_factor(h);
  before_.assign(slow_lines_.size() + (assembly_->free_bodies() > 0 ? 1 : 0), std::numeric_limits<double>::infinity());
  ToAndFro to_and_fro;
  while (report.iterations <= settings_.max_iterations) {
    const ContactMode contacts = report.iterations == 0 ? ContactMode::kept : ContactMode::free;
    assembly_->evaluate(next, now, weights, factor, contacts);
    assembly_->hold(factor);
    report.residual = assembly_->relative_residual();
    report.worst_place = assembly_->worst_place();
    if (!(report.residual < 1e6)) {
      report.end = StepEnd::lost;
      break;
    }
    if (report.residual < settings_.tolerance && assembly_->contacts_settled()) {
      if (!giving_.empty() && rounds < kMostRounds && !giving_.settle(*assembly_, now, h, next)) {
        ++rounds;
        earlier += report.iterations;
        report.iterations = 0;
        std::fill(before_.begin(), before_.end(), std::numeric_limits<double>::infinity());
        to_and_fro = {};  // what an end gives way by may put the same out of balance again
        assembly_->impose_ends(next);
        continue;
      }
      report.end = any_end_turned(assembly_->system(), next) ? StepEnd::lost
                   : rounds < kMostRounds                    ? StepEnd::converged
                                                             : StepEnd::too_many_iterations;
      end_accelerations(scheme_, now, next);
      assembly_->finish_step(now, h, next);
      break;
    }
    if (!factor && !factors_serve(report, now, next, weights)) {
      factor = true;
      continue;
    }
    if (to_and_fro.seen(report.residual)) break;
    ++report.iterations;
    before_ = assembly_->residuals();
    if (factor && !make_factors(h, report)) {
      report.end = StepEnd::singular;
      break;
    }
    factor = false;
    assembly_->solve_again(dq_);
    assembly_->end_iteration(next);
    correct(next, h);
    assembly_->impose_ends(next);
  }
  ++factors_age_;
  if (!report.converged() || report.iterations > kSlowStep) {
    factored_ = false;
  }
  report.iterations += earlier;
  return report;
}

}  // namespace overbend
