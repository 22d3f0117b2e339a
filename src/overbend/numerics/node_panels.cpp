#include "numerics/node_panels.h"

#include <algorithm>

#include "base/simd.h"

namespace overbend {

int padded_columns(int columns) {
  return (columns + kLanes - 1) / kLanes * kLanes;
}

NodePanels::NodePanels(int nodes, int columns)
    : stride_(padded_columns(columns)),
      first_(nodes),
      slot_(static_cast<std::size_t>(nodes), -1),
      values_(static_cast<std::size_t>(nodes * kNodeDofs * stride_)) {}

double* NodePanels::at(int node) {
  int& slot = slot_[static_cast<std::size_t>(node)];
  const int size = kNodeDofs * stride_;
  if (slot < 0) {
    slot = used_++;
    std::fill_n(values_.begin() + slot * size, size, 0.0);
    first_ = std::min(first_, node);
    last_ = std::max(last_, node);
  }
  return values_.data() + slot * size;
}

void NodePanels::clear() {
  std::fill(slot_.begin(), slot_.end(), -1);
  used_ = 0;
  first_ = static_cast<int>(slot_.size());
  last_ = -1;
}

}  // namespace overbend
