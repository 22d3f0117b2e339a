/// The tangent of a batch as a whole, and its way into the blocks of the system. For line_kernel.cpp alone.
#pragma once

#include "mechanics/line_kernel_loads.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// Of r1, h t1, r2, h t2: which slope it makes. r1 makes the chord shorter.
inline constexpr int kSlopeOf[4] = {kChord, kLowerSlope, kChord, kUpperSlope};
inline constexpr double kSlopeSign[4] = {-1.0, 1.0, 1.0, 1.0};

/// The blocks below the diagonal.
inline void mirror_slopes(BatchTangent& tangent) {
  for (int j = 0; j < 3; ++j) {
    for (int k = j + 1; k < 3; ++k) {
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          tangent.by_slope[3 * k + c][3 * j + r] = tangent.by_slope[3 * j + r][3 * k + c];
        }
      }
    }
  }
}

/// All together, and from h t to t: `scale` is 1 or h of r1, h t1, r2, h t2.
inline void join(BatchTangent& tangent, const Lanes (&scale)[4]) {
  mirror_slopes(tangent);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
#pragma GCC unroll 4
      for (int k = 0; k < 4; ++k) {
        Lanes by_node[kGaussPoints];
#pragma GCC unroll 4
        for (int i = 0; i < kGaussPoints; ++i) {
          by_node[i] = kGaussShape[i].n[k] * tangent.in_r[i].m[r][c] + kGaussShape[i].c[k] * tangent.in_a[i].m[r][c];
        }
#pragma GCC unroll 4
        for (int j = 0; j < 4; ++j) {
          Lanes sum = (kSlopeSign[j] * kSlopeSign[k]) * tangent.by_slope[3 * kSlopeOf[j] + r][3 * kSlopeOf[k] + c];
#pragma GCC unroll 4
          for (int i = 0; i < kGaussPoints; ++i) {
            sum += kGaussShape[i].n[j] * by_node[i];
          }
          if (c == 2) {
            sum += tangent.by_height[3 * j + r][k];
          }
          tangent.k[3 * j + r][3 * k + c] = scale[j] * (scale[k] * sum);
        }
      }
    }
  }
}

/// Puts half a row of the tangent, six columns, into a row of eight of every element's block; `rows` is that of the
/// first element, and blocks follow one another.
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

/// What the elements of a batch add to the blocks of their upper nodes: the next batch adds its lower nodes' to the
/// last.
struct UpperBlocks {
  Lanes rows[kNodeDofs][kNodeDofs] = {};
};

/// Writes the blocks of a batch but the diagonal one after its last element, which is left in `upper`.
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

/// The diagonal block of the line's last node, above the element in lane `last`.
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
