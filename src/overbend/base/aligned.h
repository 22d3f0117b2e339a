/// Storage aligned to a cache line, so that a row or a batch of eight doubles is one aligned vector.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace overbend {

inline constexpr std::size_t kLineBytes = 64;

template <class T>
struct AlignedAllocator {
  using value_type = T;

  AlignedAllocator() = default;
  template <class U>
  explicit AlignedAllocator(const AlignedAllocator<U>&) noexcept {}

  T* allocate(std::size_t n) { return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{kLineBytes})); }
  void deallocate(T* p, std::size_t) noexcept { ::operator delete (p, std::align_val_t{kLineBytes}); }
  bool operator==(const AlignedAllocator&) const = default;
};

using AlignedDoubles = std::vector<double, AlignedAllocator<double>>;

}  // namespace overbend
