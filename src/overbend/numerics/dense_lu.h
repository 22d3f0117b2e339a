/// A small dense system: some dozens of unknowns of mixed units.
#pragma once

#include <vector>

namespace overbend {

/// LU factors with partial pivoting of a square matrix whose rows and columns are first scaled by powers of two, so
/// that neither the pivots nor the verdict depend on units. Nothing is allocated after construction.
class DenseLu {
 public:
  explicit DenseLu(int size = 0);

  int size() const { return size_; }
  /// The matrix to be factored, row-major; `factor` overwrites it.
  double* matrix() { return matrix_.data(); }
  /// Size of the terms each entry is a sum of, row-major. A pivot that is rounding of them is none.
  double* terms() { return terms_.data(); }

  /// Returns the first unknown without a pivot, -1 if there is none.
  int factor();
  /// Replaces `x` by the solution for it as right-hand side.
  void solve(double* x) const;
  /// Sign of the determinant of the factored matrix.
  int sign() const { return sign_; }

 private:
  void scale();
  int pivot_row(int k) const;

  int size_ = 0;
  int sign_ = 1;
  std::vector<double> matrix_, terms_, row_scale_, column_scale_;
  std::vector<int> exchanged_;
};

}  // namespace overbend
