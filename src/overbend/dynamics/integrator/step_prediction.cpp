#include "dynamics/integrator/step_prediction.h"

#include <algorithm>

#include "base/simd.h"
#include "dynamics/integrator/motion_kernel.h"

namespace overbend {
namespace {

struct MotionKernels {
  void (*predict)(const PredictionCoefficients&, const FreedomsAtStart&, const FreedomsView&);
  void (*correct)(const CorrectionCoefficients&, const double*, const FreedomsView&);
  ChangeSums (*end)(const AccelerationCoefficients&, const FreedomsAtStart&, int, const double*, double*);
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

FreedomsAtStart before(const LineState& start) {
  return {start.q.data(), start.v.data(), start.acc.data(), start.algorithmic_acceleration.data()};
}
FreedomsView view(LineState& next) {
  return {static_cast<int>(next.q.size()), next.q.data(), next.v.data(), next.acc.data()};
}

/// Ratio of a step of `h` to the step that led to the state.
double step_ratio(const SystemState& start, double h) {
  return start.last_step > 0.0 ? h / start.last_step : 1.0;
}

/// Rescales the difference between the algorithmic and the true acceleration, which is proportional to the step, by the
/// ratio `ratio` of the steps.
MotionValues corrected_for_step(MotionValues guide, double ratio) {
  guide.algorithmic_acceleration = guide.acc + ratio * (guide.algorithmic_acceleration - guide.acc);
  return guide;
}

/// Predicts the motion after a step of `h` with a fraction `acceleration_extrapolation` of the difference between the
/// accelerations. No extrapolation after a change of step length, which mostly comes from impacts.
MotionValues extrapolated(const GeneralizedAlpha& scheme, MotionValues start, double h, double ratio,
                          double acceleration_extrapolation) {
  start = corrected_for_step(start, ratio);
  return advance(scheme, start, h,
                 ratio == 1.0 ? GeneralizedAlpha::extrapolated(start.acc, start.algorithmic_acceleration,
                                                               acceleration_extrapolation)
                              : start.acc);
}

MotionValues extrapolated(const GeneralizedAlpha& scheme, const MotionValues& start, double h, double ratio) {
  return extrapolated(scheme, start, h, ratio, scheme.half_extrapolation);
}

/// The same for many unknowns: linear in both accelerations.
struct AccelerationExtrapolation {
  AccelerationExtrapolation(const GeneralizedAlpha& scheme, double step, double ratio,
                            double acceleration_extrapolation)
      : h(step),
        of_acc(extrapolated(scheme, {0.0, 0.0, 1.0, 0.0}, step, ratio, acceleration_extrapolation)),
        by_algorithmic(extrapolated(scheme, {0.0, 0.0, 0.0, 1.0}, step, ratio, acceleration_extrapolation)) {}
  void predict(const LineState& start, LineState& next) const {
    kernels().predict({h, of_acc.q, by_algorithmic.q, of_acc.v, by_algorithmic.v, of_acc.acc, by_algorithmic.acc},
                      before(start), view(next));
  }
  void predict(const HullState& start, HullState& next) const {
    next.h = start.h + h * start.v + of_acc.q * start.acc + by_algorithmic.q * start.algorithmic_acceleration;
    next.v = start.v + of_acc.v * start.acc + by_algorithmic.v * start.algorithmic_acceleration;
    next.acc = of_acc.acc * start.acc + by_algorithmic.acc * start.algorithmic_acceleration;
  }
  double h;
  MotionValues of_acc, by_algorithmic;
};

bool have_equal_sizes(const LineState& a, const LineState& b) {
  return a.q.size() == b.q.size() && a.bed_slip.size() == b.bed_slip.size() && a.contacts.size() == b.contacts.size() &&
         a.bending.size() == b.bending.size();
}

/// Copies the parts of the state that are not predicted, without allocation if the sizes agree.
/// LineAssembly::evaluate() updates the plastic memories where they are used.
void copy_unpredicted(const SystemState& start, SystemState& next) {
  if (!std::equal(start.lines.begin(), start.lines.end(), next.lines.begin(), next.lines.end(), have_equal_sizes)) {
    next = start;
    return;
  }
  for (std::size_t i = 0; i < start.lines.size(); ++i) {
    const LineState& from = start.lines[i];
    LineState& to = next.lines[i];
    to.bed_slip = from.bed_slip;
    to.contacts = from.contacts;
    to.bending_heat = from.bending_heat;
  }
  next.attachments = start.attachments;
  next.bodies = start.bodies;
}

void predict_travel(const GeneralizedAlpha& scheme, const TensionerLaw& law, const AttachmentState& start, double h,
                    double ratio, const SpeedBounds& bounds, AttachmentState& next) {
  const Travel from{start.travel.q, start.travel.v, start.travel.acc};
  const auto drive_to = [&](double speed) {
    const Travel to =
        start.machine.commanded ? advance_commanded(law, from, speed, h) : advance_governed(law, from, speed, h);
    next.travel = {to.length, to.speed, to.acceleration, to.acceleration};
  };
  switch (next.machine.drive) {
    case TensionerDrive::brake:
      next.travel = {start.travel.q, 0.0, 0.0, 0.0};
      return;
    case TensionerDrive::governor:
      next.travel = extrapolated(scheme, start.travel, h, ratio);
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

void predict(const GeneralizedAlpha& scheme, const Assembly& assembly, const SystemState& start, double h,
             const std::vector<MachineStep>& moves, SystemState& next) {
  copy_unpredicted(start, next);
  next.time = start.time + h;
  next.last_step = h;
  const double ratio = step_ratio(start, h);
  for (std::size_t i = 0; i < start.lines.size(); ++i) {
    AccelerationExtrapolation(scheme, h, ratio, start.lines[i].acceleration_extrapolation)
        .predict(start.lines[i], next.lines[i]);
  }
  const AccelerationExtrapolation half(scheme, h, ratio, scheme.half_extrapolation);
  for (std::size_t i = 0; i < start.bodies.size(); ++i) {
    half.predict(start.bodies[i], next.bodies[i]);
  }
  for (std::size_t i = 0; i < start.attachments.size(); ++i) {
    next.attachments[i].guide = extrapolated(scheme, start.attachments[i].guide, h, ratio);
  }
  for (std::size_t number = 0; number < moves.size(); ++number) {
    const std::size_t i = assembly.tensioners()[number].attachment;
    next.attachments[i].machine.drive = moves[number].drive;
    predict_travel(scheme, *assembly.system().attachments[i].tensioner, start.attachments[i], h, ratio,
                   moves[number].bounds, next.attachments[i]);
  }
}

void correct(const GeneralizedAlpha& scheme, double h, const std::vector<double>& dq, LineState& next) {
  kernels().correct({scheme.velocity_share(h), scheme.acceleration_share(h)}, dq.data(), view(next));
}

void end_accelerations(const GeneralizedAlpha& scheme, const SystemState& start, SystemState& next) {
  const double ratio = step_ratio(start, next.last_step);
  const double by_alg = 1.0 / (1.0 - scheme.alpha_m);
  const double of_next = by_alg * (1.0 - scheme.alpha_f), by_algorithmic = -by_alg * scheme.alpha_m * ratio;
  const double of_acc = by_alg * (scheme.alpha_f - scheme.alpha_m * (1.0 - ratio));
  for (std::size_t line = 0; line < start.lines.size(); ++line) {
    LineState& to = next.lines[line];
    const ChangeSums change = kernels().end({of_next, of_acc, by_algorithmic}, before(start.lines[line]),
                                            static_cast<int>(to.algorithmic_acceleration.size()), to.acc.data(),
                                            to.algorithmic_acceleration.data());
    const double square = ratio * change.square;
    to.acceleration_extrapolation =
        std::clamp(square > 0.0 ? change.product / square : 0.0, 0.0, scheme.full_extrapolation);
  }
  for (std::size_t i = 0; i < start.bodies.size(); ++i) {
    next.bodies[i].algorithmic_acceleration = of_next * next.bodies[i].acc + of_acc * start.bodies[i].acc +
                                              by_algorithmic * start.bodies[i].algorithmic_acceleration;
  }
}

}  // namespace overbend
