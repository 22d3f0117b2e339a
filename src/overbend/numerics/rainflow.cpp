#include "numerics/rainflow.h"

#include <limits>
#include <stdexcept>

namespace overbend {
namespace {

double number_at(std::span<const double> saved, std::size_t position) {
  if (position >= saved.size()) throw std::out_of_range("the saved rainflow count is too short");
  return saved[position];
}

}  // namespace

RainflowCycle RainflowStack::make_room() {
  const auto cube = [&](std::size_t i) { return std::pow(std::abs(points_[i + 1] - points_[i]), 3.0); };
  std::size_t min_index = 0;
  double min_change = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 2 < depth_; ++i) {
    const double change = cube(i) - cube(i + 1);  // proportional to the added damage
    if (change < min_change) {
      min_index = i;
      min_change = change;
    }
  }
  const RainflowCycle taken = cycle(points_[min_index], points_[min_index + 1], 1.0);
  std::copy(points_.begin() + static_cast<std::ptrdiff_t>(min_index) + 3,
            points_.begin() + static_cast<std::ptrdiff_t>(depth_),
            points_.begin() + static_cast<std::ptrdiff_t>(min_index) + 1);
  depth_ -= 2;
  return taken;
}

void RainflowStack::save(std::vector<double>& out) const {
  out.push_back(static_cast<double>(depth_));
  out.insert(out.end(), points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(depth_));
}

void RainflowStack::restore(std::span<const double> saved, std::size_t& position) {
  const double depth = number_at(saved, position++);
  if (!(depth >= 0.0 && depth <= static_cast<double>(kCapacity))) {
    throw std::out_of_range("the saved rainflow count has an invalid depth");
  }
  depth_ = static_cast<std::size_t>(depth);
  for (std::size_t i = 0; i < depth_; ++i) points_[i] = number_at(saved, position++);
}

RainflowCounter::RainflowCounter(std::size_t records, double hysteresis)
    : hysteresis_(hysteresis), extreme_(records, 0.0), direction_(records, 1.0), stacks_(records) {}

void RainflowCounter::start(std::span<const double> values) {
  started_ = true;
  for (std::size_t i = 0; i < extreme_.size(); ++i) {
    extreme_[i] = values[i];
    stacks_[i].start(values[i]);
  }
}

std::size_t RainflowCounter::deepest() const {
  std::size_t max_count = 0;
  for (const RainflowStack& stack : stacks_) max_count = std::max(max_count, stack.depth());
  return max_count;
}

std::vector<double> RainflowCounter::save() const {
  std::vector<double> out = {started_ ? 1.0 : 0.0, static_cast<double>(extreme_.size())};
  out.insert(out.end(), extreme_.begin(), extreme_.end());
  out.insert(out.end(), direction_.begin(), direction_.end());
  for (const RainflowStack& stack : stacks_) stack.save(out);
  return out;
}

void RainflowCounter::restore(std::span<const double> saved) {
  const std::size_t records = extreme_.size();
  if (number_at(saved, 1) != static_cast<double>(records)) {
    throw std::out_of_range("the saved rainflow count has a different number of records");
  }
  started_ = saved[0] > 0.0;
  number_at(saved, 2 * records + 1);
  const auto begin = saved.begin() + 2;
  const auto count = static_cast<std::ptrdiff_t>(records);
  std::copy(begin, begin + count, extreme_.begin());
  std::copy(begin + count, begin + 2 * count, direction_.begin());
  std::size_t position = 2 + 2 * records;
  for (RainflowStack& stack : stacks_) stack.restore(saved, position);
  if (position != saved.size()) throw std::out_of_range("the saved rainflow count is too long");
}

}  // namespace overbend
