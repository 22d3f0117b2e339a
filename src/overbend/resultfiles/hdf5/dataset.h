/// One dataset of results with its attributes.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace overbend {

/// Number of values along one dimension of a dataset; HDF5's own type for it.
using Extent = unsigned long long;

struct Dataset {
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>> values;  ///< In row-major
                                                                                                  ///< order.
  std::vector<Extent> shape;                                                                      ///< Empty: a scalar.
  std::string units, description, frame;
  std::vector<std::string> scales;  ///< Path of the scale of every dimension; empty without one.
};

}  // namespace overbend
