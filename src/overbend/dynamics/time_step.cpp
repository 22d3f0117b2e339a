#include "dynamics/time_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace overbend {
namespace {

constexpr double kPoorContraction = 0.3;  ///< Old factors that leave more of the residual than this are renewed.
constexpr int kOldestFactors = 20;        ///< Steps that factors may serve.
constexpr int kSlowStep = 5;              ///< Iterations after which old factors no longer serve.
constexpr int kMostRounds = 30;           ///< In which ends that give way find by how much.

/// Diagonal mass for the error estimate: half of each element's to its nodes, and what the cubic gives the tangents.
std::vector<double> lumped_mass(const Line& line) {
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

/// How much of a node's error counts. Of pipe all, but for what was added to it as laid behind the far end of statics.
/// There and in moorings, what an error does to the forces is that it turns the elements beside the node, and the
/// longer they are the less; up to 5 m all of it counts. (Lines that may meet rollers are pipe.)
std::vector<double> error_weights(const Line& line) {
  constexpr double kShort = 5.0;  // m
  std::vector<double> weights;
  for (int node = 0; node < line.mesh.nodes(); ++node) {
    const bool pipe = line.on_rollers && line.mesh.s[static_cast<std::size_t>(node)] >= 0.0;
    weights.push_back(pipe ? 1.0 : std::min(1.0, kShort / line.mesh.shortest_beside(node)));
  }
  return weights;
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

/// Of a step of `h` to the one that led to a state.
double step_ratio(const SystemState& now, double h) {
  return now.last_step > 0.0 ? h / now.last_step : 1.0;
}

Eigen::Map<const Eigen::ArrayXd> all(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}
Eigen::Map<Eigen::ArrayXd> all(std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// The algorithmic acceleration stands apart from the true one in proportion to the step it was made with: `ratio` is
/// that of the steps.
MotionValues corrected_for_step(MotionValues guide, double ratio) {
  guide.alg = guide.acc + ratio * (guide.alg - guide.acc);
  return guide;
}

/// After a step of `h`. What comes after a step of another length, impacts in most cases, is not foreseen.
MotionValues foreseen(const GeneralizedAlpha& scheme, MotionValues now, double h, double ratio) {
  now = corrected_for_step(now, ratio);
  return advance(scheme, now, h, ratio == 1.0 ? scheme.foreseen(now.acc, now.alg) : now.acc);
}

/// The same for many unknowns: it is linear in both accelerations.
struct Foresight {
  Foresight(const GeneralizedAlpha& scheme, double step, double ratio)
      : h(step),
        of_acc(foreseen(scheme, {0.0, 0.0, 1.0, 0.0}, step, ratio)),
        of_alg(foreseen(scheme, {0.0, 0.0, 0.0, 1.0}, step, ratio)) {}
  void predict(const LineState& now, LineState& next) const {
    const auto v = all(now.v), acc = all(now.acc), alg = all(now.alg);
    all(next.q) = all(now.q) + h * v + of_acc.q * acc + of_alg.q * alg;
    all(next.v) = v + of_acc.v * acc + of_alg.v * alg;
    all(next.acc) = of_acc.acc * acc + of_alg.acc * alg;
  }
  void predict(const HullState& now, HullState& next) const {
    next.h = now.h + h * now.v + of_acc.q * now.acc + of_alg.q * now.alg;
    next.v = now.v + of_acc.v * now.acc + of_alg.v * now.alg;
    next.acc = of_acc.acc * now.acc + of_alg.acc * now.alg;
  }
  double h;
  MotionValues of_acc, of_alg;
};

bool as_large(const LineState& a, const LineState& b) {
  return a.q.size() == b.q.size() && a.bed_slip.size() == b.bed_slip.size() && a.contacts.size() == b.contacts.size() &&
         a.bending.size() == b.bending.size();
}

/// What is not predicted, where the sizes are the same: nothing is allocated. Memories of the steel are looked after
/// where they are used, see LineAssembly::evaluate().
void begin_from(const SystemState& now, SystemState& next) {
  if (!std::equal(now.lines.begin(), now.lines.end(), next.lines.begin(), next.lines.end(), as_large)) {
    next = now;
    return;
  }
  for (std::size_t i = 0; i < now.lines.size(); ++i) {
    const LineState& from = now.lines[i];
    LineState& to = next.lines[i];
    to.bed_slip = from.bed_slip;
    to.contacts = from.contacts;
    to.bending_heat = from.bending_heat;
  }
  next.attachments = now.attachments;
  next.bodies = now.bodies;
}

}  // namespace

TimeStepper::TimeStepper(Assembly& assembly, const StepSettings& settings)
    : assembly_(&assembly),
      settings_(settings),
      scheme_(settings.spectral_radius),
      giving_(assembly.system()),
      dq_(assembly.increments()) {
  for (const Line& line : assembly.system().lines) {
    lumped_mass_.push_back(lumped_mass(line));
    error_weights_.push_back(error_weights(line));
  }
}

void TimeStepper::predict(const SystemState& now, double h, TensionerDrive drive, const SpeedBounds& bounds,
                          SystemState& next) const {
  begin_from(now, next);
  next.time = now.time + h;
  next.last_step = h;
  const double ratio = step_ratio(now, h);
  const Foresight foresight(scheme_, h, ratio);
  for (std::size_t i = 0; i < now.lines.size(); ++i) {
    foresight.predict(now.lines[i], next.lines[i]);
  }
  for (std::size_t i = 0; i < now.bodies.size(); ++i) {
    foresight.predict(now.bodies[i], next.bodies[i]);
  }
  for (std::size_t i = 0; i < now.attachments.size(); ++i) {
    next.attachments[i].guide = foreseen(scheme_, now.attachments[i].guide, h, ratio);
  }
  if (assembly_->system().machine >= 0) {
    const std::size_t machine = static_cast<std::size_t>(assembly_->system().machine);
    next.attachments[machine].machine.drive = drive;
    predict_travel(now.attachments[machine], h, ratio, bounds, next.attachments[machine]);
  }
}

/// Algorithmic accelerations of what has moved as it was led too, see GeneralizedAlpha.
void TimeStepper::end_accelerations(const SystemState& now, double ratio, SystemState& next) const {
  const double by_alg = 1.0 / (1.0 - scheme_.alpha_m);
  const double of_next = by_alg * (1.0 - scheme_.alpha_f), of_alg = -by_alg * scheme_.alpha_m * ratio;
  const double of_acc = by_alg * (scheme_.alpha_f - scheme_.alpha_m * (1.0 - ratio));
  for (std::size_t line = 0; line < now.lines.size(); ++line) {
    const LineState& from = now.lines[line];
    LineState& to = next.lines[line];
    for (std::size_t i = 0; i < to.alg.size(); ++i) {
      to.alg[i] = of_next * to.acc[i] + of_acc * from.acc[i] + of_alg * from.alg[i];
    }
  }
  for (std::size_t i = 0; i < now.bodies.size(); ++i) {
    next.bodies[i].alg = of_next * next.bodies[i].acc + of_acc * now.bodies[i].acc + of_alg * now.bodies[i].alg;
  }
}

void TimeStepper::predict_travel(const AttachmentState& now, double h, double ratio, const SpeedBounds& bounds,
                                 AttachmentState& next) const {
  const Travel from{now.travel.q, now.travel.v, now.travel.acc};
  const auto drive_to = [&](double speed) {
    const TensionerLaw& law = tensioner_of(assembly_->system());
    const Travel to = now.machine.commanded ? led(law, from, speed, h) : driven(law, from, speed, h);
    next.travel = {to.length, to.speed, to.acceleration, to.acceleration};
  };
  switch (next.machine.drive) {
    case TensionerDrive::brake:
      next.travel = {now.travel.q, 0.0, 0.0, 0.0};
      return;
    case TensionerDrive::governor:
      next.travel = foreseen(scheme_, now.travel, h, ratio);
      return;
    case TensionerDrive::slowest:
      drive_to(bounds.slowest);
      return;
    case TensionerDrive::fastest:
      drive_to(bounds.fastest);
      return;
  }
}

void TimeStepper::correct(SystemState& next, double h) const {
  const double velocity = scheme_.velocity_share(h), acceleration = scheme_.acceleration_share(h);
  const double algorithmic = 1.0 / (h * h * scheme_.beta);
  for (std::size_t line = 0; line < next.lines.size(); ++line) {
    LineState& at = next.lines[line];
    const std::vector<double>& dq = dq_[line];
    for (std::size_t i = 0; i < at.q.size(); ++i) {
      at.q[i] += dq[i];
      at.v[i] += velocity * dq[i];
      at.acc[i] += acceleration * dq[i];
    }
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
    const double* dq = dq_[line].data() + 6 * assembly_->line(line).end_node(held.end);
    correct_values(next.attachments[i].guide, direction, dq + 3);
    if (static_cast<int>(i) == system.machine && next.attachments[i].machine.drive == TensionerDrive::governor) {
      correct_values(next.attachments[i].travel, -direction, dq);
    }
  }
}

bool TimeStepper::must_factor(double h) const {
  return !factored_ || factored_step_ != h || factors_age_ >= kOldestFactors;
}

/// Whether another correction may be made with the factors there are, brought up to the contacts.
bool TimeStepper::factors_serve(const StepReport& report, double residual_before, const SystemState& next,
                                const Weights& weights) {
  if (report.iterations >= kSlowStep) {
    return false;
  }
  if (assembly_->contact_signature() != factored_contacts_) {
    return assembly_->renew_contacts(next, weights);
  }
  return report.residual <= kPoorContraction * residual_before;
}

StepReport TimeStepper::step(const SystemState& now, double h, SystemState& next) {
  constexpr int kMostDrives = 4;  // two that each ask for the other differ by nothing
  const System& system = assembly_->system();
  if (system.machine < 0) {
    return step_with(TensionerDrive::brake, {}, now, h, next);
  }
  const std::size_t machine = static_cast<std::size_t>(system.machine);
  const AttachmentState& held = now.attachments[machine];
  const TensionerLaw& law = tensioner_of(system);
  const Travel travel{held.travel.q, held.travel.v, held.travel.acc};
  const double authority = tensioner_authority(system, now.time + 0.5 * h);
  const SpeedBounds bounds = reachable_speeds(law, held.machine, travel, authority, h);
  TensionerDrive drive = first_drive(law, held.machine);
  StepReport report;
  for (int tries = 0; tries < kMostDrives; ++tries) {
    const StepReport part = step_with(drive, bounds, now, h, next);
    const int iterations = report.iterations + part.iterations,
              factorisations = report.factorisations + part.factorisations;
    report = part;
    report.iterations = iterations;
    report.factorisations = factorisations;
    const TensionerDrive fitting =
        fitting_drive(law, bounds, drive, next.attachments[machine].travel.v, assembly_->machine_tension());
    if (!report.converged() || fitting == drive) {
      break;
    }
    drive = fitting;
  }
  return report;
}

StepReport TimeStepper::step_with(TensionerDrive drive, const SpeedBounds& bounds, const SystemState& now, double h,
                                  SystemState& next) {
  StepReport report;
  const bool governed = drive == TensionerDrive::governor;
  factored_ = factored_ && governed == factored_governed_;
  factored_governed_ = governed;
  predict(now, h, drive, bounds, next);
  giving_.begin(now, h, next);
  int rounds = 0, earlier = 0;
  assembly_->set_time(next.time, next);
  assembly_->set_drive(drive);
  assembly_->impose_ends(next);
  const Weights weights{scheme_.velocity_share(h), scheme_.acceleration_share(h), h};
  bool factor = must_factor(h);
  double before = std::numeric_limits<double>::infinity();
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
        before = std::numeric_limits<double>::infinity();
        assembly_->impose_ends(next);
        continue;
      }
      report.end = rounds < kMostRounds ? StepEnd::converged : StepEnd::too_many_iterations;
      end_accelerations(now, step_ratio(now, h), next);
      assembly_->finish_step(now, h, next);
      break;
    }
    if (!factor && !factors_serve(report, before, next, weights)) {
      factor = true;
      continue;
    }
    if (to_and_fro.seen(report.residual)) break;
    ++report.iterations;
    before = report.residual;
    if (factor) {
      ++report.factorisations;
      if (!assembly_->solve_factored(dq_)) {
        report.end = StepEnd::singular;
        break;
      }
      factors_age_ = 0;
    } else {
      assembly_->solve_again(dq_);
    }
    factored_ = true;
    factored_contacts_ = assembly_->contact_signature();
    factored_step_ = h;
    factor = false;
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

double TimeStepper::local_error(const SystemState& now, const SystemState& next) {
  const double h = next.last_step;
  const double factor = std::abs(1.0 / 6.0 - scheme_.beta) * h * h * scheme_.acceleration_share(h);
  for (std::size_t line = 0; line < next.lines.size(); ++line) {
    for (std::size_t i = 0; i < dq_[line].size(); ++i) {
      dq_[line][i] = factor * lumped_mass_[line][i] * (next.lines[line].acc[i] - now.lines[line].acc[i]);
    }
  }
  for (const Attachment& held : assembly_->system().attachments) {
    const std::size_t line = static_cast<std::size_t>(held.line);
    const auto node = dq_[line].begin() + 6 * assembly_->line(line).end_node(held.end);
    std::fill_n(node, held.hold_place ? 6 : 0, 0.0);
  }
  for (std::size_t i = 0; i < next.bodies.size(); ++i) {
    const Vec6 change = next.bodies[i].acc - now.bodies[i].acc;
    Eigen::Map<Vec6>(dq_.back().data() + 6 * i) = factor * assembly_->free_body(i).inertia.cwiseProduct(change);
  }
  assembly_->apply_factors(dq_);
  double worst = body_error();
  for (std::size_t line = 0; line < next.lines.size(); ++line) {
    const std::vector<double>& dq = dq_[line];
    for (std::size_t i = 0; i < dq.size(); i += 6) {
      const double weight = error_weights_[line][i / 6];
      worst = std::max(worst, weight * weight * (dq[i] * dq[i] + dq[i + 1] * dq[i + 1] + dq[i + 2] * dq[i + 2]));
    }
  }
  return std::sqrt(worst);
}

/// Squared, of the bodies among the filtered errors [m2].
double TimeStepper::body_error() const {
  double worst = 0.0;
  for (std::size_t i = 0; i < assembly_->free_bodies(); ++i) {
    const Vec6 dh = Eigen::Map<const Vec6>(dq_.back().data() + 6 * i);
    const double arm = assembly_->free_body(i).arm;
    worst = std::max({worst, dh.head<3>().squaredNorm(), arm * arm * dh.tail<3>().squaredNorm()});
  }
  return worst;
}

}  // namespace overbend
