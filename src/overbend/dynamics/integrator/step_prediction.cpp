#include "dynamics/integrator/step_prediction.h"

#include <algorithm>

#include "base/simd.h"
#include "dynamics/integrator/motion_kernel.h"

namespace overbend {
namespace {

struct MotionKernels {
  void (*predict)(const PredictionShares&, const FreedomsBefore&, const FreedomsView&);
  void (*correct)(const CorrectionShares&, const double*, const FreedomsView&);
  ChangeSums (*end)(const EndShares&, const FreedomsBefore&, int, const double*, double*);
};

MotionKernels kernels() {
#if defined(OVERBEND_X86_KERNELS)
  if (best_isa() == Isa::avx512) {
    return {isa_avx512::predict_freedoms, isa_avx512::correct_freedoms, isa_avx512::end_freedoms};
  }
  if (best_isa() == Isa::avx2) {
    return {isa_avx2::predict_freedoms, isa_avx2::correct_freedoms, isa_avx2::end_freedoms};
  }
#endif
  return {isa_baseline::predict_freedoms, isa_baseline::correct_freedoms, isa_baseline::end_freedoms};
}

FreedomsBefore before(const LineState& now) {
  return {now.q.data(), now.v.data(), now.acc.data(), now.alg.data()};
}
FreedomsView view(LineState& next) {
  return {static_cast<int>(next.q.size()), next.q.data(), next.v.data(), next.acc.data()};
}

/// Of a step of `h` to the one that led to a state.
double step_ratio(const SystemState& now, double h) {
  return now.last_step > 0.0 ? h / now.last_step : 1.0;
}

/// The algorithmic acceleration stands apart from the true one in proportion to the step it was made with: `ratio` is
/// that of the steps.
MotionValues corrected_for_step(MotionValues guide, double ratio) {
  guide.alg = guide.acc + ratio * (guide.alg - guide.acc);
  return guide;
}

/// After a step of `h`, by `foresight` of what stands between the accelerations. What comes after a step of another
/// length, impacts in most cases, is not foreseen.
MotionValues foreseen(const GeneralizedAlpha& scheme, MotionValues now, double h, double ratio, double foresight) {
  now = corrected_for_step(now, ratio);
  return advance(scheme, now, h, ratio == 1.0 ? GeneralizedAlpha::foreseen(now.acc, now.alg, foresight) : now.acc);
}

MotionValues foreseen(const GeneralizedAlpha& scheme, const MotionValues& now, double h, double ratio) {
  return foreseen(scheme, now, h, ratio, scheme.half_foresight);
}

/// The same for many unknowns: it is linear in both accelerations.
struct Foresight {
  Foresight(const GeneralizedAlpha& scheme, double step, double ratio, double foresight)
      : h(step),
        of_acc(foreseen(scheme, {0.0, 0.0, 1.0, 0.0}, step, ratio, foresight)),
        of_alg(foreseen(scheme, {0.0, 0.0, 0.0, 1.0}, step, ratio, foresight)) {}
  void predict(const LineState& now, LineState& next) const {
    kernels().predict({h, of_acc.q, of_alg.q, of_acc.v, of_alg.v, of_acc.acc, of_alg.acc}, before(now), view(next));
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

void predict(const GeneralizedAlpha& scheme, const Assembly& assembly, const SystemState& now, double h,
             const std::vector<MachineStep>& moves, SystemState& next) {
  begin_from(now, next);
  next.time = now.time + h;
  next.last_step = h;
  const double ratio = step_ratio(now, h);
  for (std::size_t i = 0; i < now.lines.size(); ++i) {
    Foresight(scheme, h, ratio, now.lines[i].foresight).predict(now.lines[i], next.lines[i]);
  }
  const Foresight half(scheme, h, ratio, scheme.half_foresight);
  for (std::size_t i = 0; i < now.bodies.size(); ++i) {
    half.predict(now.bodies[i], next.bodies[i]);
  }
  for (std::size_t i = 0; i < now.attachments.size(); ++i) {
    next.attachments[i].guide = foreseen(scheme, now.attachments[i].guide, h, ratio);
  }
  for (std::size_t number = 0; number < moves.size(); ++number) {
    const std::size_t i = assembly.tensioners()[number].attachment;
    next.attachments[i].machine.drive = moves[number].drive;
    predict_travel(scheme, *assembly.system().attachments[i].tensioner, now.attachments[i], h, ratio,
                   moves[number].bounds, next.attachments[i]);
  }
}

void correct(const GeneralizedAlpha& scheme, double h, const std::vector<double>& dq, LineState& next) {
  kernels().correct({scheme.velocity_share(h), scheme.acceleration_share(h)}, dq.data(), view(next));
}

void end_accelerations(const GeneralizedAlpha& scheme, const SystemState& now, SystemState& next) {
  const double ratio = step_ratio(now, next.last_step);
  const double by_alg = 1.0 / (1.0 - scheme.alpha_m);
  const double of_next = by_alg * (1.0 - scheme.alpha_f), of_alg = -by_alg * scheme.alpha_m * ratio;
  const double of_acc = by_alg * (scheme.alpha_f - scheme.alpha_m * (1.0 - ratio));
  for (std::size_t line = 0; line < now.lines.size(); ++line) {
    LineState& to = next.lines[line];
    const ChangeSums change = kernels().end({of_next, of_acc, of_alg}, before(now.lines[line]),
                                            static_cast<int>(to.alg.size()), to.acc.data(), to.alg.data());
    const double square = ratio * change.square;
    to.foresight = std::clamp(square > 0.0 ? change.product / square : 0.0, 0.0, scheme.whole_foresight);
  }
  for (std::size_t i = 0; i < now.bodies.size(); ++i) {
    next.bodies[i].alg = of_next * next.bodies[i].acc + of_acc * now.bodies[i].acc + of_alg * now.bodies[i].alg;
  }
}

}  // namespace overbend
