#include "recording/node_recovery_kernel.h"

#include "mechanics/lane_vectors.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

constexpr int kRow = 6;
constexpr int kSpare = kWidth > kRow ? kWidth - kRow : 0;  ///< Number of doubles that a register reads beyond a row.

/// Two vectors for each of as many nodes as a register has lanes.
struct Pair {
  Vec first, second;
};

/// Reads consecutive rows, and `kSpare` doubles beyond the last.
Pair load_columns(const double* rows) {
  Lanes columns[kRow];
  for (int from = 0; from < kRow; from += kWidth) {
    const int start = from + kWidth <= kRow || kWidth > kRow ? from : kRow - kWidth;  // the last part ends with the row
    Lanes part[kWidth];
    for (int l = 0; l < kWidth; ++l) part[l] = unaligned(rows + kRow * l + start);
    transpose(part);
    for (int j = 0; j < kWidth && start + j < kRow; ++j) columns[start + j] = part[j];
  }
  return {{columns[0], columns[1], columns[2]}, {columns[3], columns[4], columns[5]}};
}

struct Recovered {
  Vec place, tangent, bend;
  Lanes tension, moment, vertical;
};

Recovered recover(const Pair& node, const Pair& cut) {
  const Vec& a = node.second;
  const Vec t = (1.0 / root(dot(a, a))) * a;
  // The moment of the cut without its component about the pipe's axis, turned towards the centre of curvature.
  const Vec all_of_it = cross(a, cut.second);
  const Vec b = cross(all_of_it - dot(all_of_it, t) * t, t);
  // Component along the unit vector that points upwards across the pipe, (0, 0, 1) - t.z t over its length; undefined
  // for an upright pipe. `b` is across the pipe itself.
  const Lanes level = root(t.x * t.x + t.y * t.y);
  return {node.first, t, b, dot(cut.first, t), root(dot(b, b)), level > 1e-9 ? b.z / level : Lanes{}};
}

/// Stores `count` of the lanes at node `first`.
void put(const Lanes& values, int first, int count, double* out) {
  if (count == kWidth) {
    unaligned(out + first) = values;
    return;
  }
  for (int l = 0; l < count; ++l) out[first + l] = values[l];
}

void put(const Recovered& nodes, int first, int count, const RecoveredNodes& out) {
  put(nodes.place.x, first, count, out.x);
  put(nodes.place.y, first, count, out.y);
  put(nodes.place.z, first, count, out.z);
  put(nodes.tangent.x, first, count, out.tangent[0]);
  put(nodes.tangent.y, first, count, out.tangent[1]);
  put(nodes.tangent.z, first, count, out.tangent[2]);
  put(nodes.bend.x, first, count, out.bend[0]);
  put(nodes.bend.y, first, count, out.bend[1]);
  put(nodes.bend.z, first, count, out.bend[2]);
  put(nodes.tension, first, count, out.tension);
  put(nodes.moment, first, count, out.moment);
  put(nodes.vertical, first, count, out.vertical);
}

/// A copy of the last rows, padded with repetitions of the last one.
struct LastRows {
  double values[kRow * kWidth + kSpare] = {};

  LastRows(const double* rows, int count) {
    for (int l = 0; l < kWidth; ++l) {
      const double* row = rows + kRow * (l < count ? l : count - 1);
      for (int i = 0; i < kRow; ++i) values[kRow * l + i] = row[i];
    }
  }
};

}  // namespace

void recover_nodes(const NodeRows& rows, int count, const RecoveredNodes& out) {
  int first = 0;
  for (; first + kWidth < count; first += kWidth) {
    put(recover(load_columns(rows.q + kRow * first), load_columns(rows.cuts + kRow * first)), first, kWidth, out);
  }
  if (first < count) {
    const LastRows q(rows.q + kRow * first, count - first), cuts(rows.cuts + kRow * first, count - first);
    put(recover(load_columns(q.values), load_columns(cuts.values)), first, count - first, out);
  }
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
