#include "mechanics/line_kernel.h"

#include "base/simd.h"
#include "mechanics/quadrature.h"

/// Inside, the unknowns t are scaled by the element length, so that the Hermite functions are the same numbers for all
/// eight elements of a batch; force and tangent are scaled back at the end.
namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

constexpr int kDofs = 12;
constexpr double kPi = 3.14159265358979323846;

struct Vec {
  Lanes x, y, z;
};

struct Sym {  ///< Symmetric 3x3.
  Lanes xx, xy, xz, yy, yz, zz;
};

struct Mat {
  Lanes m[3][3];
};

inline Lanes all(double value) {
  return Lanes{} + value;
}
inline Vec operator+(const Vec& a, const Vec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(const Vec& a, const Vec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator*(const Lanes& s, const Vec& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Vec operator*(double s, const Vec& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline Lanes dot(const Vec& a, const Vec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Lanes root(const Lanes& a) {
  Lanes r;
  for (int l = 0; l < kWidth; ++l) {
    r[l] = __builtin_sqrt(a[l]);
  }
  return r;
}

/// Hermite functions of (r1, h t1, r2, h t2) at xi: values, first derivatives times h, second times h^2.
struct Shape {
  double n[4], c[4], d[4];
};

constexpr Shape shape_at(double x) {
  return {{1 - 3 * x * x + 2 * x * x * x, x - 2 * x * x + x * x * x, 3 * x * x - 2 * x * x * x, x * x * x - x * x},
          {-6 * x + 6 * x * x, 1 - 4 * x + 3 * x * x, 6 * x - 6 * x * x, 3 * x * x - 2 * x},
          {-6 + 12 * x, -4 + 6 * x, 6 - 12 * x, 6 * x - 2}};
}

constexpr Shape kGaussShape[kGaussPoints] = {shape_at(kGaussXi[0]), shape_at(kGaussXi[1]), shape_at(kGaussXi[2]),
                                             shape_at(kGaussXi[3])};
constexpr Shape kStrainShape[3] = {shape_at(0.0), shape_at(0.5), shape_at(1.0)};

/// As many elements as a register holds: unknowns, constants, force and tangent.
struct Batch {
  Vec q[4];   ///< r1, h t1, r2, h t2.
  Vec chord;  ///< r2 - r1: derivatives need no more, and the difference keeps digits that positions of hundreds of
              ///< metres lose.
  Lanes h, inv_h;
  Lanes f[kDofs];
  Lanes k[kDofs][kDofs];
};

inline Vec combine(const Batch& e, const double (&s)[4]) {
  return s[0] * e.q[0] + s[1] * e.q[1] + s[2] * e.q[2] + s[3] * e.q[3];
}

/// A derivative of the centreline: the functions of r1 and r2 are opposite.
inline Vec combine_derivative(const Batch& e, const double (&s)[4]) {
  return s[1] * e.q[1] + s[2] * e.chord + s[3] * e.q[3];
}

inline void add_force(Batch& e, int j, double s, const Vec& v) {
  e.f[3 * j] += s * v.x;
  e.f[3 * j + 1] += s * v.y;
  e.f[3 * j + 2] += s * v.z;
}

inline void add_block(Batch& e, int j, int k, double s, const Mat& a) {
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      e.k[3 * j + r][3 * k + c] += s * a.m[r][c];
    }
  }
}

inline Mat full(const Sym& s) {
  return {{{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}}};
}

/// alpha I + beta a a' + gamma b b' + delta (a b' + b a')
inline Sym dyads(const Lanes& alpha, const Lanes& beta, const Vec& a, const Lanes& gamma, const Vec& b,
                 const Lanes& delta) {
  const Vec u = beta * a + delta * b;
  const Vec v = gamma * b + delta * a;
  return {alpha + u.x * a.x + v.x * b.x, u.x * a.y + v.x * b.y, u.x * a.z + v.x * b.z,
          alpha + u.y * a.y + v.y * b.y, u.y * a.z + v.y * b.z, alpha + u.z * a.z + v.z * b.z};
}

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

/// Membrane with the effective tension of pressure. `lower` receives the unsymmetric part (tension varies with depth).
template <bool kTangent>
inline void add_membrane(Batch& e, const Lanes& EA, const PressureTension& pressure) {
  Lanes strain[3], tension_p[3], slope_p[3], inv_norm[3];
  Vec u[3];
  for (int k = 0; k < 3; ++k) {
    const Vec a = e.inv_h * combine_derivative(e, kStrainShape[k].c);
    const Lanes norm = root(dot(a, a));
    inv_norm[k] = 1.0 / norm;
    u[k] = inv_norm[k] * a;
    strain[k] = norm - 1.0;
    const Lanes z = combine(e, kStrainShape[k].n).z;
    const Lanes depth = z < 0.0 ? -z : Lanes{};
    tension_p[k] = pressure.constant + pressure.slope * z + pressure.external * depth;
    slope_p[k] = pressure.slope - (z < 0.0 ? pressure.external : Lanes{});
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

struct Wetting {
  Lanes share, slope;
};

inline Wetting wetting(const Lanes& z, const Lanes& radius) {
  Wetting wet;
  for (int l = 0; l < kWidth; ++l) {  // almost every point is wholly under or wholly above the water
    const double c = z[l] / radius[l];
    if (c <= -1.0 || c >= 1.0) {
      wet.share[l] = c < 0.0 ? 1.0 : 0.0;
      wet.slope[l] = 0.0;
    } else {
      const double half_chord = __builtin_sqrt(1.0 - c * c);
      wet.share[l] = (__builtin_acos(c) - c * half_chord) / kPi;
      wet.slope[l] = -2.0 * half_chord / (kPi * radius[l]);
    }
  }
  return wet;
}

struct Current {
  Vec velocity, slope;  ///< Slope: derivative in z.
};

inline Current current_at(const LineEnvironment& env, const Lanes& z) {
  Current now{};
  const int last = env.current_rows - 1;
  for (int l = 0; l < kWidth; ++l) {
    if (z[l] <= env.current_z[0] || last == 0) {
      now.velocity.x[l] = env.current_vx[0];
      now.velocity.y[l] = env.current_vy[0];
    } else if (z[l] >= env.current_z[last]) {
      now.velocity.x[l] = env.current_vx[last];
      now.velocity.y[l] = env.current_vy[last];
    } else {
      int i = 0;
      while (i + 2 < env.current_rows && z[l] > env.current_z[i + 1]) {
        ++i;
      }
      const double dz = env.current_z[i + 1] - env.current_z[i];
      const double sx = (env.current_vx[i + 1] - env.current_vx[i]) / dz;
      const double sy = (env.current_vy[i + 1] - env.current_vy[i]) / dz;
      now.velocity.x[l] = env.current_vx[i] + sx * (z[l] - env.current_z[i]);
      now.velocity.y[l] = env.current_vy[i] + sy * (z[l] - env.current_z[i]);
      now.slope.x[l] = sx;
      now.slope.y[l] = sy;
    }
  }
  now.velocity = env.current_scale * now.velocity;
  now.slope = env.current_scale * now.slope;
  return now;
}

/// Force per length at a point and its derivatives in position and tangent.
struct PointLoad {
  Vec f;
  Mat in_r, in_a;
};

inline void add_outer(Mat& m, const Lanes& s, const Vec& a, const Vec& b) {
  const Lanes ac[3] = {a.x, a.y, a.z}, bc[3] = {b.x, b.y, b.z};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      m.m[r][c] += s * ac[r] * bc[c];
    }
  }
}

inline bool any(const Lanes& x) {
  bool found = false;
  for (int l = 0; l < kWidth; ++l) {
    found = found || x[l] > 0.0;
  }
  return found;
}

/// Normal penalty on the pipe's underside and lateral friction against the lay route: elastic stick up to mu times the
/// normal force (statics: the pipe was laid on its route and has been pushed off it once).
inline void add_seabed(PointLoad& load, const LineEnvironment& env, const Vec& r, const Lanes& radius,
                       const Lanes& submerged_weight) {
  const Vec n{all(env.bed_normal[0]), all(env.bed_normal[1]), all(env.bed_normal[2])};
  const Lanes penetration = radius - (dot(n, r) - env.bed_offset);
  if (!any(penetration)) {
    return;
  }
  const Lanes touching = penetration > 0.0 ? all(1.0) : Lanes{};
  const Lanes stiffness = env.bed_stiffness * touching;
  const Lanes normal = stiffness * penetration;
  load.f = load.f + normal * n;
  add_outer(load.in_r, -stiffness, n, n);
  if (env.bed_friction_axial > 0.0 &&
      env.bed_along[2] != 0.0) {  // axial friction keeps the laid pipe from sliding downhill
    const Vec along{all(env.bed_along[0]), all(env.bed_along[1]), all(env.bed_along[2])};
    const double uphill = env.bed_along[2] > 0.0 ? 1.0 : -1.0;
    const Lanes pull = submerged_weight * (uphill * env.bed_along[2]);
    const Lanes limit = env.bed_friction_axial * normal;
    const Lanes sliding = pull > limit ? all(1.0) : Lanes{};
    load.f = load.f + (uphill * (sliding * limit + (touching - sliding * touching) * pull)) * along;
    add_outer(load.in_r, -uphill * env.bed_friction_axial * sliding * stiffness, along, n);
  }
  if (env.bed_friction_lateral > 0.0) {
    const Vec across{all(env.route_normal[0]), all(env.route_normal[1]), all(env.route_normal[2])};
    const Lanes off = dot(across, r) - env.route_offset;
    const Lanes stick = -env.bed_stick * touching * off;
    const Lanes limit = env.bed_friction_lateral * normal;
    const Lanes sign = off > 0.0 ? all(-1.0) : all(1.0);
    const Lanes size = stick > 0.0 ? stick : -stick;
    const Lanes sliding = size > limit ? all(1.0) : Lanes{};
    load.f = load.f + (sliding * sign * limit + (1.0 - sliding) * stick) * across;
    add_outer(load.in_r, -(1.0 - sliding) * env.bed_stick * touching, across, across);
    add_outer(load.in_r, -sliding * sign * env.bed_friction_lateral * stiffness, across, n);
  }
}

/// Drag of a steady current, normal and tangential parts (Morison; DNV-RP-C205), times the wetted share.
inline void add_drag(PointLoad& load, const LineEnvironment& env, const Lanes& z, const Vec& a, const Wetting& wet,
                     const Lanes& drag_normal, const Lanes& drag_axial) {
  if (!any(wet.share)) {
    return;
  }
  const Current now = current_at(env, z);
  const Lanes inv_norm = 1.0 / root(dot(a, a));
  const Vec t = inv_norm * a;
  const Lanes ut = dot(now.velocity, t);
  const Vec un = now.velocity - ut * t;
  const Lanes size = root(dot(un, un)) + 1e-30;  // a pipe along the current has no normal drag, not 0/0
  const Lanes along = ut > 0.0 ? ut : -ut;
  const Vec fn = (drag_normal * size) * un;
  const Vec ft = (drag_axial * along * ut) * t;
  load.f = load.f + wet.share * (fn + ft);

  // d fn / d un = Cn (|un| I + un un'/|un|), d ft / d ut = 2 Ct |ut| t, d ft / d t = Ct |ut| ut I
  const Vec e = (1.0 / size) * un;
  const auto jacobian_n = [&](const Vec& v) { return drag_normal * (size * v + (size * dot(e, v)) * e); };
  const Vec slope_n = now.slope - dot(now.slope, t) * t;
  const Vec in_z = jacobian_n(slope_n) + (2.0 * drag_axial * along * dot(now.slope, t)) * t;
  const Vec z_column = wet.share * in_z + wet.slope * (fn + ft);
  load.in_r.m[0][2] += z_column.x;
  load.in_r.m[1][2] += z_column.y;
  load.in_r.m[2][2] += z_column.z;
  const Vec axes[3] = {{all(1.0), Lanes{}, Lanes{}}, {Lanes{}, all(1.0), Lanes{}}, {Lanes{}, Lanes{}, all(1.0)}};
  const Lanes scale = wet.share * inv_norm;
  for (int c = 0; c < 3; ++c) {
    const Vec dt = axes[c] - dot(axes[c], t) * t;  // times inv_norm: change of t with a_c
    const Lanes dut = dot(now.velocity, dt);
    const Vec dun = (-1.0 * dut) * t - ut * dt;
    const Vec df = jacobian_n(dun) + (2.0 * drag_axial * along * dut) * t + (drag_axial * along * ut) * dt;
    load.in_a.m[0][c] += scale * df.x;
    load.in_a.m[1][c] += scale * df.y;
    load.in_a.m[2][c] += scale * df.z;
  }
}

struct LoadConstants {
  Lanes weight, buoyancy, radius, drag_normal, drag_axial;
};

/// Weight, buoyancy, seabed and current by Gauss points; external forces enter the residual with a minus sign.
template <bool kTangent>
inline void add_loads(Batch& e, const LineEnvironment& env, const LoadConstants& c) {
  for (int i = 0; i < kGaussPoints; ++i) {
    const Shape& s = kGaussShape[i];
    const Vec r = combine(e, s.n);
    const Vec a = e.inv_h * combine_derivative(e, s.c);
    const Wetting wet = wetting(r.z, c.radius);
    PointLoad load{};
    load.f.z = c.buoyancy * wet.share - c.weight;
    load.in_r.m[2][2] = c.buoyancy * wet.slope;
    add_seabed(load, env, r, c.radius, c.weight - c.buoyancy);
    if (env.current_rows > 0) {
      add_drag(load, env, r.z, a, wet, c.drag_normal, c.drag_axial);
    }
    const Lanes w = kGaussWeight[i] * e.h;
    for (int j = 0; j < 4; ++j) {
      add_force(e, j, -s.n[j], w * load.f);
    }
    if constexpr (kTangent) {
      for (int r3 = 0; r3 < 3; ++r3) {
        for (int c3 = 0; c3 < 3; ++c3) {
          const Lanes in_r = w * load.in_r.m[r3][c3];
          const Lanes in_a = w * e.inv_h * load.in_a.m[r3][c3];
          for (int k = 0; k < 4; ++k) {
            const Lanes x = s.n[k] * in_r + s.c[k] * in_a;
            for (int j = 0; j < 4; ++j) {
              e.k[3 * j + r3][3 * k + c3] -= s.n[j] * x;
            }
          }
        }
      }
    }
  }
}

inline Lanes load_lanes(const double* p) {
  return *reinterpret_cast<const Lanes*>(p);
}

inline void gather(Batch& e, const LineView& line, const LineShape& shape, int first) {
  e.h = load_lanes(line.length + first);
  e.inv_h = 1.0 / e.h;
  for (int l = 0; l < kWidth; ++l) {
    const int element = first + l < line.count ? first + l : line.count - 1;
    const double* node = shape.q + 6 * element;
    for (int j = 0; j < 4; ++j) {
      e.q[j].x[l] = node[3 * j];
      e.q[j].y[l] = node[3 * j + 1];
      e.q[j].z[l] = node[3 * j + 2];
    }
  }
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

inline void scatter_force(Batch& e, const LineTarget& target, int first, int used) {
  for (int i = 0; i < kDofs; ++i) {
    const Lanes f = is_tangent_dof(i) ? e.h * e.f[i] : e.f[i];
    for (int l = 0; l < used; ++l) {
      target.residual[6 * (first + l) + i] += f[l];
    }
  }
}

inline void scatter_tangent(Batch& e, const LineTarget& target, int first, int used) {
  for (int i = 0; i < kDofs; ++i) {
    for (int j = 0; j < kDofs; ++j) {
      Lanes k = e.k[i][j];
      k = is_tangent_dof(i) ? e.h * k : k;
      k = is_tangent_dof(j) ? e.h * k : k;
      double* base = nullptr;
      int stride = 48;
      if (i < 6) {
        base = j < 6 ? target.diag + 48 * first + 8 * i + j : target.upper + 48 * first + 8 * i + (j - 6);
      } else if (j < 6) {
        base = target.lower + 36 * first + 6 * (i - 6) + j;
        stride = 36;
      } else {
        base = target.diag + 48 * (first + 1) + 8 * (i - 6) + (j - 6);
      }
      for (int l = 0; l < used; ++l) {
        base[stride * l] += k[l];
      }
    }
  }
}

template <bool kTangent>
void add_batch(const LineView& line, const LineEnvironment& env, const LineShape& shape, const LineTarget& target,
               int first) {
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
  add_membrane<kTangent>(e, load_lanes(line.EA + first),
                         {load_lanes(line.pressure_constant + first), load_lanes(line.pressure_slope + first),
                          load_lanes(line.pressure_external + first)});
  add_loads<kTangent>(
      e, env,
      {load_lanes(line.weight + first), load_lanes(line.buoyancy + first), load_lanes(line.radius + first),
       load_lanes(line.drag_normal + first), load_lanes(line.drag_axial + first)});
  const int used = line.count - first < kWidth ? line.count - first : kWidth;
  scatter_force(e, target, first, used);
  if constexpr (kTangent) {
    scatter_tangent(e, target, first, used);
  }
}

}  // namespace

void add_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target) {
  for (int first = 0; first < line.count; first += kWidth) {
    if (target.diag != nullptr) {
      add_batch<true>(line, env, shape, target, first);
    } else {
      add_batch<false>(line, env, shape, target, first);
    }
  }
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
