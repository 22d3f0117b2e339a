#include "mechanics/line_kernel.h"

#include "mechanics/line_kernel_batch.h"
#include "mechanics/line_kernel_loads.h"
#include "mechanics/line_kernel_motion.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// Bending, upper triangle of blocks only (j <= k): the caller mirrors it.
template <bool kTangent>
inline void add_bending(Batch& e, const Lanes& EI) {
  const Lanes inv_h2 = e.inv_h * e.inv_h;
  for (int i = 0; i < kGaussPoints; ++i) {
    const Shape& s = kGaussShape[i];
    const Vec a = e.inv_h * combine_derivative(e, s.c);
    const Vec b = inv_h2 * combine_derivative(e, s.d);
    const Lanes g = dot(a, a), p = dot(b, b), m = dot(a, b);
    const Lanes ig = 1.0 / g, ig2 = ig * ig, ig3 = ig2 * ig;
    const Lanes w = kGaussWeight[i] * EI;  // times h, one h lost to each derivative
    const Vec w_a = w * ((2.0 * m * m * ig3 - p * ig2) * a - (m * ig2) * b);
    const Vec w_b = (w * e.inv_h) * (ig * b - (m * ig2) * a);
    for (int j = 0; j < 4; ++j) {
      add_force(e, j, s.c[j], w_a);
      add_force(e, j, s.d[j], w_b);
    }
    if constexpr (kTangent) {
      const Lanes wa = w * e.inv_h, wb = wa * inv_h2, wm = wa * e.inv_h;
      const Lanes mm = m * m;
      const Sym aa = dyads(wa * (2.0 * mm * ig3 - p * ig2), wa * (4.0 * p * ig3 - 12.0 * mm * ig3 * ig), a, -wa * ig2,
                           b, wa * 4.0 * m * ig3);
      const Sym bb = dyads(wb * ig, -wb * ig2, a, Lanes{}, b, Lanes{});
      // W_ba = -2 b a'/g2 - a b'/g2 - m I/g2 + 4 m a a'/g3
      const Vec u = (4.0 * m * ig3) * a - (2.0 * ig2) * b;
      const Vec v = -1.0 * (ig2 * a);
      const Lanes diagonal = -m * ig2;
      const Lanes ac[3] = {a.x, a.y, a.z}, bc[3] = {b.x, b.y, b.z}, uc[3] = {u.x, u.y, u.z}, vc[3] = {v.x, v.y, v.z};
      Mat ba;
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          ba.m[r][c] = wm * (uc[r] * ac[c] + vc[r] * bc[c] + (r == c ? diagonal : Lanes{}));
        }
      }
      const Mat maa = full(aa), mbb = full(bb);
      for (int k = 0; k < 4; ++k) {
        Mat x, y;
        for (int r = 0; r < 3; ++r) {
          for (int c = 0; c < 3; ++c) {
            x.m[r][c] = s.c[k] * maa.m[r][c] + s.d[k] * ba.m[c][r];
            y.m[r][c] = s.c[k] * ba.m[r][c] + s.d[k] * mbb.m[r][c];
          }
        }
        for (int j = 0; j <= k; ++j) {
          add_block(e, j, k, s.c[j], x);
          add_block(e, j, k, s.d[j], y);
        }
      }
    }
  }
}

struct PressureTension {
  Lanes constant, slope, external;
};

/// Height of water over z: that of the hydrostatic pressure with the head of the dynamic one.
inline Lanes water_over(const Lanes& z, const Lanes& head) {
  const Lanes depth = head - z;
  return depth > 0.0 ? depth : Lanes{};
}

/// Membrane with the effective tension of pressure, which varies with depth: the tangent is unsymmetric. `head` of the
/// dynamic pressure at both ends.
template <bool kTangent>
inline void add_membrane(Batch& e, const Lanes& EA, const PressureTension& pressure, const Lanes (&head)[2]) {
  Lanes strain[3], tension_p[3], slope_p[3], inv_norm[3];
  Vec u[3];
  for (int k = 0; k < 3; ++k) {
    const Vec a = e.inv_h * combine_derivative(e, kStrainShape[k].c);
    const Lanes norm = root(dot(a, a));
    inv_norm[k] = 1.0 / norm;
    u[k] = inv_norm[k] * a;
    strain[k] = norm - 1.0;
    const Lanes z = combine(e, kStrainShape[k].n).z;
    const Lanes depth = water_over(z, mixed(head, 0.5 * k));
    tension_p[k] = pressure.constant + pressure.slope * z + pressure.external * depth;
    slope_p[k] = pressure.slope - (depth > 0.0 ? pressure.external : Lanes{});
  }
  Lanes force[3];
  for (int k = 0; k < 3; ++k) {
    force[k] = Lanes{};
    for (int l = 0; l < 3; ++l) {
      force[k] += kStrainMass[k][l] * (EA * strain[l] + tension_p[l]);
    }
    const Vec v = force[k] * u[k];  // times h, over h
    for (int j = 0; j < 4; ++j) {
      if (kStrainShape[k].c[j] != 0.0) {
        add_force(e, j, kStrainShape[k].c[j], v);
      }
    }
  }
  if constexpr (kTangent) {
    for (int k = 0; k < 3; ++k) {
      const Lanes geometric = force[k] * inv_norm[k] * e.inv_h;
      const Mat kk = full(dyads(geometric, -geometric, u[k], Lanes{}, u[k], Lanes{}));
      for (int l = 0; l < 3; ++l) {
        const Lanes m = EA * e.inv_h * kStrainMass[k][l];
        const Lanes uk[3] = {u[k].x, u[k].y, u[k].z}, ul[3] = {u[l].x, u[l].y, u[l].z};
        const Lanes p = kStrainMass[k][l] * slope_p[l];
        for (int j = 0; j < 4; ++j) {
          const double cj = kStrainShape[k].c[j];
          if (cj == 0.0) {
            continue;
          }
          for (int i = 0; i < 4; ++i) {
            const double ci = kStrainShape[l].c[i];
            const double ni = kStrainShape[l].n[i];
            for (int r = 0; r < 3; ++r) {
              if (ci != 0.0) {
                for (int c = 0; c < 3; ++c) {
                  e.k[3 * j + r][3 * i + c] += (cj * ci) * (m * uk[r] * ul[c]);
                }
              }
              if (ni != 0.0) {
                e.k[3 * j + r][3 * i + 2] += (cj * ni) * (p * uk[r]);
              }
            }
            if (k == l && ci != 0.0) {
              add_block(e, j, i, cj * ci, kk);
            }
          }
        }
      }
    }
  }
}

/// Mirrors the symmetric bending part below the diagonal of blocks.
inline void mirror(Batch& e) {
  for (int j = 0; j < 4; ++j) {
    for (int k = j + 1; k < 4; ++k) {
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          e.k[3 * k + c][3 * j + r] = e.k[3 * j + r][3 * k + c];
        }
      }
    }
  }
}

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

/// Unknown i of the elements' forces where cuts at their upper nodes, and at the line's first node, need it.
inline void write_cuts(double* cuts, const Lanes& f, int first, int i, int used) {
  if (i >= 6) {
    for (int l = 0; l < used; ++l) {
      cuts[6 * (first + l) + i] = f[l];
    }
  } else if (first == 0) {
    cuts[i] = -f[0];
  }
}

inline void scatter_force(Batch& e, const LineTarget& target, int first, int used) {
  for (int i = 0; i < kDofs; ++i) {
    const Lanes f = is_tangent_dof(i) ? e.h * e.f[i] : e.f[i];
    for (int l = 0; l < used; ++l) {
      target.residual[6 * (first + l) + i] += f[l];
    }
    if (target.cuts != nullptr) {
      write_cuts(target.cuts, f, first, i, used);
    }
  }
}

/// Adds half a row of the tangent, six columns from `first_column`, to a row of eight of every element's block.
/// `rows` is that of the first element; blocks follow one another.
inline void scatter_row(const Batch& e, int row, int first_column, double* rows, int used) {
  constexpr int kBlock = 48;
  for (int part = 0; part < 6; part += kWidth) {
    Lanes columns[kWidth];
    for (int j = 0; j < kWidth; ++j) {
      columns[j] = part + j < 6 ? e.k[row][first_column + part + j] : Lanes{};
    }
    transpose(columns);
    for (int l = 0; l < used; ++l) {
      *reinterpret_cast<Lanes*>(rows + kBlock * l + part) += columns[l];
    }
  }
}

inline void scatter_tangent(Batch& e, const LineTarget& target, int first, int used) {
  for (int i = 0; i < kDofs; ++i) {
    for (int j = 0; j < kDofs; ++j) {
      e.k[i][j] = is_tangent_dof(i) ? e.h * e.k[i][j] : e.k[i][j];
      e.k[i][j] = is_tangent_dof(j) ? e.h * e.k[i][j] : e.k[i][j];
    }
  }
  for (int i = 0; i < 6; ++i) {
    scatter_row(e, i, 0, target.diag + 48 * first + 8 * i, used);
    scatter_row(e, i, 6, target.upper + 48 * first + 8 * i, used);
    scatter_row(e, 6 + i, 0, target.lower + 48 * first + 8 * i, used);
    scatter_row(e, 6 + i, 6, target.diag + 48 * (first + 1) + 8 * i, used);
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

/// `motion` is null in statics.
template <bool kTangent, bool kMoving>
void add_batch(const LineView& line, const LineEnvironment& env, const LineShape& shape, const LineMotion* motion,
               const LineTarget& target, int first) {
  Batch e;
  gather(e, line, shape, first);
  if constexpr (kTangent) {
    for (auto& row : e.k) {
      for (Lanes& k : row) {
        k = Lanes{};
      }
    }
  }
  add_bending<kTangent>(e, load_lanes(line.EI + first));
  if constexpr (kTangent) {
    mirror(e);
  }
  BatchMotion m;
  if constexpr (kMoving) {
    gather_motion(m, e.h, *motion, first, line.count);
  }
  add_membrane<kTangent>(e, load_lanes(line.EA + first), pressure_tension(line, first), m.head);
  if constexpr (kMoving) {
    add_moving_loads<kTangent>(e, env, *motion, m, load_constants(line, first), inertia_constants(line, first), first,
                               padded_count(line));
  } else {
    add_loads<kTangent>(e, env, load_constants(line, first));
  }
  const int used = line.count - first < kWidth ? line.count - first : kWidth;
  scatter_force(e, target, first, used);
  if constexpr (kTangent) {
    scatter_tangent(e, target, first, used);
  }
}

template <bool kMoving>
void add_batches(const LineView& line, const LineEnvironment& env, const LineShape& shape, const LineMotion* motion,
                 const LineTarget& target) {
  for (int first = 0; first < line.count; first += kWidth) {
    if (target.diag != nullptr) {
      add_batch<true, kMoving>(line, env, shape, motion, target, first);
    } else {
      add_batch<false, kMoving>(line, env, shape, motion, target, first);
    }
  }
}

/// Membrane energy, and the power of pressure on the changing length, which counts as the water's.
inline void add_membrane_energy(LineEnergy& sum, const Batch& e, const BatchMotion& m, const Lanes& EA,
                                const PressureTension& pressure, int used) {
  Lanes strain[3], rate[3], tension_p[3];
  for (int k = 0; k < 3; ++k) {
    const Vec a = e.inv_h * combine_derivative(e, kStrainShape[k].c);
    const Lanes norm = root(dot(a, a));
    strain[k] = norm - 1.0;
    rate[k] = dot(a, e.inv_h * combine_nodes(m.v, kStrainShape[k].c)) / norm;
    const Lanes z = combine(e, kStrainShape[k].n).z;
    tension_p[k] = pressure.constant + pressure.slope * z + pressure.external * water_over(z, mixed(m.head, 0.5 * k));
  }
  for (int k = 0; k < 3; ++k) {
    for (int l = 0; l < 3; ++l) {
      const Lanes w = kStrainMass[k][l] * e.h;
      sum.strain += sum_of(0.5 * w * EA * strain[k] * strain[l], used);
      sum.fluid_power -= sum_of(w * tension_p[k] * rate[l], used);
    }
  }
}

}  // namespace

void add_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target) {
  add_batches<false>(line, env, shape, nullptr, target);
}

void add_moving_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                            const LineMotion& motion, const LineTarget& target) {
  add_batches<true>(line, env, shape, &motion, target);
}

LineEnergy line_energy(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                       const LineMotion& motion) {
  LineEnergy sum;
  for (int first = 0; first < line.count; first += kWidth) {
    Batch e;
    BatchMotion m;
    gather(e, line, shape, first);
    gather_motion(m, e.h, motion, first, line.count);
    const int used = line.count - first < kWidth ? line.count - first : kWidth;
    add_membrane_energy(sum, e, m, load_lanes(line.EA + first), pressure_tension(line, first), used);
    add_energy(sum, e, env, motion, m, load_constants(line, first), inertia_constants(line, first),
               load_lanes(line.EI + first), first, padded_count(line), used);
  }
  return sum;
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
