#include "study/sensitivity/sensitivities.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/interruption.h"
#include "base/shown_unit.h"
#include "model/vessel/station.h"
#include "modelfile/binding/model_inputs.h"
#include "modelfile/binding/tolerances.h"
#include "study/sensitivity/near_contacts.h"
#include "study/sensitivity/result_values.h"
#include "study/sensitivity/sensitivity_lay.h"

namespace overbend {
namespace {

/// Large enough for rounding, small enough for a derivative: places by a hundredth of a millimetre, angles by what
/// moves a box by as much, the rest by a hundred-thousandth.
double step_of(const ModelInput& input) {
  constexpr double kPlace = 1e-5, kAngle = 1e-7, kRelative = 1e-5;
  const double size = std::abs(input.value);
  if (is_place(input)) return kPlace;
  if (input.unit == "m") return size > 0.0 ? std::min(kPlace, kRelative * size) : 0.1 * kPlace;
  if (input.unit == "rad") return kAngle;
  if (size > 0.0) return kRelative * size;
  return input.unit.starts_with("N") || input.unit == "Pa" ? 1e-2 : 1e-6;
}

/// Shorter steps are taken where a contact changes on the way, each a tenth of that before.
constexpr int kShorter = 3;

/// Derivatives of all results by one input, and of the rollers.
struct Slopes {
  std::vector<double> results;
  std::vector<ContactSlope> contacts;
};

/// Over `step` either way; empty where a result comes or goes on the way.
std::vector<double> slopes_of(const ResultPair& pair, double step, const std::vector<ResultValue>& at) {
  const std::vector<ResultValue> low = result_values(pair.before), high = result_values(pair.after);
  if (low.size() != at.size() || high.size() != at.size()) return {};
  std::vector<double> slopes;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (low[i].name != at[i].name || high[i].name != at[i].name) return {};
    slopes.push_back((high[i].value - low[i].value) / (2.0 * step));
    if (!std::isfinite(slopes.back())) return {};
  }
  return slopes;
}

/// Rounding of a result over the step: a slope below it is none.
bool noticeable(const std::vector<double>& slopes, double step, const std::vector<ResultValue>& at) {
  constexpr double kRounding = 1e-10;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (std::abs(slopes[i]) * step > kRounding * std::max(std::abs(at[i].value), 1e-6)) return true;
  }
  return false;
}

class Sensitivities {
 public:
  Sensitivities(const Model& model, const StaticSolution& solution, const SensitivityWish& wish)
      : wish_(wish),
        lay_(model, solution),
        values_(model.description),
        tolerances_(input_tolerances(values_.root(), values_.inputs())),
        at_(result_values(lay_.results())),
        contacts_(lay_) {}

  bool regular() const { return lay_.regular(); }

  SensitivityResults find() {
    for (std::size_t i = 0; i < values_.inputs().size(); ++i) {
      check_interruption();
      if (is_wanted(values_.inputs()[i])) look_at(i);
    }
    return gathered();
  }

 private:
  bool is_wanted(const ModelInput& input) const {
    const auto named = [&](const std::string& key) { return key == input.key || key == input.name; };
    return wish_.keys.empty() || std::ranges::any_of(wish_.keys, named);
  }

  std::optional<ResultPair> follow(const ModelInput& input, double step) {
    return lay_.follow(values_.with(input, input.value - step), values_.with(input, input.value + step));
  }

  void look_at(std::size_t i) {
    const ModelInput& input = values_.inputs()[i];
    double step = step_of(input);
    std::optional<ResultPair> pair = follow(input, step);
    for (int k = 0; k < kShorter && pair && !contacts_.stay(*pair); ++k) {
      step *= 0.1;
      pair = follow(input, step);
    }
    Slopes slopes;
    if (pair) slopes.results = slopes_of(*pair, step, at_);
    if (slopes.results.empty()) {
      found_.not_done.push_back(input.name);
    } else if (wish_.keys.empty() && !noticeable(slopes.results, step, at_)) {
      found_.without_effect.push_back(input.name);
    } else {
      if (wish_.one_sided) slopes.contacts = contacts_.slopes_of(*pair, step);
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

  const SensitivityWish& wish_;
  SensitivityLay lay_;
  ModelValues values_;
  std::vector<InputTolerance> tolerances_;
  std::vector<ResultValue> at_;
  NearContacts contacts_;
  std::vector<std::vector<Derivative>> columns_;  ///< By input.
  SensitivityResults found_;
};

void tell_assumptions(const Model& model, SensitivityResults& results) {
  results.assumptions.push_back({AssumptionRank::other,
                                 "Sensitivities hold the mesh and the contacts as they are; derivatives by the numbers "
                                 "of the model file, each by itself."});
  if (has_station(model.description)) {
    results.assumptions.push_back(
        {AssumptionRank::other,
         "Sensitivities hold the vessel where it lies; what keeps it there would let it follow."});
  }
  const bool all_given =
      std::ranges::all_of(results.inputs, [](const SensitivityInput& input) { return input.own_tolerance; });
  if (!all_given) {
    results.assumptions.push_back(
        {AssumptionRank::other, fmt::format("Where sensitivities.tolerances says nothing, the tolerance is {} for "
                                            "places, 0.1 deg for angles and 1 % of anything else.",
                                            shown_digits(0.01, section_length(), 3))});
  }
}

}  // namespace

std::optional<SensitivityResults> find_sensitivities(const Model& model, const StaticSolution& solution,
                                                     const SensitivityWish& wish) {
  const auto begin = std::chrono::steady_clock::now();
  Sensitivities sensitivities(model, solution, wish);
  if (!sensitivities.regular()) return std::nullopt;
  SensitivityResults results = sensitivities.find();
  tell_assumptions(model, results);
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
    const auto result = std::ranges::find(found->results, name, &SensitivityOutput::name);
    if (result == found->results.end()) return std::nullopt;
    for (const std::string& key : keys) {
      const auto input = std::ranges::find_if(
          found->inputs, [&](const SensitivityInput& one) { return one.key == key || one.name == key; });
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
