#include "dynamics/step_prediction.h"

#include <algorithm>

namespace overbend {
namespace {

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

void predict_travel(const GeneralizedAlpha& scheme, const TensionerLaw& law, const AttachmentState& now, double h,
                    double ratio, const SpeedBounds& bounds, AttachmentState& next) {
  const Travel from{now.travel.q, now.travel.v, now.travel.acc};
  const auto drive_to = [&](double speed) {
    const Travel to = now.machine.commanded ? led(law, from, speed, h) : driven(law, from, speed, h);
    next.travel = {to.length, to.speed, to.acceleration, to.acceleration};
  };
  switch (next.machine.drive) {
    case TensionerDrive::brake:
      next.travel = {now.travel.q, 0.0, 0.0, 0.0};
      return;
    case TensionerDrive::governor:
      next.travel = foreseen(scheme, now.travel, h, ratio);
      return;
    case TensionerDrive::slowest:
      drive_to(bounds.slowest);
      return;
    case TensionerDrive::fastest:
      drive_to(bounds.fastest);
      return;
  }
}

}  // namespace

void predict(const GeneralizedAlpha& scheme, const System& system, const SystemState& now, double h,
             const MachineStep& machine, SystemState& next) {
  begin_from(now, next);
  next.time = now.time + h;
  next.last_step = h;
  const double ratio = step_ratio(now, h);
  const Foresight foresight(scheme, h, ratio);
  for (std::size_t i = 0; i < now.lines.size(); ++i) {
    foresight.predict(now.lines[i], next.lines[i]);
  }
  for (std::size_t i = 0; i < now.bodies.size(); ++i) {
    foresight.predict(now.bodies[i], next.bodies[i]);
  }
  for (std::size_t i = 0; i < now.attachments.size(); ++i) {
    next.attachments[i].guide = foreseen(scheme, now.attachments[i].guide, h, ratio);
  }
  if (system.machine >= 0) {
    const std::size_t i = static_cast<std::size_t>(system.machine);
    next.attachments[i].machine.drive = machine.drive;
    predict_travel(scheme, tensioner_of(system), now.attachments[i], h, ratio, machine.bounds, next.attachments[i]);
  }
}

void end_accelerations(const GeneralizedAlpha& scheme, const SystemState& now, SystemState& next) {
  const double ratio = step_ratio(now, next.last_step);
  const double by_alg = 1.0 / (1.0 - scheme.alpha_m);
  const double of_next = by_alg * (1.0 - scheme.alpha_f), of_alg = -by_alg * scheme.alpha_m * ratio;
  const double of_acc = by_alg * (scheme.alpha_f - scheme.alpha_m * (1.0 - ratio));
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

}  // namespace overbend
