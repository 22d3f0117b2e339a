/// The largest among what a line has at its nodes, found in registers of a chosen instruction set.
#pragma once

#include <span>

#include "base/simd.h"
#include "system/node_extremes_kernel.h"

namespace overbend {

/// The largest of (x^2 + y^2 + z^2) times a share, over the triples of `values` (x, y, z and so on): infinite where a
/// value is not finite. `shares` has as many numbers: that of a triple stands first, with two zeros after it.
double largest_triple(std::span<const double> values, std::span<const double> shares, Isa isa = best_isa());

/// How six numbers a node changed from `then` to `now`, which both have six for every node.
LargestChanges largest_changes(std::span<const double> now, std::span<const double> then, Isa isa = best_isa());

}  // namespace overbend
