/// Made-up input for kernels, and what is printed of what they make of it.
#pragma once

#include <cstdint>
#include <cstdio>
#include <vector>

#include "base/simd.h"

namespace overbend {

/// The same numbers on every machine: a linear congruence, of which 53 bits are exact in a double.
class Numbers {
 public:
  double between(double low, double high) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return low + (high - low) * static_cast<double>(state_ >> 11) / 9007199254740992.0;
  }

 private:
  std::uint64_t state_ = 20;
};

/// Doubles at a place that any register may be loaded from.
class Batch {
 public:
  explicit Batch(int count) : held_(static_cast<std::size_t>(count + kLanes)) {
    const auto address = reinterpret_cast<std::uintptr_t>(held_.data());
    at_ = held_.data() + (64 - address % 64) % 64 / sizeof(double);
    count_ = count;
  }
  Batch(const Batch& second_batch) : Batch(second_batch.count_) {
    for (int i = 0; i < count_; ++i) {
      at_[i] = second_batch.at_[i];
    }
  }
  Batch& operator=(const Batch&) = delete;
  Batch& fill(Numbers& numbers, double low, double high, int used = -1) {
    for (int i = 0; i < (used < 0 ? count_ : used); ++i) {
      at_[i] = numbers.between(low, high);
    }
    return *this;
  }
  double* data() const { return at_; }
  void print(const char* name) const {
    for (int i = 0; i < count_; ++i) {
      std::printf("%s %.17g\n", name, at_[i]);
    }
  }

 private:
  std::vector<double> held_;
  double* at_;
  int count_;
};

/// Arrays of `padded` numbers, of which `used` are not nothing, that stay where they are.
class Arrays {
 public:
  Arrays(Numbers& numbers, int used, int padded) : numbers_(numbers), used_(used), padded_(padded) {
    kept_.reserve(32);
  }
  const double* of(double low, double high, double beyond = 0.0) {
    Batch& made = kept_.emplace_back(padded_);
    for (int i = used_; i < padded_; ++i) {
      made.data()[i] = beyond;
    }
    return made.fill(numbers_, low, high, used_).data();
  }

 private:
  Numbers& numbers_;
  int used_, padded_;
  std::vector<Batch> kept_;
};

/// Results of the kernels of statistics and recording.
void print_recording(Numbers& numbers);

}  // namespace overbend
