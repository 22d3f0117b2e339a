#include "numerics/dense_lu.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Relative pivot threshold: a pivot this small against the terms of its entry is rounding noise, as in the blocks of a
/// line.
constexpr double kPivotFloor = 1e-14;

/// Returns the power of two that scales `size` to about one; 1 for zero.
double find_power_of_two_scale(double size) {
  return size > 0.0 && std::isfinite(size) ? std::ldexp(1.0, -std::ilogb(size)) : 1.0;
}

std::size_t to_size(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

DenseLu::DenseLu(int size)
    : size_(size),
      matrix_(to_size(size * size)),
      terms_(to_size(size * size)),
      row_scale_(to_size(size), 1.0),
      column_scale_(to_size(size), 1.0),
      exchanged_(to_size(size)) {}

void DenseLu::scale() {
  for (int i = 0; i < size_; ++i) {
    const auto row = terms_.begin() + i * size_;
    row_scale_[to_size(i)] = find_power_of_two_scale(*std::max_element(row, row + size_));
  }
  for (int j = 0; j < size_; ++j) {
    double max_term = 0.0;
    for (int i = 0; i < size_; ++i) {
      max_term = std::max(max_term, row_scale_[to_size(i)] * terms_[to_size(i * size_ + j)]);
    }
    column_scale_[to_size(j)] = find_power_of_two_scale(max_term);
  }
  for (int i = 0; i < size_; ++i) {
    for (int j = 0; j < size_; ++j) {
      matrix_[to_size(i * size_ + j)] *= row_scale_[to_size(i)] * column_scale_[to_size(j)];
    }
  }
}

int DenseLu::pivot_row(int k) const {
  int pivot = k;
  for (int i = k + 1; i < size_; ++i) {
    pivot = std::abs(matrix_[to_size(i * size_ + k)]) > std::abs(matrix_[to_size(pivot * size_ + k)]) ? i : pivot;
  }
  return pivot;
}

int DenseLu::factor() {
  scale();
  sign_ = 1;
  for (int k = 0; k < size_; ++k) {
    const int pivot = pivot_row(k);
    double* const row_k = matrix_.data() + k * size_;
    double* const row_pivot = matrix_.data() + pivot * size_;
    if (!(std::abs(row_pivot[k]) > kPivotFloor) || !std::isfinite(row_pivot[k])) {
      return k;
    }
    exchanged_[to_size(k)] = pivot;
    if (pivot != k) {
      std::swap_ranges(row_k, row_k + size_, row_pivot);
      sign_ = -sign_;
    }
    sign_ = row_k[k] < 0.0 ? -sign_ : sign_;
    for (int i = k + 1; i < size_; ++i) {
      double* const row = matrix_.data() + i * size_;
      row[k] /= row_k[k];
      for (int j = k + 1; j < size_; ++j) {
        row[j] -= row[k] * row_k[j];
      }
    }
  }
  return -1;
}

void DenseLu::solve(double* x) const {
  for (int i = 0; i < size_; ++i) {
    x[i] *= row_scale_[to_size(i)];
  }
  for (int k = 0; k < size_; ++k) {
    std::swap(x[k], x[exchanged_[to_size(k)]]);
  }
  for (int k = 0; k < size_; ++k) {
    for (int i = k + 1; i < size_; ++i) {
      x[i] -= matrix_[to_size(i * size_ + k)] * x[k];
    }
  }
  for (int i = size_ - 1; i >= 0; --i) {
    for (int j = i + 1; j < size_; ++j) {
      x[i] -= matrix_[to_size(i * size_ + j)] * x[j];
    }
    x[i] /= matrix_[to_size(i * size_ + i)];
  }
  for (int j = 0; j < size_; ++j) {
    x[j] *= column_scale_[to_size(j)];
  }
}

}  // namespace overbend
