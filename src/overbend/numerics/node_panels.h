/// Border rows at the few nodes of a line that have any: six equations by some columns for each of them.
#pragma once

#include <vector>

#include "base/aligned.h"
#include "numerics/line_border_kernel.h"

namespace overbend {

class NodePanels {
 public:
  NodePanels() = default;
  /// Allocates memory for all nodes, so that nothing is allocated afterwards.
  NodePanels(int nodes, int columns);

  /// Distance between rows: the number of columns, padded to a multiple of eight.
  int stride() const { return stride_; }
  bool empty() const { return first_ > last_; }
  /// Returns the panel of `node`, row-major 6 x stride; zero when first requested since `clear`.
  double* at(int node);
  void clear();
  SparsePanelView view() const { return {slot_.data(), values_.data(), first_, last_, stride_}; }

 private:
  int stride_ = 0;
  int used_ = 0;
  int first_ = 0, last_ = -1;
  std::vector<int> slot_;
  AlignedDoubles values_;
};

/// Returns the number of columns padded to whole batches of eight.
int padded_columns(int columns);

}  // namespace overbend
