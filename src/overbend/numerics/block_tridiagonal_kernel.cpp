#include "numerics/block_tridiagonal_kernel.h"

#include "numerics/block_kernel_rows.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// Six numbers fill three quarters of two registers of four, or of one of eight: the shorter ones need one stage less
/// to sum, and their sums leave a port to the shuffles.
inline constexpr int kNodeWidth = kWidth < 4 ? kWidth : 4;
inline constexpr int kNodeParts = (kNodeDofs + kNodeWidth - 1) / kNodeWidth;
using NodeLanes = double __attribute__((vector_size(8 * kNodeWidth), may_alias));
using LooseNodeLanes = double __attribute__((vector_size(8 * kNodeWidth), may_alias, aligned(8)));

/// Both right-hand sides of a row.
using Sides = double __attribute__((vector_size(16), may_alias));

inline Sides& sides(Row& row) {
  return reinterpret_cast<Sides*>(row.part)[kNodeDofs / 2];
}

inline void substitute_back(Row* d, const Row* u, Row* d_next) {
  for (int i = 0; i < kNodeDofs; ++i) {
    Sides x = sides(d[i]);
    for (int k = 0; k < kNodeDofs; ++k) {
      x -= u[i][k] * sides(d_next[k]);
    }
    sides(d[i]) = x;
  }
}

/// Six numbers of a node, and two zeros if they do not fill the last register.
struct NodeVector {
  NodeLanes part[kNodeParts];
};

inline NodeVector load_node(const double* x) {
#if OVERBEND_ISA_WIDTH >= 4
  return {{*reinterpret_cast<const LooseNodeLanes*>(x), NodeLanes{x[4], x[5], 0.0, 0.0}}};
#else
  return {{NodeLanes{x[0], x[1]}, NodeLanes{x[2], x[3]}, NodeLanes{x[4], x[5]}}};
#endif
}

inline void store_node(double* x, const NodeVector& v) {
#if OVERBEND_ISA_WIDTH >= 4
  *reinterpret_cast<LooseNodeLanes*>(x) = v.part[0];
  x[4] = v.part[1][0];
  x[5] = v.part[1][1];
#else
  for (int i = 0; i < kNodeDofs; ++i) {
    x[i] = v.part[i / 2][i % 2];
  }
#endif
}

inline NodeVector operator-(const NodeVector& a, const NodeVector& b) {
  NodeVector v;
  for (int i = 0; i < kNodeParts; ++i) {
    v.part[i] = a.part[i] - b.part[i];
  }
  return v;
}

/// Sums of neighbouring lanes of two registers, alternating.
template <int... L>
inline NodeLanes pairwise(const NodeLanes& a, const NodeLanes& b, std::integer_sequence<int, L...> /*all*/) {
  return __builtin_shufflevector(a, b, (L % 2 == 0 ? L : kNodeWidth + L - 1)...) +
         __builtin_shufflevector(a, b, (L % 2 == 0 ? L + 1 : kNodeWidth + L)...);
}

inline NodeLanes pairwise(const NodeLanes& a, const NodeLanes& b) {
  return pairwise(a, b, std::make_integer_sequence<int, kNodeWidth>());
}

/// Returns A x for the first six columns of a block.
inline NodeVector product(const double* a, const NodeVector& x) {
  NodeLanes sum[kNodeDofs];
  for (int i = 0; i < kNodeDofs; ++i) {
    const NodeLanes* row = reinterpret_cast<const NodeLanes*>(a + i * kRowWidth);
    sum[i] = row[0] * x.part[0];
    for (int p = 1; p < kNodeParts; ++p) {
      sum[i] += row[p] * x.part[p];
    }
  }
  const NodeLanes y01 = pairwise(sum[0], sum[1]), y23 = pairwise(sum[2], sum[3]), y45 = pairwise(sum[4], sum[5]);
#if OVERBEND_ISA_WIDTH >= 4
  return {
      {__builtin_shufflevector(y01, y23, 0, 1, 6, 7) + __builtin_shufflevector(y01, y23, 2, 3, 4, 5),
       __builtin_shufflevector(y45, NodeLanes{}, 0, 1, 4, 5) + __builtin_shufflevector(y45, NodeLanes{}, 2, 3, 6, 7)}};
#else
  return {{y01, y23, y45}};
#endif
}

inline Row* rows(double* blocks, int node) {
  return reinterpret_cast<Row*>(blocks + node * kBlockSize);
}

}  // namespace

BlockSolveReport factor_blocks(const BlockView& system, int first) {
  BlockSolveReport report;
  const int n = system.nodes, middle = system.middle;
  const auto diag = [&](int i) { return rows(system.diag, i); };
  const auto upper = [&](int i) { return rows(system.upper, i); };
  const auto lower = [&](int i) { return rows(system.lower, i); };
  const auto take = [&](int node, int sign) {
    if (sign == 0 && report.solved()) {
      report.singular_node = node;
    }
    report.negative_blocks += sign < 0 ? 1 : 0;
  };
  const auto pass_up = [&](int i) { update_next_node(diag(i), upper(i), system.lower + i * kBlockSize, diag(i + 1)); };
  const auto pass_down = [&](int j) {
    update_next_node(diag(j), lower(j - 1), system.upper + (j - 1) * kBlockSize, diag(j - 1));
  };
  int i = first < middle ? first : middle, j = n - 1;
  if (i > 0 && i < middle) pass_up(i - 1);
  // Each inverse has long latencies, so the two sides alternate. The middle node is updated last, so that its sum has
  // the same order for any first node.
  for (int waiting = n; i < middle || j > middle; ++i, --j) {
    if (i < middle) take(i, invert<true>(diag(i), upper(i)));
    if (waiting < n) pass_down(waiting);
    waiting = n;
    if (j > middle) {
      take(j, invert<true>(diag(j), lower(j - 1)));
      waiting = j > middle + 1 ? j : n;
    }
    if (i < middle - 1) pass_up(i);
    if (!report.solved()) return report;
  }
  if (middle > 0) pass_up(middle - 1);
  if (middle + 1 < n) pass_down(middle + 1);
  take(middle, invert<false>(diag(middle), nullptr));
  return report;
}

BlockSolveReport solve_blocks(const BlockView& system) {
  const BlockSolveReport report = factor_blocks(system, 0);
  if (!report.solved()) {
    return report;
  }
  const int n = system.nodes, middle = system.middle;
  int i = middle - 1, j = middle + 1;
  const auto back_down = [&](int k) {
    substitute_back(rows(system.diag, k), rows(system.upper, k), rows(system.diag, k + 1));
  };
  const auto back_up = [&](int k) {
    substitute_back(rows(system.diag, k), rows(system.lower, k - 1), rows(system.diag, k - 1));
  };
  for (; i >= 0 && j < n; --i, ++j) {
    back_down(i);
    back_up(j);
  }
  for (; i >= 0; --i) back_down(i);
  for (; j < n; ++j) back_up(j);
  return report;
}

void resolve_blocks(const BlockView& system, double* x) {
  const int n = system.nodes, middle = system.middle;
  const auto diag = [&](int i) { return system.diag + i * kBlockSize; };
  const auto upper = [&](int i) { return system.upper + i * kBlockSize; };
  const auto lower = [&](int i) { return system.lower + i * kBlockSize; };
  const auto node_values = [&](int i) { return x + i * kNodeDofs; };
  NodeVector below{}, above{};  // vectors of the last solved node on either side
  const auto from_below = [&](int i) {
    const NodeVector b = load_node(node_values(i));
    below = product(diag(i), i > 0 ? b - product(lower(i - 1), below) : b);
    store_node(node_values(i), below);
  };
  const auto from_above = [&](int j) {
    const NodeVector b = load_node(node_values(j));
    above = product(diag(j), j + 1 < n ? b - product(upper(j), above) : b);
    store_node(node_values(j), above);
  };
  int i = 0, j = n - 1;
  for (; i < middle && j > middle; ++i, --j) {
    from_below(i);
    from_above(j);
  }
  for (; i < middle; ++i) from_below(i);
  for (; j > middle; --j) from_above(j);
  NodeVector rest = load_node(node_values(middle));
  if (middle > 0) rest = rest - product(lower(middle - 1), below);
  if (middle + 1 < n) rest = rest - product(upper(middle), above);
  below = above = product(diag(middle), rest);
  store_node(node_values(middle), below);
  const auto back_down = [&](int k) {
    below = load_node(node_values(k)) - product(upper(k), below);
    store_node(node_values(k), below);
  };
  const auto back_up = [&](int k) {
    above = load_node(node_values(k)) - product(lower(k - 1), above);
    store_node(node_values(k), above);
  };
  for (i = middle - 1, j = middle + 1; i >= 0 && j < n; --i, ++j) {
    back_down(i);
    back_up(j);
  }
  for (; i >= 0; --i) back_down(i);
  for (; j < n; ++j) back_up(j);
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
