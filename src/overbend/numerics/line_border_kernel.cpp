#include "numerics/line_border_kernel.h"

#include "base/lane_transpose.h"
#include "base/simd.h"
#include "base/unaligned_lanes.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

inline const Lanes& lanes(const double* p) {
  return *reinterpret_cast<const Lanes*>(p);
}
inline Lanes& lanes(double* p) {
  return *reinterpret_cast<Lanes*>(p);
}

/// Six rows of a node's panel, one register of columns.
struct Columns {
  Lanes row[kNodeDofs];
};

inline Columns load(const double* panel, int stride) {
  Columns columns;
  for (int i = 0; i < kNodeDofs; ++i) {
    columns.row[i] = lanes(panel + i * stride);
  }
  return columns;
}

inline void store(const Columns& columns, double* panel, int stride) {
  for (int i = 0; i < kNodeDofs; ++i) {
    lanes(panel + i * stride) = columns.row[i];
  }
}

/// columns -= A x, A the first six columns of a block.
inline void subtract_product(const double* a, const Columns& x, Columns& columns) {
  for (int i = 0; i < kNodeDofs; ++i) {
    for (int k = 0; k < kNodeDofs; ++k) {
      columns.row[i] -= a[i * kRowWidth + k] * x.row[k];
    }
  }
}

inline Columns product(const double* a, const Columns& x) {
  Columns columns;
  for (int i = 0; i < kNodeDofs; ++i) {
    columns.row[i] = a[i * kRowWidth] * x.row[0];
    for (int k = 1; k < kNodeDofs; ++k) {
      columns.row[i] += a[i * kRowWidth + k] * x.row[k];
    }
  }
  return columns;
}

/// Product of a row of a panel with `y`, lane by lane: the sum of lanes is the product.
inline Lanes row_product(const double* row, const double* y, int stride) {
  Lanes sum = lanes(row) * lanes(y);
  for (int column = kWidth; column < stride; column += kWidth) {
    sum += lanes(row + column) * lanes(y + column);
  }
  return sum;
}

inline const double* panel_at(const SparsePanelView& panel, int node) {
  const int slot = node < panel.first || node > panel.last ? -1 : panel.slot[node];
  return slot < 0 ? nullptr : panel.values + slot * kNodeDofs * panel.stride;
}

/// Implements subtract_columns(), for one batch of columns or any number.
template <bool kOneBatch>
inline void subtract(int nodes, int any_stride, const double* w, const double* y, double* x) {
  const int rows = nodes * kNodeDofs, stride = kOneBatch ? kLanes : any_stride;
  int first = 0;
  for (; first + kWidth <= rows; first += kWidth) {
    Lanes sums[kWidth];
    for (int row = 0; row < kWidth; ++row) sums[row] = row_product(w + (first + row) * stride, y, stride);
    UnalignedLanes& to = unaligned(x + first);
    to -= row_sums(sums);
  }
  for (; first < rows; ++first) {
    const Lanes sum = row_product(w + first * stride, y, stride);
    for (int lane = 0; lane < kWidth; ++lane) x[first] -= sum[lane];
  }
}

/// Solves for one register of columns from `column` on: from both ends to the middle and back, as in
/// block_tridiagonal_kernel.cpp.
void solve_columns(const BlockView& factored, const SparsePanelView& b, int column, double* x) {
  const int n = factored.nodes, middle = factored.middle;
  const auto node_columns = [&](int node) { return x + node * kNodeDofs * b.stride + column; };
  const auto side = [&](int node) {
    const double* rhs = panel_at(b, node);
    return rhs != nullptr ? load(rhs + column, b.stride) : Columns{};
  };
  const auto take_lower = [&](int node, const Columns& below, Columns& current) {
    subtract_product(factored.lower + (node - 1) * kBlockSize, below, current);
  };
  const auto take_upper = [&](int node, const Columns& above, Columns& current) {
    subtract_product(factored.upper + node * kBlockSize, above, current);
  };
  Columns below{}, above{};  // zero until the first node with rows
  for (int i = 0; i < middle; ++i) {
    if (i >= b.first) {
      Columns current = side(i);
      if (i > b.first) take_lower(i, below, current);
      below = product(factored.diag + i * kBlockSize, current);
    }
    store(below, node_columns(i), b.stride);
  }
  for (int j = n - 1; j > middle; --j) {
    if (j <= b.last) {
      Columns current = side(j);
      if (j < b.last) take_upper(j, above, current);
      above = product(factored.diag + j * kBlockSize, current);
    }
    store(above, node_columns(j), b.stride);
  }
  Columns current = side(middle);
  if (middle > b.first) take_lower(middle, below, current);
  if (middle < b.last) take_upper(middle, above, current);
  below = above = product(factored.diag + middle * kBlockSize, current);
  store(below, node_columns(middle), b.stride);
  for (int i = middle - 1; i >= 0; --i) {
    current = load(node_columns(i), b.stride);
    take_upper(i, below, current);
    below = current;
    store(below, node_columns(i), b.stride);
  }
  for (int j = middle + 1; j < n; ++j) {
    current = load(node_columns(j), b.stride);
    take_lower(j, above, current);
    above = current;
    store(above, node_columns(j), b.stride);
  }
}

}  // namespace

void solve_panel(const BlockView& factored, const SparsePanelView& b, double* x) {
  for (int column = 0; column < b.stride; column += kWidth) {
    solve_columns(factored, b, column, x);
  }
}

void panel_product(const SparsePanelView& c, const double* x, double* out) {
  const int stride = c.stride;
  for (int i = 0; i < stride * stride; i += kWidth) {
    lanes(out + i) = Lanes{};
  }
  for (int node = c.first; node <= c.last; ++node) {
    const double* row = panel_at(c, node);
    if (row == nullptr) {
      continue;
    }
    for (int column = 0; column < stride; column += kWidth) {
      const Columns node_columns = load(x + node * kNodeDofs * stride + column, stride);
      for (int i = 0; i < stride; ++i) {
        Lanes sum = lanes(out + i * stride + column);
        for (int dof = 0; dof < kNodeDofs; ++dof) {
          sum += row[dof * stride + i] * node_columns.row[dof];
        }
        lanes(out + i * stride + column) = sum;
      }
    }
  }
}

void panel_times_vector(const SparsePanelView& c, const double* x, double* out) {
  for (int column = 0; column < c.stride; column += kWidth) {
    Lanes sum = {};
    for (int node = c.first; node <= c.last; ++node) {
      const double* row = panel_at(c, node);
      if (row == nullptr) {
        continue;
      }
      for (int dof = 0; dof < kNodeDofs; ++dof) {
        sum += x[node * kNodeDofs + dof] * lanes(row + dof * c.stride + column);
      }
    }
    lanes(out + column) = sum;
  }
}

void subtract_columns(int nodes, int stride, const double* w, const double* y, double* x) {
  stride == kLanes ? subtract<true>(nodes, stride, w, y, x) : subtract<false>(nodes, stride, w, y, x);
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
