/// Sensitivities of the results of a static analysis: plain data, SI. See docs/theory/sensitivities.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/ranges.h"

namespace overbend {

/// A number of the model file.
struct SensitivityInput {
  std::string key;   ///< "supports.stinger.boxes[2].z"
  std::string name;  ///< "supports.stinger.boxes[stinger 3].z"
  std::string text;  ///< Description of the input.
  std::string unit;  ///< SI.
  std::string show;  ///< Unit of the model file for it; empty for a plain number.
  double value = 0.0;
  double tolerance = 0.0;         ///< In both directions [unit].
  bool own_tolerance = false;     ///< True if given in the model file.
  std::vector<std::string> near;  ///< Supports whose contact opens or closes within the tolerance.
};

/// A number of the results.
struct SensitivityOutput {
  std::string name;  ///< As in summary.json: "static.sagbend.max_bending_stress".
  std::string text;  ///< "Sagbend: largest bending stress"
  std::string unit;  ///< SI.
  double value = 0.0;
  bool key = false;  ///< True for key results.
};

/// Derivative of one result with one input at constant contacts.
struct Derivative {
  double value = 0.0;
  /// Support whose contact changes first within the tolerance, if relevant; empty if the derivative holds in both
  /// directions.
  std::string support;
  bool closes = false;  ///< True if that contact closes, false if it opens.
  double until = 0.0;   ///< Value of the input at which the contact changes.
  double beyond = 0.0;  ///< Derivative beyond the change of contact.

  /// True if the derivative changes within the tolerance of the input.
  bool one_sided() const { return !support.empty(); }
};

struct SensitivityResults {
  std::vector<SensitivityInput> inputs;
  std::vector<SensitivityOutput> results;
  std::vector<Derivative> derivatives;      ///< By rows of the results, each with all inputs.
  std::vector<std::string> without_effect;  ///< Names of inputs without an effect on any of the results.
  std::vector<std::string> not_done;        ///< Names of inputs that cannot be varied continuously.
  Assumptions assumptions;
  double wall_time = 0.0;  ///< [s]

  /// Returns the derivative of a result with an input, by their indices.
  const Derivative& at(std::size_t result, std::size_t input) const {
    return derivatives[result * inputs.size() + input];
  }
  /// Returns the change of the result when the input increases (`side` 1) or decreases (-1) by its tolerance; beyond a
  /// change of contact with the derivative there.
  double effect(std::size_t result, std::size_t input, double side) const {
    const Derivative& slope = at(result, input);
    const double distance = side * (slope.until - inputs[input].value), tolerance = inputs[input].tolerance;
    if (!slope.one_sided() || distance < 0.0 || distance >= tolerance) return side * slope.value * tolerance;
    return side * (slope.value * distance + slope.beyond * (tolerance - distance));
  }
  /// Returns the larger magnitude of both directions.
  double max_effect(std::size_t result, std::size_t input) const {
    return std::max(std::abs(effect(result, input, 1.0)), std::abs(effect(result, input, -1.0)));
  }
  /// Returns the inputs whose tolerance has the largest effect on the result, at most `count`; none without an effect.
  std::vector<std::size_t> most_influential_inputs(std::size_t result, std::size_t count) const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (max_effect(result, i) > 0.0) order.push_back(i);
    }
    ranges::stable_sort(order, std::greater(), [&](std::size_t i) { return max_effect(result, i); });
    if (order.size() > count) order.resize(count);
    return order;
  }
};

}  // namespace overbend
