/// Several block-tridiagonal lines and a few unknowns that they share: bodies, machines, a far force.
///
///     [ L1          B1 ] [x1]   [r1]        S  = H - sum_i C_i L_i^-1 B_i
///     [     L2      B2 ] [x2] = [r2]        y  = S^-1 (h - sum_i C_i L_i^-1 r_i)
///     [         ..  .. ] [..]   [..]        x_i = L_i^-1 r_i - (L_i^-1 B_i) y
///     [ C1  C2  ..  H  ] [y ]   [h ]
///
/// B_i and C_i have rows at few nodes, and columns for those unknowns only that line i touches. The columns L_i^-1 B_i
/// are solved when the factors are made and serve as long as these do. Sums run over lines in their order, and within
/// a line over its nodes, so that bits depend on neither threads nor the order of assembly. Each line has to be regular
/// by itself.
#pragma once

#include <span>
#include <vector>

#include "base/aligned.h"
#include "base/simd.h"
#include "numerics/block_tridiagonal.h"
#include "numerics/dense_lu.h"
#include "numerics/node_panels.h"

namespace overbend {

/// The shape of one line: how many nodes, and which shared unknowns its equations know or are known by, ascending.
struct BorderedLine {
  int nodes = 0;
  std::vector<int> unknowns;
};

struct BorderedReport {
  int singular_line = -1;  ///< First line with a block without pivot, at `singular_node`.
  int singular_node = -1;
  int singular_unknown = -1;     ///< First shared unknown without a pivot in the Schur system.
  int negative_blocks = 0;       ///< Over all lines; see BlockSolveReport.
  bool negative_border = false;  ///< Whether the determinant of the Schur system is negative.
  bool solved() const { return singular_line < 0 && singular_unknown < 0; }
};

class BorderedSystem {
 public:
  BorderedSystem() = default;
  /// Takes all memory there will be need for.
  BorderedSystem(const std::vector<BorderedLine>& lines, int unknowns, Isa isa = best_isa());

  int lines() const { return static_cast<int>(lines_.size()); }
  int unknowns() const { return schur_.size(); }
  BlockTridiagonal& line(int i) { return at(i).blocks; }
  const BlockTridiagonal& line(int i) const { return lines_[static_cast<std::size_t>(i)].blocks; }

  /// Distance between the rows of a line's border panels.
  int stride(int line) const { return lines_[static_cast<std::size_t>(line)].columns.stride(); }
  /// B of a node, row-major 6 x stride: its equations (rows) by the line's shared unknowns (columns, as listed in
  /// BorderedLine). To be added to.
  double* columns(int line, int node) { return at(line).columns.at(node); }
  /// C of a node, transposed like B: entry (i, j) is what the equation of the line's shared unknown j has for freedom
  /// i.
  double* rows(int line, int node) { return at(line).rows.at(node); }
  /// Whether a node has a panel of columns or rows that was asked for since the border was cleared.
  bool bordered(int line, int node) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    return of.columns.view().slot[node] >= 0 || of.rows.view().slot[node] >= 0;
  }
  /// H.
  double& corner(int i, int j) { return corner_[static_cast<std::size_t>(i * unknowns() + j)]; }

  /// Blocks, borders and corner to zero.
  void set_zero();
  /// The border of one line to zero.
  void clear_border(int line);
  void clear_corner();
  /// A held unknown stays as it is: its equation is left out, its y is zero.
  void hold(int unknown, bool held);

  /// Factors everything. The blocks are overwritten, as `solve` of a line does; borders and corner stay.
  BorderedReport factor();
  /// Factors a line from node `first` on, see `refactor`, and solves its border's columns.
  /// `close` must follow. Lines may be factored at the same time by several threads.
  BlockSolveReport factor_line(int line, int first = 0);
  /// Solves the columns of a line's border anew; its factors stand. `close` must follow.
  void factor_border(int line);
  /// Makes and factors the Schur system. The first unknown without a pivot, -1 if there is none.
  int close();

  /// Replaces right-hand sides by the solution: `x` of each line, six per node, and `y`, one per shared unknown.
  void solve(std::span<double* const> x, double* y);
  /// The same of one line by itself: `x`, six per node, without the border's part. `close` must follow before the whole
  /// is solved.
  BlockSolveReport solve_line(int line, double* x) { return solve_line(at(line), x); }
  /// `factor` and `solve` in one: the right-hand sides of the lines go through the elimination with the blocks, which
  /// keeps digits that inverses lose where a line hardly stretches. Where it fails, x and y are spoilt.
  BorderedReport factor_and_solve(std::span<double* const> x, double* y);

 private:
  struct Line {
    BlockTridiagonal blocks;
    std::vector<int> unknowns;
    NodePanels columns, rows;      ///< B and C.
    AlignedDoubles solved;         ///< L^-1 B.
    AlignedDoubles contribution;   ///< C L^-1 B.
    AlignedDoubles own_y, own_cx;  ///< Of the unknowns that this line touches.
  };

  Line& at(int i) { return lines_[static_cast<std::size_t>(i)]; }
  /// One column needs no panel: it rides beside the right-hand side `x` through the elimination.
  BlockSolveReport solve_line(Line& line, double* x);
  static void put_right_hand_sides(Line& line, const double* x, bool border_beside);
  void close_line(Line& line) const;
  void solve_border(std::span<double* const> x, double* y);
  BorderedReport report_of(const Line& line, const BlockSolveReport& report, BorderedReport so_far) const;

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
