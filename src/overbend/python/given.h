/// Validation of arguments from Python.
#pragma once

#include <pybind11/pybind11.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace overbend {

/// Argument of a bound class: rejects None and objects whose __init__ did not run. pybind11 accepts both for pointers,
/// and the latter for references, so every binding takes this. The class needs a shared_ptr as holder.
template <class T>
class Given {
 public:
  Given() = default;
  explicit Given(std::shared_ptr<T> object) : object_(std::move(object)) {}

  T& operator*() const { return *object_; }
  T* operator->() const { return object_.get(); }
  const std::shared_ptr<T>& shared() const { return object_; }

 private:
  std::shared_ptr<T> object_;
};

/// Returns the index if it is below `count`; throws IndexError otherwise.
inline std::size_t checked_index(std::size_t index, std::size_t count, const char* items) {
  if (index < count) return index;
  throw pybind11::index_error("there are " + std::to_string(count) + " " + items + ", found the index " +
                              std::to_string(index));
}

/// Returns the number of threads (0: number of cores); throws std::invalid_argument if it is out of range.
inline int checked_threads(int threads) {
  constexpr int kMaxThreads = 1024;
  if (threads >= 0 && threads <= kMaxThreads) return threads;
  throw std::invalid_argument("threads: found " + std::to_string(threads) + ", expected a number from 0 to " +
                              std::to_string(kMaxThreads));
}

/// Returns the value; throws std::invalid_argument if it is not finite or below `low`.
inline double checked_number(double value, const char* name, double low) {
  if (std::isfinite(value) && value >= low) return value;
  throw std::invalid_argument(std::string(name) + ": found " + std::to_string(value) +
                              ", expected a number of at least " + std::to_string(low));
}

}  // namespace overbend

namespace pybind11::detail {

template <class T>
struct type_caster<overbend::Given<T>> {
  using Held = make_caster<std::shared_ptr<T>>;
  PYBIND11_TYPE_CASTER(overbend::Given<T>, Held::name);

  bool load(handle source, bool convert) {
    if (source.is_none()) return false;
    Held held;
    try {
      if (!held.load(source, convert)) return false;
    } catch (const cast_error&) {  // not initialised: no holder
      return false;
    }
    value = overbend::Given<T>(cast_op<std::shared_ptr<T>&>(held));
    return true;
  }
  static handle cast(const overbend::Given<T>& argument, return_value_policy policy, handle parent) {
    return Held::cast(argument.shared(), policy, parent);
  }
};

}  // namespace pybind11::detail
