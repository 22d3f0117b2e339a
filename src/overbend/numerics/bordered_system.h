/// Several block-tridiagonal lines and a few shared unknowns (border): bodies, machines, horizontal tension.
///
///     [ L1          B1 ] [x1]   [r1]        S  = H - sum_i C_i L_i^-1 B_i
///     [     L2      B2 ] [x2] = [r2]        y  = S^-1 (h - sum_i C_i L_i^-1 r_i)
///     [         ..  .. ] [..]   [..]        x_i = L_i^-1 r_i - (L_i^-1 B_i) y
///     [ C1  C2  ..  H  ] [y ]   [h ]
///
/// B_i and C_i have rows at few nodes, and columns only for unknowns coupled to line i. The columns L_i^-1 B_i are
/// solved with the factorisation and remain valid as long as it does. Sums run over lines in their order, and within a
/// line over its nodes, so that results are bitwise independent of threads and of the order of assembly. Each line must
/// be regular by itself.
#pragma once

#include <span>
#include <vector>

#include "base/aligned.h"
#include "base/simd.h"
#include "numerics/block_tridiagonal.h"
#include "numerics/dense_lu.h"
#include "numerics/node_panels.h"

namespace overbend {

/// Structure of one line: number of nodes, and the shared unknowns coupled to it, ascending.
struct BorderedLine {
  int nodes = 0;
  std::vector<int> unknowns;
};

struct BorderedReport {
  int singular_line = -1;  ///< First line with a block without pivot, at `singular_node`.
  int singular_node = -1;
  int singular_unknown = -1;     ///< First shared unknown without a pivot in the Schur system.
  int negative_blocks = 0;       ///< Number over all lines; see BlockSolveReport.
  bool negative_border = false;  ///< True if the determinant of the Schur system is negative.
  bool solved() const { return singular_line < 0 && singular_unknown < 0; }
};

class BorderedSystem {
 public:
  BorderedSystem() = default;
  /// Allocates all memory.
  BorderedSystem(const std::vector<BorderedLine>& lines, int unknowns, Isa isa = best_isa());

  int lines() const { return static_cast<int>(lines_.size()); }
  int unknowns() const { return schur_.size(); }
  BlockTridiagonal& line(int i) { return at(i).blocks; }
  const BlockTridiagonal& line(int i) const { return lines_[static_cast<std::size_t>(i)].blocks; }

  /// Distance between the rows of a line's border panels.
  int stride(int line) const { return lines_[static_cast<std::size_t>(line)].columns.stride(); }
  /// Returns B of a node, row-major 6 x stride: its equations (rows) by the line's shared unknowns (columns, as listed
  /// in BorderedLine). To be added to.
  double* columns(int line, int node) { return at(line).columns.at(node); }
  /// Returns C of a node, transposed like B: entry (i, j) is the coefficient of freedom i in the equation of the line's
  /// shared unknown j.
  double* rows(int line, int node) { return at(line).rows.at(node); }
  /// True if a panel of columns or rows of the node was requested since the border was cleared.
  bool bordered(int line, int node) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    return of.columns.view().slot[node] >= 0 || of.rows.view().slot[node] >= 0;
  }
  /// Returns the entry (i, j) of H.
  double& corner(int i, int j) { return corner_[static_cast<std::size_t>(i * unknowns() + j)]; }

  /// Sets blocks, borders and corner to zero.
  void set_zero();
  /// Sets the border of one line to zero.
  void clear_border(int line);
  void clear_corner();
  /// Fixes a shared unknown: its equation is dropped and its y is zero.
  void hold(int unknown, bool held);

  /// Factors everything. The blocks are overwritten, as by `solve` of a line; borders and corner are kept.
  BorderedReport factor();
  /// Factors a line from node `first` on, see `refactor`, and solves its border's columns. `close` must follow. Lines
  /// may be factored concurrently by several threads.
  BlockSolveReport factor_line(int line, int first = 0);
  /// Solves the columns of a line's border again with existing factors. `close` must follow.
  void factor_border(int line);
  /// Makes and factors the Schur system. Returns the first unknown without a pivot, -1 if there is none.
  int close();

  /// Replaces right-hand sides by the solution: `x` of each line, six per node, and `y`, one per shared unknown.
  void solve(std::span<double* const> x, double* y);
  /// Solves one line alone: `x`, six per node, without the border's part. `close` must follow before the full system is
  /// solved.
  BlockSolveReport solve_line(int line, double* x) { return solve_line(at(line), x); }
  /// Combines `factor` and `solve`: the right-hand sides of the lines go through the elimination with the blocks, which
  /// keeps digits that inverses lose for a nearly inextensible line. After a failure x and y are undefined.
  BorderedReport factor_and_solve(std::span<double* const> x, double* y);

 private:
  struct Line {
    BlockTridiagonal blocks;
    std::vector<int> unknowns;
    NodePanels columns, rows;              ///< B and C.
    AlignedDoubles solved;                 ///< L^-1 B.
    AlignedDoubles contribution;           ///< C L^-1 B.
    AlignedDoubles touched_y, touched_cx;  ///< For the unknowns coupled to this line.
  };

  Line& at(int i) { return lines_[static_cast<std::size_t>(i)]; }
  /// A single column needs no panel: it is the second right-hand side next to `x` in the elimination.
  BlockSolveReport solve_line(Line& line, double* x);
  static void put_right_hand_sides(Line& line, const double* x, bool has_border_column);
  void close_line(Line& line) const;
  void solve_border(std::span<double* const> x, double* y);
  BorderedReport make_line_report(const Line& line, const BlockSolveReport& report, BorderedReport so_far) const;

  std::vector<Line> lines_;
  std::vector<double> corner_;
  std::vector<char> held_;
  DenseLu schur_;
  Isa isa_ = Isa::baseline;
};

/// Adds an element's columns (12 x m) to the border of `node` and `node + 1`, m the shared unknowns of the line.
template <class Matrix>
void add_border_columns(BorderedSystem& system, int line, int node, const Matrix& b) {
  for (int half = 0; half < 2; ++half) {
    double* const panel = system.columns(line, node + half);
    for (int i = 0; i < kNodeDofs; ++i) {
      for (int j = 0; j < static_cast<int>(b.cols()); ++j) {
        panel[i * system.stride(line) + j] += b(kNodeDofs * half + i, j);
      }
    }
  }
}

/// Adds an element's rows (m x 12), as above.
template <class Matrix>
void add_border_rows(BorderedSystem& system, int line, int node, const Matrix& c) {
  for (int half = 0; half < 2; ++half) {
    double* const panel = system.rows(line, node + half);
    for (int i = 0; i < kNodeDofs; ++i) {
      for (int j = 0; j < static_cast<int>(c.rows()); ++j) {
        panel[i * system.stride(line) + j] += c(j, kNodeDofs * half + i);
      }
    }
  }
}

}  // namespace overbend
