/// Small dense linear system: some dozens of unknowns of mixed units.
#pragma once

#include <vector>

namespace overbend {

/// LU factors with partial pivoting of a square matrix whose rows and columns are first scaled by powers of two, so
/// that neither pivots nor singularity tests depend on units. Nothing is allocated after construction.
class DenseLu {
 public:
  explicit DenseLu(int size = 0);

  int size() const { return size_; }
  /// The matrix to be factored, row-major; `factor` overwrites it.
  double* matrix() { return matrix_.data(); }
  /// Magnitude of the terms summed in each entry, row-major. A pivot at the rounding level of these terms counts as
  /// zero.
  double* terms() { return terms_.data(); }

  /// Returns the first unknown without a pivot, -1 if there is none.
  int factor();
  /// Replaces the right-hand side `x` by the solution.
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
