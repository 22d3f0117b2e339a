/// Random numbers that are identical on every machine and with every compiler.
///
/// The standard library fixes its engines but not its distributions; here both are fixed. The generator is xoshiro256++
/// [blackman2021], its state filled from one seed by splitmix64 [steele2014], as its authors advise. Only integer
/// operations and exact conversions are used.
#pragma once

#include <array>
#include <cstdint>

namespace overbend {

/// Returns the next number of splitmix64 and advances `state`.
std::uint64_t splitmix64(std::uint64_t& state);

class Random {
 public:
  using State = std::array<std::uint64_t, 4>;

  explicit Random(std::uint64_t seed);
  /// Starts from a state of the generator, which must not be all zeros.
  explicit Random(const State& state) : state_(state) {}

  /// Returns the next 64 bits.
  std::uint64_t bits();

  /// Returns a uniform number in [0, 1): the upper 53 bits times 2^-53, exactly.
  double uniform();

  /// Returns a uniform integer in 0 ... count - 1; `count` at least 1.
  std::uint64_t below(std::uint64_t count);

 private:
  State state_;
};

}  // namespace overbend
