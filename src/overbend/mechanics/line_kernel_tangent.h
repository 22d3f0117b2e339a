/// Complete tangent of a batch and its assembly into the blocks of the system. For line_kernel.cpp only.
#pragma once

#include "mechanics/line_kernel_loads.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// Contribution of a quantity with values at two points symmetric about the middle to pairs of functions: its sum for
/// two even or two odd functions, its difference, upper minus lower, for one of each.
struct Pair {
  Lanes sum, difference;
};

inline Pair make_point_pair(const Lanes& lower, const Lanes& upper) {
  return {upper + lower, upper - lower};
}

/// Adds bending at all points for the slope unknowns: the block of components r and c, on and above the diagonal. First
/// derivatives of turn are odd, those of chord and both even; second derivatives the other way.
inline void add_bending_tangent(BatchTangent& tangent, int r, int c) {
  Lanes turn_turn{}, turn_chord{}, turn_both{}, chord_chord{}, chord_both{}, both_both{};
#pragma GCC unroll 2
  for (int pair = 0; pair < kGaussPairs; ++pair) {
    const int upper = kGaussPairs + pair, lower = kGaussPairs - 1 - pair;
    const Shape& s = kGaussShape[pair];
    const Pair aa = make_point_pair(tangent.aa[lower].m[r][c], tangent.aa[upper].m[r][c]);
    const Pair ab = make_point_pair(tangent.ba[lower].m[c][r], tangent.ba[upper].m[c][r]);
    const Pair ba = make_point_pair(tangent.ba[lower].m[r][c], tangent.ba[upper].m[r][c]);
    const Pair bb = make_point_pair(tangent.bb[lower].m[r][c], tangent.bb[upper].m[r][c]);
    // Factors of a row's first and second derivative in a column.
    struct Column {
      Lanes by_c, by_d;
    };
    const auto like = [&](int j) {
      return Column{s.c[j] * aa.sum + s.d[j] * ab.difference, s.c[j] * ba.difference + s.d[j] * bb.sum};
    };
    const auto unlike = [&](int j) {
      return Column{s.c[j] * aa.difference + s.d[j] * ab.sum, s.c[j] * ba.sum + s.d[j] * bb.difference};
    };
    const auto row = [&](int j, const Column& x) { return s.c[j] * x.by_c + s.d[j] * x.by_d; };
    const Column chord = like(1), both = like(2);
    turn_turn += row(0, like(0));
    turn_chord += row(0, unlike(1));
    turn_both += row(0, unlike(2));
    chord_chord += row(1, chord);
    chord_both += row(1, both);
    both_both += row(2, both);
  }
  tangent.by_slope[r][c] += turn_turn;
  tangent.by_slope[r][3 + c] += turn_chord;
  tangent.by_slope[r][6 + c] += turn_both;
  tangent.by_slope[3 + r][3 + c] += chord_chord;
  tangent.by_slope[3 + r][6 + c] += chord_both;
  tangent.by_slope[6 + r][6 + c] += both_both;
}

/// Adds loads at all points, in components r and c, by mean, turn, chord and both.
inline void load_tangent(const BatchTangent& tangent, int r, int c, Lanes (&k)[4][4]) {
  for (auto& row : k) {
    for (Lanes& entry : row) entry = Lanes{};
  }
#pragma GCC unroll 2
  for (int pair = 0; pair < kGaussPairs; ++pair) {
    const int upper = kGaussPairs + pair, lower = kGaussPairs - 1 - pair;
    const Shape& s = kGaussShape[pair];
    const Pair in_r = make_point_pair(tangent.in_r[lower].m[r][c], tangent.in_r[upper].m[r][c]);
    const Pair in_a = make_point_pair(tangent.in_a[lower].m[r][c], tangent.in_a[upper].m[r][c]);
    // Columns for an even and for an odd function.
    const Lanes even[4] = {in_r.sum, s.n[1] * in_r.sum + s.c[0] * in_a.difference,
                           s.n[2] * in_r.difference + s.c[1] * in_a.sum, s.n[3] * in_r.difference + s.c[2] * in_a.sum};
    const Lanes odd[4] = {in_r.difference, s.n[1] * in_r.difference + s.c[0] * in_a.sum,
                          s.n[2] * in_r.sum + s.c[1] * in_a.difference, s.n[3] * in_r.sum + s.c[2] * in_a.difference};
#pragma GCC unroll 4
    for (int j = 0; j < 4; ++j) {
      k[kMean][j] += even[j];
      k[kTurn][j] += s.n[1] * even[j];
      k[kChord][j] += s.n[2] * odd[j];
      k[kBoth][j] += s.n[3] * odd[j];
    }
  }
}

/// Slopes dr/d(xi) at the three strain points by turn, chord and both.
inline constexpr double kStrainSlope[3][3] = {{-0.5, 0.0, 0.5}, {0.0, kMidChord, kMidBoth}, {0.5, 0.0, 0.5}};

/// Adds the derivatives with the strain rates, in components r and c.
inline void add_rate_tangent(const BatchTangent& tangent, int r, int c, Lanes (&k)[4][4]) {
  for (int strain = 0; strain < 3; ++strain) {
    const Vec &u = tangent.rate_rows[strain], &v = tangent.rate_columns[strain];
    const Lanes row[3] = {u.x, u.y, u.z}, column[3] = {v.x, v.y, v.z};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        k[1 + i][1 + j] += (kStrainSlope[strain][i] * kStrainSlope[strain][j]) * row[r] * column[c];
      }
    }
  }
}

/// Transforms from mean, turn, chord and both to r1, t1, r2, t2.
inline void to_nodes(const Lanes& h, const Lanes& mean, const Lanes& turn, const Lanes& chord, const Lanes& both,
                     Lanes (&nodes)[4]) {
  nodes[0] = 0.5 * mean - chord;
  nodes[1] = h * (both - turn);
  nodes[2] = 0.5 * mean + chord;
  nodes[3] = h * (both + turn);
}

/// Joins all parts of the tangent.
inline void join(BatchTangent& tangent, const Lanes& h) {
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      add_bending_tangent(tangent, r, c);
    }
  }
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      Lanes k[4][4];
      load_tangent(tangent, r, c, k);
      if (tangent.has_rates) add_rate_tangent(tangent, r, c, k);
#pragma GCC unroll 3
      for (int i = 0; i < 3; ++i) {
#pragma GCC unroll 3
        for (int j = 0; j < 3; ++j) {
          k[1 + i][1 + j] += i <= j ? tangent.by_slope[3 * i + r][3 * j + c] : tangent.by_slope[3 * j + c][3 * i + r];
        }
        if (c == 2) {
#pragma GCC unroll 3
          for (int j = 0; j < 3; ++j) {
            k[1 + i][j] += tangent.by_height[3 * i + r][j];
          }
        }
      }
      Lanes columns[4][4];
#pragma GCC unroll 4
      for (int i = 0; i < 4; ++i) {
        to_nodes(h, k[i][kMean], k[i][kTurn], k[i][kChord], k[i][kBoth], columns[i]);
      }
#pragma GCC unroll 4
      for (int j = 0; j < 4; ++j) {
        Lanes rows[4];
        to_nodes(h, columns[kMean][j], columns[kTurn][j], columns[kChord][j], columns[kBoth][j], rows);
#pragma GCC unroll 4
        for (int i = 0; i < 4; ++i) {
          tangent.k[3 * i + r][3 * j + c] = rows[i];
        }
      }
    }
  }
}

/// Stores half a row of the tangent, six columns, into a row of eight of every element's block; `rows` is the row of
/// the first element, and blocks are consecutive.
inline void put_row(const Lanes (&columns)[kNodeDofs], double* rows, int used) {
  for (int part = 0; part < kRowWidth; part += kWidth) {
    Lanes lanes[kWidth];
    for (int j = 0; j < kWidth; ++j) {
      lanes[j] = part + j < kNodeDofs ? columns[part + j < kNodeDofs ? part + j : 0] : Lanes{};
    }
    transpose(lanes);
    for (int l = 0; l < used; ++l) {
      *reinterpret_cast<Lanes*>(rows + kBlockSize * l + part) = lanes[l];
    }
  }
}

/// Contributions of the elements of a batch to the blocks of their upper nodes: the next batch adds the contributions
/// of its lower nodes to the last one.
struct UpperBlocks {
  Lanes rows[kNodeDofs][kNodeDofs] = {};
};

/// Writes the blocks of a batch except the diagonal one after its last element, which is left in `upper`.
inline void put_tangent(const BatchTangent& tangent, const LineTarget& target, UpperBlocks& upper, int first,
                        int used) {
  for (int i = 0; i < kNodeDofs; ++i) {
    Lanes columns[kNodeDofs];
    for (int c = 0; c < kNodeDofs; ++c) {
      const Lanes of_upper = tangent.k[kNodeDofs + i][kNodeDofs + c];
      columns[c] = tangent.k[i][c] + from_last(of_upper, upper.rows[i][c]);
      upper.rows[i][c] = of_upper;
    }
    const int row = kBlockSize * first + kRowWidth * i;
    put_row(columns, target.diag + row, used);
    for (int c = 0; c < kNodeDofs; ++c) {
      columns[c] = tangent.k[i][kNodeDofs + c];
    }
    put_row(columns, target.upper + row, used);
    for (int c = 0; c < kNodeDofs; ++c) {
      columns[c] = tangent.k[kNodeDofs + i][c];
    }
    put_row(columns, target.lower + row, used);
  }
}

/// Writes the diagonal block of the line's last node, above the element in lane `last`.
inline void put_last_block(const UpperBlocks& upper, const LineTarget& target, int node, int last) {
  for (int i = 0; i < kNodeDofs; ++i) {
    double* row = target.diag + kBlockSize * node + kRowWidth * i;
    for (int c = 0; c < kRowWidth; ++c) {
      row[c] = c < kNodeDofs ? upper.rows[i][c < kNodeDofs ? c : 0][last] : 0.0;
    }
  }
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
