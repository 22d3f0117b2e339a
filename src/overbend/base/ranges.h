/// Algorithms on whole ranges, as `ranges::find(list, value)`: those of std::ranges, or functions with their meaning
/// where the standard library lacks them (libc++ before 15, that of emscripten 3.1.6).
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <type_traits>

#if !defined(_LIBCPP_VERSION) || _LIBCPP_VERSION >= 15000

namespace overbend {
namespace ranges = std::ranges;
}  // namespace overbend

#else

namespace overbend::ranges {

/// Compares two elements by `compare` of their projections.
template <class Compare, class Projection>
auto by(Compare compare, Projection projection) {
  return [compare, projection](const auto& a, const auto& b) -> bool {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  };
}

template <class Predicate, class Projection>
auto of(Predicate predicate, Projection projection) {
  return [predicate, projection](auto&& element) -> bool {
    return std::invoke(predicate, std::invoke(projection, element));
  };
}

template <class Range, class Predicate, class Projection = std::identity>
constexpr auto find_if(Range&& range, Predicate predicate, Projection projection = {}) {
  auto it = std::begin(range);
  while (it != std::end(range) && !std::invoke(predicate, std::invoke(projection, *it))) ++it;
  return it;
}

template <class Range, class Value, class Projection = std::identity>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
  auto it = std::begin(range);
  while (it != std::end(range) && !(std::invoke(projection, *it) == value)) ++it;
  return it;
}

template <class Range, class Predicate, class Projection = std::identity>
constexpr bool any_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return ranges::find_if(range, predicate, projection) != std::end(range);
}

template <class Range, class Predicate, class Projection = std::identity>
constexpr bool none_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return !ranges::any_of(range, predicate, projection);
}

template <class Range, class Predicate, class Projection = std::identity>
constexpr bool all_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return ranges::none_of(range, std::not_fn(predicate), projection);
}

template <class Range, class Predicate, class Projection = std::identity>
constexpr auto count_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::count_if(std::begin(range), std::end(range), ranges::of(predicate, projection));
}

template <class Range, class Value, class Projection = std::identity>
constexpr auto count(Range&& range, const Value& value, Projection projection = {}) {
  return ranges::count_if(
      range, [&](const auto& element) { return element == value; }, projection);
}

template <class Range, class Compare = std::less<>, class Projection = std::identity>
void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), ranges::by(compare, projection));
}

template <class Range, class Compare = std::less<>, class Projection = std::identity>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), ranges::by(compare, projection));
}

template <class Range, class Iterator, class Compare = std::less<>, class Projection = std::identity>
void nth_element(Range&& range, Iterator nth, Compare compare = {}, Projection projection = {}) {
  std::nth_element(std::begin(range), nth, std::end(range), ranges::by(compare, projection));
}

template <class Range, class Value, class Compare = std::less<>, class Projection = std::identity>
constexpr auto lower_bound(Range&& range, const Value& value, Compare compare = {}, Projection projection = {}) {
  const auto before = [&](const auto& element, const auto& sought) -> bool {
    return std::invoke(compare, std::invoke(projection, element), sought);
  };
  return std::lower_bound(std::begin(range), std::end(range), value, before);
}

template <class Range, class Value, class Compare = std::less<>, class Projection = std::identity>
constexpr auto upper_bound(Range&& range, const Value& value, Compare compare = {}, Projection projection = {}) {
  const auto before = [&](const auto& sought, const auto& element) -> bool {
    return std::invoke(compare, sought, std::invoke(projection, element));
  };
  return std::upper_bound(std::begin(range), std::end(range), value, before);
}

template <class Range, class Compare = std::less<>, class Projection = std::identity>
constexpr auto min_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::min_element(std::begin(range), std::end(range), ranges::by(compare, projection));
}

/// The first of equals, as std::ranges::max_element.
template <class Range, class Compare = std::less<>, class Projection = std::identity>
constexpr auto max_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::max_element(std::begin(range), std::end(range), ranges::by(compare, projection));
}

template <class Range, class Compare = std::less<>, class Projection = std::identity>
constexpr auto min(Range&& range, Compare compare = {}, Projection projection = {}) {
  return *ranges::min_element(range, compare, projection);
}

template <class Range, class Compare = std::less<>, class Projection = std::identity>
constexpr auto max(Range&& range, Compare compare = {}, Projection projection = {}) {
  return *ranges::max_element(range, compare, projection);
}

template <class Value>
struct MinMax {
  Value min, max;
};

template <class Range, class Compare = std::less<>, class Projection = std::identity>
constexpr auto minmax_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  const auto pair = std::minmax_element(std::begin(range), std::end(range), ranges::by(compare, projection));
  return MinMax<std::decay_t<decltype(pair.first)> >{pair.first, pair.second};
}

template <class Range, class Compare = std::less<>, class Projection = std::identity>
constexpr auto minmax(Range&& range, Compare compare = {}, Projection projection = {}) {
  const auto found = ranges::minmax_element(range, compare, projection);
  return MinMax<std::decay_t<decltype(*found.min)> >{*found.min, *found.max};
}

template <class Range, class Value>
constexpr void replace(Range&& range, const Value& old_value, const Value& new_value) {
  std::replace(std::begin(range), std::end(range), old_value, new_value);
}

template <class Range, class Value>
constexpr void fill(Range&& range, const Value& value) {
  std::fill(std::begin(range), std::end(range), value);
}

template <class Range>
constexpr void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}

template <class Range, class Output>
constexpr void copy(Range&& range, Output output) {
  std::copy(std::begin(range), std::end(range), output);
}

template <class Range, class Output, class Predicate, class Projection = std::identity>
constexpr void copy_if(Range&& range, Output output, Predicate predicate, Projection projection = {}) {
  std::copy_if(std::begin(range), std::end(range), output, ranges::of(predicate, projection));
}

template <class Range, class Output>
constexpr void move(Range&& range, Output output) {
  std::move(std::begin(range), std::end(range), output);
}

template <class Range, class Output, class Function, class Projection = std::identity>
constexpr void transform(Range&& range, Output output, Function function, Projection projection = {}) {
  for (auto&& element : range) *output++ = std::invoke(function, std::invoke(projection, element));
}

template <class Range, class Second, class Equal = std::equal_to<> >
constexpr bool equal(Range&& range, Second&& second, Equal equal = {}) {
  return std::equal(std::begin(range), std::end(range), std::begin(second), std::end(second), equal);
}

template <class Range, class Equal = std::equal_to<> >
constexpr auto adjacent_find(Range&& range, Equal equal = {}) {
  return std::adjacent_find(std::begin(range), std::end(range), equal);
}

}  // namespace overbend::ranges

#endif
