/// The largest among what a line has at its nodes, six numbers each: a place and a tangent, or a force and a moment.
/// Compiled once per instruction set.
#pragma once

namespace overbend {

/// Of how the six numbers of the nodes changed: the largest square of each, over all nodes.
struct LargestChanges {
  double squares[6];
};

namespace isa_baseline {
double largest_triple(const double* values, const double* shares, int count);
LargestChanges largest_changes(const double* now, const double* then, int count);
}  // namespace isa_baseline
namespace isa_avx2 {
double largest_triple(const double* values, const double* shares, int count);
LargestChanges largest_changes(const double* now, const double* then, int count);
}  // namespace isa_avx2
namespace isa_avx512 {
double largest_triple(const double* values, const double* shares, int count);
LargestChanges largest_changes(const double* now, const double* then, int count);
}  // namespace isa_avx512

}  // namespace overbend
