#include "mechanics/line_kernel.h"

#include "mechanics/line_kernel_motion.h"
#include "mechanics/line_kernel_tangent.h"
#include "mechanics/line_kernel_yielding.h"

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
  find_cubic(e);
  clear_forces(e);
}

/// Contributions of the elements of a batch to their upper nodes: the next batch adds the contributions of its lower
/// nodes to the last one.
struct UpperForces {
  Lanes f[kNodeDofs] = {};
};

/// Stores the forces of elements that do not fill a batch.
inline void put_forces_singly(const Lanes (&at_node)[kNodeDofs], const Lanes (&upper)[kNodeDofs],
                              const LineTarget& target, int first, int used) {
  for (int l = 0; l < used; ++l) {
    for (int i = 0; i < kNodeDofs; ++i) {
      target.residual[kNodeDofs * (first + l) + i] = at_node[i][l];
      if (target.cuts != nullptr) {
        target.cuts[kNodeDofs * (first + l + 1) + i] = upper[i][l];
      }
    }
  }
}

/// Writes the sum of both elements at each node, except at the node after the last element, which is left in `before`.
inline void put_forces(const Batch& e, const LineTarget& target, UpperForces& before, int first, int used) {
  Lanes lower[kNodeDofs], upper[kNodeDofs], at_node[kNodeDofs];
  nodal_forces(e, lower, upper);
  for (int i = 0; i < kNodeDofs; ++i) {
    at_node[i] = lower[i] + from_last(upper[i], before.f[i]);
    before.f[i] = upper[i];
  }
  if (used == kWidth) {
    store_rows(target.residual + kNodeDofs * first, at_node);
    if (target.cuts != nullptr) {
      store_rows(target.cuts + kNodeDofs * (first + 1), upper);
    }
  } else {
    put_forces_singly(at_node, upper, target, first, used);
  }
  for (int i = 0; i < (target.cuts != nullptr && first == 0 ? kNodeDofs : 0); ++i) {
    target.cuts[i] = -lower[i][0];
  }
}

/// Writes the force at the line's last node, above the element in lane `last`.
inline void put_last_forces(const UpperForces& upper, const LineTarget& target, int node, int last) {
  for (int i = 0; i < kNodeDofs; ++i) {
    target.residual[kNodeDofs * node + i] = upper.f[i][last];
  }
}

inline LoadConstants load_constants(const LineView& line, int first) {
  return {load_lanes(line.weight + first),     load_lanes(line.buoyancy + first),
          load_lanes(line.radius + first),     load_lanes(line.drag_normal + first),
          load_lanes(line.drag_axial + first), load_lanes(line.drag_on_bed + first)};
}

inline InertiaConstants inertia_constants(const LineView& line, int first) {
  return {load_lanes(line.mass + first), load_lanes(line.displaced_mass + first), load_lanes(line.added_normal + first),
          load_lanes(line.added_axial + first)};
}

inline PressureTension pressure_tension(const LineView& line, int first) {
  return {load_lanes(line.pressure_constant + first), load_lanes(line.pressure_slope + first),
          load_lanes(line.pressure_external + first)};
}

/// Returns the lengths of a batch's elements, 0 for padding elements.
inline Lanes counted_lengths(const Lanes& h, int used) {
  Lanes counts = h;
  for (int l = used; l < kWidth; ++l) {
    counts[l] = 0.0;
  }
  return counts;
}

inline int padded_count(const LineView& line) {
  return (line.count + kLanes - 1) / kLanes * kLanes;
}

/// Input and output of a batch.
struct LineData {
  const LineView& line;
  const LineEnvironment& env;
  const LineShape& shape;
  const LineMotion* motion;  ///< Null in statics.
  const LineTarget& target;
};

/// Adds the forces of a batch of a line at rest or, with kMoving, in motion, and with kEnergy its energies. `blocks` is
/// null without a tangent.
template <bool kTangent, bool kMoving, bool kEnergy>
void add_batch(const LineData& data, UpperForces& upper, UpperBlocks* blocks, EnergyLanes* sum, int first) {
  const auto& [line, env, shape, motion, target] = data;
  Batch e;
  BatchTangent memory;
  BatchTangent* tangent = kTangent ? &memory : nullptr;
  gather(e, line, shape, first);
  const Lanes EI = load_lanes(line.EI + first);
  const AxialConstants axial{load_lanes(line.EA + first), load_lanes(line.compression + first),
                             load_lanes(line.damping + first), kMoving ? motion->velocity_share : 0.0};
  const int used = line.count - first < kWidth ? line.count - first : kWidth, padded = padded_count(line);
  BatchMotion m;
  if constexpr (kMoving) {
    gather_motion(m, e.h, *motion, first, line.count);
  } else {
    m.head[0] = m.head[1] = Lanes{};
  }
  const EnergySums energy{sum, kEnergy ? counted_lengths(e.h, used) : Lanes{}};
  Membrane membrane = make_membrane(e, pressure_tension(line, first), m.head);
  if constexpr (kMoving) {
    if (kEnergy || axial.slack()) set_rates(membrane, e, slopes_at_strains(m.v).at);
  } else if (axial.slack()) {
    set_no_rates(membrane);
  }
  add_membrane<kTangent>(e, tangent, axial, membrane);
  if constexpr (kEnergy) {
    add_membrane_energy(energy, axial, membrane);
  }
  const LoadConstants loads = load_constants(line, first);
  const InertiaConstants inertia = kMoving ? inertia_constants(line, first) : InertiaConstants{};
  PointSlope slopes[kGaussPoints];
  for (int i = 0; i < kGaussPoints; ++i) {  // a loop of its own: the latencies of square roots and divisions overlap
    slopes[i] = slope_at(e, kGauss[i]);
  }
#pragma GCC unroll 1
  for (int i = 0; i < kGaussPoints; ++i) {
    const Lanes twice_energy = add_bending<kTangent>(e, tangent, i, EI, slopes[i]);
    if constexpr (kEnergy) {
      sum->strain += 0.5 * energy.counts * twice_energy;
    }
  }
  if constexpr (kMoving) {
    if (motion->held != nullptr) {
      add_held_sections<kTangent>(e, tangent, slopes, *motion->held, counted_lengths(e.h, used), first, padded);
    }
  }
#pragma GCC unroll 1
  for (int i = 0; i < kGaussPoints; ++i) {
    if constexpr (kMoving) {
      add_load(e, tangent, i,
               moving_load<kTangent, kEnergy>(env, *motion, energy, {e, m, kGauss[i]}, slopes[i], loads, inertia, i,
                                              first, padded));
    } else {
      add_load(e, tangent, i, static_load<kTangent>(env, loads, value_at(e.r, kGauss[i]), slopes[i]));
    }
  }
  if (target.residual != nullptr) {
    put_forces(e, target, upper, first, used);
  }
  if constexpr (kTangent) {
    join(*tangent, e.h);
    put_tangent(*tangent, target, *blocks, first, used);
  }
}

template <bool kTangent, bool kMoving, bool kEnergy>
__attribute__((flatten)) void add_batches(const LineData& data) {
  const int count = data.line.count, last = (count - 1) % kWidth;
  UpperForces upper;
  UpperBlocks blocks;
  EnergyLanes sum;
  for (int first = 0; first < count; first += kWidth) {
    add_batch<kTangent, kMoving, kEnergy>(data, upper, kTangent ? &blocks : nullptr, kEnergy ? &sum : nullptr, first);
  }
  if (data.target.residual != nullptr) {
    put_last_forces(upper, data.target, count, last);
  }
  if constexpr (kTangent) {
    put_last_block(blocks, data.target, count, last);
  }
  if constexpr (kEnergy) {
    *data.target.energy = lane_sum(sum);
  }
}

}  // namespace

void add_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target) {
  const LineData data{line, env, shape, nullptr, target};
  target.diag != nullptr ? add_batches<true, false, false>(data) : add_batches<false, false, false>(data);
}

void add_moving_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                            const LineMotion& motion, const LineTarget& target) {
  const LineData data{line, env, shape, &motion, target};
  if (target.diag != nullptr) {
    add_batches<true, true, false>(data);
  } else if (target.energy != nullptr) {
    add_batches<false, true, true>(data);
  } else {
    add_batches<false, true, false>(data);
  }
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
