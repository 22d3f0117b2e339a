/// What the results of a static analysis hang on: plain data, SI. docs/theory/sensitivities.md
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/assumption.h"

namespace overbend {

/// A number of the model file.
struct SensitivityInput {
  std::string key;   ///< "supports.stinger.boxes[2].z"
  std::string name;  ///< "supports.stinger.boxes[stinger 3].z"
  std::string text;  ///< What it is.
  std::string unit;  ///< SI.
  std::string show;  ///< Unit of the model file for it; empty for a plain number.
  double value = 0.0;
  double tolerance = 0.0;         ///< Either way.
  bool own_tolerance = false;     ///< Given in the model file.
  std::vector<std::string> near;  ///< Supports that open or close within the tolerance.
};

/// A number of the results.
struct SensitivityOutput {
  std::string name;  ///< As in summary.json: "static.sagbend.max_bending_stress".
  std::string text;  ///< "Sagbend: largest bending stress"
  std::string unit;  ///< SI.
  double value = 0.0;
  bool key = false;  ///< One of those that are looked at first.
};

/// Of one result by one input, where the contacts stay as they are.
struct Derivative {
  double value = 0.0;
  /// The support whose contact changes first within the tolerance, where that counts; empty where it holds either way.
  std::string support;
  bool closes = false;  ///< That contact closes; else it opens.
  double until = 0.0;   ///< Value of the input at which it changes.
  double beyond = 0.0;  ///< The derivative on the other side.

  bool one_sided() const { return !support.empty(); }
};

struct SensitivityResults {
  std::vector<SensitivityInput> inputs;
  std::vector<SensitivityOutput> results;
  std::vector<Derivative> derivatives;      ///< Row by row of the results, each with all inputs.
  std::vector<std::string> without_effect;  ///< Names of inputs on which none of the results hangs.
  std::vector<std::string> not_done;        ///< Of those that cannot be changed a little.
  Assumptions assumptions;
  double wall_time = 0.0;  ///< [s]

  const Derivative& at(std::size_t result, std::size_t input) const {
    return derivatives[result * inputs.size() + input];
  }
  /// How far the result goes when the input goes up (`side` 1) or down (-1) by its tolerance; beyond a contact that
  /// changes with the derivative there.
  double effect(std::size_t result, std::size_t input, double side) const {
    const Derivative& slope = at(result, input);
    const double way = side * (slope.until - inputs[input].value), tolerance = inputs[input].tolerance;
    if (!slope.one_sided() || way < 0.0 || way >= tolerance) return side * slope.value * tolerance;
    return side * (slope.value * way + slope.beyond * (tolerance - way));
  }
  /// The larger of both.
  double largest_effect(std::size_t result, std::size_t input) const {
    return std::max(std::abs(effect(result, input, 1.0)), std::abs(effect(result, input, -1.0)));
  }
  /// The inputs whose tolerance moves the result most, at most `count`; none that does not move it.
  std::vector<std::size_t> foremost(std::size_t result, std::size_t count) const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (largest_effect(result, i) > 0.0) order.push_back(i);
    }
    std::ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return largest_effect(result, i); });
    if (order.size() > count) order.resize(count);
    return order;
  }
};

}  // namespace overbend
