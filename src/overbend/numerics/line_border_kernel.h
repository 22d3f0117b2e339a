/// Operations on the border of a block-tridiagonal line, compiled once per instruction set.
///
/// A panel holds several border columns of a line: row-major 6 x `stride` for each node, `stride` a multiple of eight.
#pragma once

#include "numerics/block_tridiagonal_kernel.h"

namespace overbend {

/// Border rows at the few nodes that have any: `slot[node]` is the index of a node's panel in `values`, or -1.
struct SparsePanelView {
  const int* slot;
  const double* values;
  int first, last;  ///< Nodes outside [first, last] have none.
  int stride;
};

namespace isa_baseline {
/// X = A^-1 B for a factored line A; all nodes of `x` are written.
void solve_panel(const BlockView& factored, const SparsePanelView& b, double* x);
/// out(i, j) = sum over nodes and equations of c(., i) x(., j); row-major, square, of the panels' stride.
void panel_product(const SparsePanelView& c, const double* x, double* out);
/// out(i) = sum over nodes and equations of c(., i) x(.), x six per node.
void panel_times_vector(const SparsePanelView& c, const double* x, double* out);
/// x -= W y, x six per node.
void subtract_columns(int nodes, int stride, const double* w, const double* y, double* x);
}  // namespace isa_baseline
namespace isa_avx2 {
void solve_panel(const BlockView& factored, const SparsePanelView& b, double* x);
void panel_product(const SparsePanelView& c, const double* x, double* out);
void panel_times_vector(const SparsePanelView& c, const double* x, double* out);
void subtract_columns(int nodes, int stride, const double* w, const double* y, double* x);
}  // namespace isa_avx2
namespace isa_avx512 {
void solve_panel(const BlockView& factored, const SparsePanelView& b, double* x);
void panel_product(const SparsePanelView& c, const double* x, double* out);
void panel_times_vector(const SparsePanelView& c, const double* x, double* out);
void subtract_columns(int nodes, int stride, const double* w, const double* y, double* x);
}  // namespace isa_avx512

}  // namespace overbend
