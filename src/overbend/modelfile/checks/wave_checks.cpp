#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/constants.h"
#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "model/waves/wave_theory.h"
#include "modelfile/checks/model_checks.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {
namespace {

/// Max. ratio of height to depth of waves observed on a level seabed.
constexpr double kShallowBreaking = 0.78;

/// Min. Tp/sqrt(Hs) [s/m^1/2] for which JONSWAP is a valid model of the sea [dnvc205].
constexpr double kSteepSea = 3.6;

/// Ratio of the highest of 1,000 waves to Hs: sqrt(ln(1000)/2) from the Rayleigh distribution.
constexpr double kHighestOfThousand = 1.858;

struct WaveKeys {
  WaveType type;
  std::vector<std::string> needed;   ///< Required keys of the wave type.
  std::vector<std::string> allowed;  ///< Optional keys.
};

const std::vector<WaveKeys>& wave_keys() {
  static const std::vector<std::string> kSpread{"spreading", "components", "seed"};
  static const std::vector<WaveKeys> kKeys{
      {WaveType::airy, {"height", "period"}, {"phase"}},
      {WaveType::stokes5, {"height", "period"}, {"phase"}},
      {WaveType::jonswap, {"hs", "tp"}, {"gamma", "spreading", "components", "seed"}},
      {WaveType::pierson_moskowitz, {"hs", "tp"}, kSpread},
      {WaveType::user, {"spectrum_file"}, kSpread},
  };
  return kKeys;
}

bool holds(const std::vector<std::string>& names, const std::string& word) {
  return std::find(names.begin(), names.end(), word) != names.end();
}

void check_keys(Checker& check, const FieldValue& waves, const WaveKeys& keys) {
  for (const std::string& key : keys.needed) {
    if (!waves.mentions(key)) {
      check.missing(waves, key, std::string("a value for waves of type ") + enum_name(keys.type));
    }
  }
  for (const std::string key : {"hs", "tp", "height", "period", "phase", "gamma", "spreading", "spectrum_file"}) {
    const FieldValue* extra = waves.find(key);
    if (extra == nullptr || !extra->given || holds(keys.needed, key) || holds(keys.allowed, key)) continue;
    check.warn(*extra, std::string("has no effect for waves of type ") + enum_name(keys.type) + " and is not used",
               FindingCode::unused_input);
  }
}

/// Returns the length of the regular wave by its own theory; empty if the theory has no such wave.
std::optional<double> wave_length(WaveType type, double height, double period, double depth) {
  if (type == WaveType::airy) return kTurn / linear_wave_number(kTurn / period, depth);
  try {
    return kTurn / stokes_wave_number(height, period, depth);
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

void check_regular(Checker& check, const FieldValue& waves, WaveType type, double depth) {
  const FieldValue* height = waves.find("height");
  const auto period = waves.get_number("period");
  if (height == nullptr || !period) return;
  const std::string in_depth = " in a water depth of " + format_quantity(depth, "m", "m");
  const double linear = kTurn / linear_wave_number(kTurn / *period, depth);
  const double length = wave_length(type, height->number, *period, depth).value_or(linear);
  const double highest = std::min(highest_wave(length, depth), kShallowBreaking * depth);
  if (height->number > highest) {
    check.error(*height, height->shown, "less than " + format_quantity(highest, "m", "m", 3),
                "a higher wave " + format_quantity(length, "m", "m", 3) + " long breaks" + in_depth);
    return;
  }
  const double ursell = ursell_number(height->number, length, depth);
  if (type == WaveType::stokes5 && ursell > kStokesUrsell) {
    check.error(
        *height, height->shown + ", for which H L^2/d^3 is " + format_number(ursell, 3),
        "at most " + format_number(kStokesUrsell),
        "a wave of this length" + in_depth + " is beyond Stokes' theory; use type airy, or a lower or shorter wave");
  }
}

void check_sea(Checker& check, const FieldValue& waves) {
  const auto hs = waves.get_number("hs"), tp = waves.get_number("tp");
  if (!hs || !tp) return;
  const double ratio = *tp / std::sqrt(*hs);
  if (ratio >= kSteepSea) return;
  check.warn(*waves.find("tp"), "the sea is steeper than a wind sea: Tp/sqrt(Hs) is " + format_number(ratio, 3) +
                                    ", normally " + format_number(kSteepSea) + " and more");
}

}  // namespace

void check_sea_over_bed(const FieldValue& root, const Description& description, Diagnostics& diagnostics) {
  const WavesDescription& waves = description.environment.waves;
  if (waves.type == WaveType::none || waves.type == WaveType::airy || waves.type == WaveType::stokes5) return;
  const double depth = description.environment.water_depth, breaking = kShallowBreaking * depth;
  const double highest = kHighestOfThousand * waves.hs;
  const FieldValue* key =
      root.find(waves.type == WaveType::user ? "environment.waves.spectrum_file" : "environment.waves.hs");
  if (highest <= breaking || key == nullptr) return;
  const auto metres = [](double length) { return format_quantity(length, "m", "m", 3); };
  Checker(root, description.source_file, diagnostics)
      .warn(*key, "of 1,000 waves of a sea with a significant height of " + metres(waves.hs) + " the highest is " +
                      metres(highest) + ", and waves of more than " + metres(breaking) + " break in a water depth of " +
                      metres(depth) + ": a sum of linear waves does not break");
}

void check_waves(const FieldValue& root, const std::string& file, Diagnostics& diagnostics) {
  Checker check(root, file, diagnostics);
  const FieldValue* waves = root.find("environment.waves");
  const auto type = waves != nullptr ? waves->get_word<WaveType>("type") : std::nullopt;
  if (!type || *type == WaveType::none) return;
  for (const WaveKeys& keys : wave_keys()) {
    if (*type == keys.type) check_keys(check, *waves, keys);
  }
  const FieldValue* from = waves->find("from");
  if (from != nullptr && !from->given) {
    check.warn(*waves, "no direction is given (from): the waves come from the north");
  }
  const auto depth = root.get_number("environment.water_depth");
  if (*type == WaveType::airy || *type == WaveType::stokes5) {
    if (depth) check_regular(check, *waves, *type, *depth);
  } else if (*type != WaveType::user) {
    check_sea(check, *waves);
  }
}

}  // namespace overbend
