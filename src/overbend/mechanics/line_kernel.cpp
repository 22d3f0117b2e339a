#include "mechanics/line_kernel.h"

#include "mechanics/line_kernel_energy.h"
#include "mechanics/line_kernel_tangent.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

inline void gather(Batch& e, const LineView& line, const LineShape& shape, int first) {
  e.h = load_lanes(line.length + first);
  e.inv_h = 1.0 / e.h;
  gather_nodes(e.q, shape.q, first, line.count);
  e.chord = e.q[2] - e.q[0];
  if (shape.low != nullptr) {
    for (int l = 0; l < kWidth; ++l) {
      const double* low = shape.low + 6 * (first + l < line.count ? first + l : line.count - 1);
      e.chord.x[l] += low[6] - low[0];
      e.chord.y[l] += low[7] - low[1];
      e.chord.z[l] += low[8] - low[2];
    }
  }
  e.q[1] = e.h * e.q[1];
  e.q[3] = e.h * e.q[3];
  for (Lanes& f : e.f) {
    f = Lanes{};
  }
}

inline bool is_tangent_dof(int dof) {
  return dof / 3 % 2 == 1;
}

/// Forces of elements that do not fill a batch.
inline void scatter_forces_singly(const Lanes (&f)[kDofs], const LineTarget& target, int first, int used) {
  for (int l = 0; l < used; ++l) {
    for (int i = 0; i < kDofs; ++i) {
      target.residual[kNodeDofs * (first + l) + i] += f[i][l];
    }
    for (int i = kNodeDofs; i < (target.cuts != nullptr ? kDofs : 0); ++i) {
      target.cuts[kNodeDofs * (first + l) + i] = f[i][l];
    }
  }
}

/// Forces of a whole batch: what both elements at a node add to it, six numbers of every node side by side.
inline void scatter_forces(const Lanes (&f)[kDofs], const LineTarget& target, int first) {
  alignas(64) double packed[kNodeDofs * kWidth + 2];
  Lanes at_node[kNodeDofs], upper[kNodeDofs];
  for (int i = 0; i < kNodeDofs; ++i) {
    upper[i] = f[kNodeDofs + i];
    at_node[i] = f[i] + from_last(upper[i], Lanes{});
  }
  pack_rows(packed, at_node);
  double* residual = target.residual + kNodeDofs * first;
  for (int i = 0; i < kNodeDofs; ++i) {
    *reinterpret_cast<LooseLanes*>(residual + kWidth * i) += load_lanes(packed + kWidth * i);
    residual[kNodeDofs * kWidth + i] += upper[i][kWidth - 1];
  }
  if (target.cuts != nullptr) {
    pack_rows(packed, upper);
    for (int i = 0; i < kNodeDofs; ++i) {
      *reinterpret_cast<LooseLanes*>(target.cuts + kNodeDofs * (first + 1) + kWidth * i) =
          load_lanes(packed + kWidth * i);
    }
  }
}

inline void scatter_force(Batch& e, const LineTarget& target, int first, int used) {
  for (int i = 0; i < kDofs; ++i) {
    e.f[i] = is_tangent_dof(i) ? e.h * e.f[i] : e.f[i];
  }
  if (used == kWidth) {
    scatter_forces(e.f, target, first);
  } else {
    scatter_forces_singly(e.f, target, first, used);
  }
  for (int i = 0; i < (target.cuts != nullptr && first == 0 ? kNodeDofs : 0); ++i) {
    target.cuts[i] = -e.f[i][0];
  }
}

inline LoadConstants load_constants(const LineView& line, int first) {
  return {load_lanes(line.weight + first), load_lanes(line.buoyancy + first), load_lanes(line.radius + first),
          load_lanes(line.drag_normal + first), load_lanes(line.drag_axial + first)};
}

inline InertiaConstants inertia_constants(const LineView& line, int first) {
  return {load_lanes(line.mass + first), load_lanes(line.displaced_mass + first), load_lanes(line.added_normal + first),
          load_lanes(line.added_axial + first)};
}

inline PressureTension pressure_tension(const LineView& line, int first) {
  return {load_lanes(line.pressure_constant + first), load_lanes(line.pressure_slope + first),
          load_lanes(line.pressure_external + first)};
}

inline int padded_count(const LineView& line) {
  return (line.count + kLanes - 1) / kLanes * kLanes;
}

/// Of a line at rest or, with kMoving, in motion, one pass over the Gauss points for all forces. `motion` is null in
/// statics, `upper` without a tangent.
template <bool kTangent, bool kMoving>
void add_batch(const LineView& line, const LineEnvironment& env, const LineShape& shape, const LineMotion* motion,
               const LineTarget& target, UpperBlocks* upper, int first) {
  Batch e;
  BatchTangent memory;
  BatchTangent* tangent = kTangent ? &memory : nullptr;
  gather(e, line, shape, first);
  const Lanes EA = load_lanes(line.EA + first), EI = load_lanes(line.EI + first);
  BatchMotion m;
  if constexpr (kMoving) {
    gather_motion(m, e.h, *motion, first, line.count);
    add_membrane<kTangent>(e, tangent, EA, pressure_tension(line, first), m.head);
  } else {
    add_membrane<kTangent>(e, tangent, EA, pressure_tension(line, first), {});
  }
  const LoadConstants loads = load_constants(line, first);
  const InertiaConstants inertia = kMoving ? inertia_constants(line, first) : InertiaConstants{};
  for (int i = 0; i < kGaussPoints; ++i) {
    const Shape& s = kGaussShape[i];
    const PointSlope slope = slope_at(e, s);
    add_bending<kTangent>(e, tangent, s, kGaussWeight[i], EI, slope);
    if constexpr (kMoving) {
      const MovingPoint at = moving_point(e, m, s, kGaussXi[i]);
      add_point_load(e, tangent, i,
                     moving_load<kTangent>(env, *motion, at, slope, loads, inertia, i, first, padded_count(line)));
    } else {
      add_point_load(e, tangent, i, resting_load<kTangent>(env, loads, combine(e, s.n), slope));
    }
  }
  const int used = line.count - first < kWidth ? line.count - first : kWidth;
  scatter_force(e, target, first, used);
  if constexpr (kTangent) {
    join(*tangent, {all(1.0), e.h, all(1.0), e.h});
    put_tangent(*tangent, target, *upper, first, used);
  }
}

template <bool kTangent, bool kMoving>
void add_batches(const LineView& line, const LineEnvironment& env, const LineShape& shape, const LineMotion* motion,
                 const LineTarget& target) {
  UpperBlocks upper;
  for (int first = 0; first < line.count; first += kWidth) {
    add_batch<kTangent, kMoving>(line, env, shape, motion, target, &upper, first);
  }
  if constexpr (kTangent) {
    put_last_block(upper, target, line.count, (line.count - 1) % kWidth);
  }
}

template <bool kMoving>
void add_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape, const LineMotion* motion,
                const LineTarget& target) {
  if (target.diag != nullptr) {
    add_batches<true, kMoving>(line, env, shape, motion, target);
  } else {
    add_batches<false, kMoving>(line, env, shape, motion, target);
  }
}

}  // namespace

void add_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target) {
  add_forces<false>(line, env, shape, nullptr, target);
}

void add_moving_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                            const LineMotion& motion, const LineTarget& target) {
  add_forces<true>(line, env, shape, &motion, target);
}

LineEnergy line_energy(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                       const LineMotion& motion) {
  EnergyLanes sum;
  for (int first = 0; first < line.count; first += kWidth) {
    Batch e;
    BatchMotion m;
    gather(e, line, shape, first);
    gather_motion(m, e.h, motion, first, line.count);
    Lanes counts = e.h;
    for (int l = line.count - first; l < kWidth; ++l) {
      counts[l] = 0.0;
    }
    add_membrane_energy(sum, e, m, load_lanes(line.EA + first), pressure_tension(line, first), counts);
    add_energy(sum, e, env, motion, m, load_constants(line, first), inertia_constants(line, first),
               load_lanes(line.EI + first), counts, first, padded_count(line));
  }
  return {sum_of(sum.kinetic), sum_of(sum.strain),      sum_of(sum.gravity),
          sum_of(sum.seabed),  sum_of(sum.fluid_power), sum_of(sum.seabed_loss)};
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
