#include "system/node_extremes.h"

namespace overbend {
namespace {

struct ExtremesKernels {
  double (*triple)(const double* values, const double* shares, int count);
  LargestChanges (*changes)(const double* now, const double* then, int count);
};

ExtremesKernels kernels_for(Isa isa) {
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) {
    return {isa_avx512::largest_triple, isa_avx512::largest_changes};
  }
  if (isa == Isa::avx2) {
    return {isa_avx2::largest_triple, isa_avx2::largest_changes};
  }
#endif
  (void)isa;
  return {isa_baseline::largest_triple, isa_baseline::largest_changes};
}

}  // namespace

double largest_triple(std::span<const double> values, std::span<const double> shares, Isa isa) {
  return kernels_for(isa).triple(values.data(), shares.data(), static_cast<int>(values.size()));
}

LargestChanges largest_changes(std::span<const double> now, std::span<const double> then, Isa isa) {
  return kernels_for(isa).changes(now.data(), then.data(), static_cast<int>(now.size()));
}

}  // namespace overbend
