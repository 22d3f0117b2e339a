#include "study/sensitivity/sensitivities.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/interruption.h"
#include "base/ranges.h"
#include "base/shown_unit.h"
#include "model/vessel/mooring_queries.h"
#include "modelfile/binding/model_inputs.h"
#include "modelfile/binding/tolerances.h"
#include "study/sensitivity/contact_transitions.h"
#include "study/sensitivity/result_values.h"
#include "study/sensitivity/sensitivity_lay.h"

namespace overbend {
namespace {

/// Step of an input: large enough against rounding, small enough for a derivative: positions by 0.01 mm, angles by the
/// value that moves a box by as much, others by a factor of 1e-5.
double difference_step(const ModelInput& input) {
  constexpr double kPlace = 1e-5, kAngle = 1e-7, kRelative = 1e-5;
  const double size = std::abs(input.value);
  if (is_place(input)) return kPlace;
  if (input.unit == "m") return size > 0.0 ? std::min(kPlace, kRelative * size) : 0.1 * kPlace;
  if (input.unit == "rad") return kAngle;
  if (size > 0.0) return kRelative * size;
  return input.unit.starts_with("N") || input.unit == "Pa" ? 1e-2 : 1e-6;
}

/// Number of shorter steps, each a tenth of the previous one, tried if a contact changes within the step.
constexpr int kMaxReductions = 3;

/// Derivatives of all results and of the rollers by one input.
struct Slopes {
  std::vector<double> results;
  std::vector<ContactSlope> contacts;
};

/// Derivatives of results over a pair `step` apart in both directions; empty if a result exists on one side only.
std::vector<double> result_slopes(const ResultPair& pair, double step, const std::vector<ResultValue>& reference) {
  const std::vector<ResultValue> low = result_values(pair.before), high = result_values(pair.after);
  if (low.size() != reference.size() || high.size() != reference.size()) return {};
  std::vector<double> slopes;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    if (low[i].name != reference[i].name || high[i].name != reference[i].name) return {};
    slopes.push_back((high[i].value - low[i].value) / (2.0 * step));
    if (!std::isfinite(slopes.back())) return {};
  }
  return slopes;
}

/// True if any derivative exceeds the rounding of its result over the step.
bool noticeable(const std::vector<double>& slopes, double step, const std::vector<ResultValue>& reference) {
  constexpr double kRounding = 1e-10;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    if (std::abs(slopes[i]) * step > kRounding * std::max(std::abs(reference[i].value), 1e-6)) return true;
  }
  return false;
}

class Sensitivities {
 public:
  Sensitivities(const Model& model, const StaticSolution& solution, const SensitivityRequest& request)
      : request_(request),
        lay_(model, solution),
        values_(model.description),
        tolerances_(input_tolerances(values_.root(), values_.inputs())),
        at_(result_values(lay_.results())),
        contacts_(lay_) {}

  bool regular() const { return lay_.regular(); }

  SensitivityResults find() {
    for (std::size_t i = 0; i < values_.inputs().size(); ++i) {
      check_interruption();
      if (is_wanted(values_.inputs()[i])) evaluate_input(i);
    }
    return gathered();
  }

 private:
  bool is_wanted(const ModelInput& input) const {
    const auto named = [&](const std::string& key) { return key == input.key || key == input.name; };
    return request_.keys.empty() || ranges::any_of(request_.keys, named);
  }

  std::optional<ResultPair> follow(const ModelInput& input, double step) {
    return lay_.neighbouring_equilibria(values_.with(input, input.value - step),
                                        values_.with(input, input.value + step));
  }

  void evaluate_input(std::size_t i) {
    const ModelInput& input = values_.inputs()[i];
    double step = difference_step(input);
    std::optional<ResultPair> pair = follow(input, step);
    for (int k = 0; k < kMaxReductions && pair && !contacts_.stay(*pair); ++k) {
      step *= 0.1;
      pair = follow(input, step);
    }
    Slopes slopes;
    if (pair) slopes.results = result_slopes(*pair, step, at_);
    if (slopes.results.empty()) {
      found_.not_done.push_back(input.name);
    } else if (request_.keys.empty() && !noticeable(slopes.results, step, at_)) {
      found_.without_effect.push_back(input.name);
    } else {
      if (request_.one_sided) slopes.contacts = contacts_.contact_slopes(*pair, step);
      add(i, slopes);
    }
  }

  void add(std::size_t i, const Slopes& slopes) {
    const ModelInput& input = values_.inputs()[i];
    const InputTolerance& tolerance = tolerances_[i];
    SensitivityInput& added = found_.inputs.emplace_back();
    added = {input.key,   input.name,      input.text,      input.unit, input.show,
             input.value, tolerance.value, tolerance.given, {}};
    std::vector<Derivative>& column = columns_.emplace_back();
    for (const double slope : slopes.results) column.push_back({slope, {}, false, 0.0, 0.0});
    contacts_.mark(slopes.contacts, at_, added, column);
  }

  SensitivityResults gathered() {
    for (const ResultValue& value : at_) {
      found_.results.push_back({value.name, value.text, value.unit, value.value, value.key});
    }
    for (std::size_t r = 0; r < at_.size(); ++r) {
      for (const std::vector<Derivative>& column : columns_) found_.derivatives.push_back(column[r]);
    }
    return std::move(found_);
  }

  const SensitivityRequest& request_;
  SensitivityLay lay_;
  ModelValues values_;
  std::vector<InputTolerance> tolerances_;
  std::vector<ResultValue> at_;
  ContactTransitions contacts_;
  std::vector<std::vector<Derivative>> columns_;  ///< By input.
  SensitivityResults found_;
};

void add_assumptions(const Model& model, SensitivityResults& results) {
  results.assumptions.push_back({AssumptionRank::other,
                                 "Sensitivities keep the mesh and the contacts fixed; derivatives are by the numbers "
                                 "of the model file, one at a time."});
  if (finds_vessel_position(model.description)) {
    results.assumptions.push_back(
        {AssumptionRank::other,
         "Sensitivities keep the vessel fixed; its moorings or positioning would let it follow."});
  }
  const bool all_given =
      ranges::all_of(results.inputs, [](const SensitivityInput& input) { return input.own_tolerance; });
  if (!all_given) {
    results.assumptions.push_back(
        {AssumptionRank::other, fmt::format("Unless given in sensitivities.tolerances, the tolerance is {} for "
                                            "positions, 0.1 deg for angles and 1 % for other inputs.",
                                            shown_digits(0.01, section_length(), 3))});
  }
}

}  // namespace

std::optional<SensitivityResults> find_sensitivities(const Model& model, const StaticSolution& solution,
                                                     const SensitivityRequest& request) {
  const auto begin = std::chrono::steady_clock::now();
  Sensitivities sensitivities(model, solution, request);
  if (!sensitivities.regular()) return std::nullopt;
  SensitivityResults results = sensitivities.find();
  add_assumptions(model, results);
  results.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return results;
}

std::optional<std::vector<double>> jacobian(const Model& model, const StaticSolution& solution,
                                            const std::vector<std::string>& results,
                                            const std::vector<std::string>& keys) {
  const auto found = find_sensitivities(model, solution, {keys, false});
  if (!found) return std::nullopt;
  std::vector<double> rows;
  for (const std::string& name : results) {
    const auto result = ranges::find(found->results, name, &SensitivityOutput::name);
    if (result == found->results.end()) return std::nullopt;
    for (const std::string& key : keys) {
      const auto input = ranges::find_if(found->inputs, [&](const SensitivityInput& candidate) {
        return candidate.key == key || candidate.name == key;
      });
      if (input == found->inputs.end()) return std::nullopt;
      rows.push_back(found
                         ->at(static_cast<std::size_t>(result - found->results.begin()),
                              static_cast<std::size_t>(input - found->inputs.begin()))
                         .value);
    }
  }
  return rows;
}

}  // namespace overbend
