/// Rejects numbers that are not finite while results are visited, except those that may be missing; see
/// results/fields/result_field.h.
#pragma once

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "resultfiles/hdf5/missing_values.h"
#include "results/fields/result_field.h"

namespace overbend {

/// Visits fields; `place` is the prefix of their names.
struct FiniteVisitor {
  std::string place;

  void operator()(const ResultField& field, double value) const {
    if (std::isnan(value) && may_be_missing(field.name)) return;
    if (!std::isfinite(value)) {
      throw std::runtime_error(place + field.name + " is not a finite number; nothing is written");
    }
  }
  void operator()(const ResultField& field, const std::optional<double>& value) const {
    if (value) (*this)(field, *value);
  }
  void operator()(const ResultField& field, const Vec3& value) const {
    for (int i = 0; i < 3; ++i) (*this)(ResultField{component_name(field, i)}, value(i));
  }
  void operator()(const ResultField& field, const Mat3& value) const {
    for (int i = 0; i < 9; ++i) (*this)(field, value(i / 3, i % 3));
  }
  template <class Other>
  void operator()(const ResultField&, const Other&) const {}  // text, flags and counts are always finite
};

/// Visits whole columns, each value by its index.
struct FiniteColumns {
  std::string place;

  void operator()(const ResultField& field, const std::vector<double>& values) const {
    for (std::size_t i = 0; i < values.size(); ++i) {
      FiniteVisitor{place + "[" + std::to_string(i) + "]."}(field, values[i]);
    }
  }
};

/// Returns "name[index]".
inline std::string indexed(const std::string& name, std::size_t index) {
  return name + "[" + std::to_string(index) + "].";
}

}  // namespace overbend
