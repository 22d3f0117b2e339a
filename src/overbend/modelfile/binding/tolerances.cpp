#include "modelfile/binding/tolerances.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/constants.h"
#include "base/result_path.h"
#include "base/text.h"
#include "base/units.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {
namespace {

constexpr double kOfPlace = 0.01, kOfAngle = 0.1 * kDegree, kOfValue = 0.01;

bool matches(const std::string& pattern, const ModelInput& input) {
  return matches_pattern(pattern, input.key) || matches_pattern(pattern, input.name);
}

struct ToleranceReading {
  std::optional<double> value;
  std::string found;
};

ToleranceReading read_tolerance(const std::string& text, const ModelInput& input) {
  const std::string_view trimmed = trim(text);
  if (trimmed.ends_with('%')) {
    const std::optional<double> percent = parse_number(trim(trimmed.substr(0, trimmed.size() - 1)));
    if (percent) return {1e-2 * *percent * std::abs(input.value), {}};
    return {std::nullopt, "'" + for_display(text) + "'"};
  }
  if (input.unit != "1") {
    const QuantityReading reading = parse_quantity(trimmed, input.unit);
    return {reading.value, reading.found};
  }
  return {parse_number(trimmed), "'" + for_display(text) + "'"};
}

const std::vector<FieldValue>& entries(const FieldValue& root) {
  static const std::vector<FieldValue> kNone;
  const FieldValue* group = root.find("sensitivities.tolerances");
  return group != nullptr && group->kind == FieldValue::Kind::map ? group->children : kNone;
}

std::string expected_for(const ModelInput& input) {
  return input.unit == "1" ? "a number or per cent, such as 2 %"
                           : dimension_phrase(input.unit) + " such as " +
                                 format_quantity(default_tolerance(input), input.unit, input.show) + ", or per cent";
}

void check_entry(Checker& check, const FieldValue& entry, const std::vector<ModelInput>& inputs) {
  bool any = false;
  for (const ModelInput& input : inputs) {
    if (!matches(entry.key, input)) continue;
    any = true;
    const ToleranceReading reading = read_tolerance(entry.text, input);
    if (!reading.value) {
      check.error(entry, reading.found, expected_for(input), "it is for " + input.name);
      return;
    }
    if (!(*reading.value >= 0.0)) {
      check.error(entry, entry.shown, "a tolerance that is not negative");
      return;
    }
  }
  if (any) return;
  std::vector<std::string> names;
  for (const ModelInput& input : inputs) names.push_back(input.name);
  const std::string near = nearest_word(entry.key, names);
  check.error(entry, "the tolerance of a key that is not in this file",
              "a number in this file, such as " + (names.empty() ? std::string("tensioner.tension") : names.front()),
              near.empty() ? "'*' matches any characters: supports.*.boxes[*].z" : "did you mean '" + near + "'?");
}

}  // namespace

bool is_place(const ModelInput& input) {
  const std::string last = input.key.substr(input.key.find_last_of('.') + 1);
  return input.unit == "m" && (last == "x" || last == "y" || last == "z" || last == "offset");
}

double default_tolerance(const ModelInput& input) {
  if (is_place(input)) return kOfPlace;
  return input.unit == "rad" ? kOfAngle : kOfValue * std::abs(input.value);
}

std::vector<InputTolerance> input_tolerances(const FieldValue& root, const std::vector<ModelInput>& inputs) {
  std::vector<InputTolerance> tolerances;
  for (const ModelInput& input : inputs) {
    InputTolerance& tolerance = tolerances.emplace_back(InputTolerance{default_tolerance(input), false});
    for (const FieldValue& entry : entries(root)) {
      if (!matches(entry.key, input)) continue;
      if (const auto value = read_tolerance(entry.text, input).value) tolerance = {*value, true};
    }
  }
  return tolerances;
}

void check_tolerances(const FieldValue& root, const std::string& file, Diagnostics& diagnostics) {
  Checker check(root, file, diagnostics);
  if (entries(root).empty()) return;
  const std::vector<ModelInput> inputs = numeric_inputs(root);
  for (const FieldValue& entry : entries(root)) check_entry(check, entry, inputs);
}

}  // namespace overbend
