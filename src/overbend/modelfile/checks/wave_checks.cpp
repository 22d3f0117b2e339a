#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/constants.h"
#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "model/site/wave_groups.h"
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
      {WaveType::jonswap, {"hs", "tp"}, {"tz", "gamma", "spectrum_file", "time", "spreading", "components", "seed"}},
      {WaveType::pierson_moskowitz, {"hs", "tp"}, {"tz", "spectrum_file", "time", "spreading", "components", "seed"}},
      {WaveType::ochi_hubble, {"parts"}, kSpread},
      {WaveType::torsethaugen, {"hs", "tp", "model"}, kSpread},
      {WaveType::user, {"spectrum_file"}, {"time", "location", "spreading", "components", "seed"}},
      {WaveType::elevation, {"elevation_file"}, {"at"}},
  };
  return kKeys;
}

bool holds(const std::vector<std::string>& names, const std::string& word) {
  return std::find(names.begin(), names.end(), word) != names.end();
}

/// Returns true if another key gives what this one would.
bool is_replaced(const FieldValue& waves, WaveType type, const std::string& key) {
  if (type != WaveType::jonswap && type != WaveType::pierson_moskowitz) return false;
  if (key != "hs" && key != "tp") return false;
  return waves.mentions("spectrum_file") || (key == "tp" && waves.mentions("tz"));
}

void check_keys(Checker& check, const FieldValue& waves, const WaveKeys& keys) {
  for (const std::string& key : keys.needed) {
    if (waves.mentions(key) || is_replaced(waves, keys.type, key)) continue;
    check.missing(waves, key, std::string("a value for waves of type ") + enum_name(keys.type));
  }
  for (const std::string key : {"hs", "tp", "tz", "height", "period", "phase", "gamma", "parts", "model", "spreading",
                                "spectrum_file", "time", "location", "elevation_file", "at"}) {
    const FieldValue* extra = waves.find(key);
    if (extra == nullptr || !extra->given || holds(keys.needed, key) || holds(keys.allowed, key)) continue;
    check.warn(*extra, std::string("has no effect for waves of type ") + enum_name(keys.type) + " and is not used",
               FindingCode::unused_input);
  }
}

/// Rejects two keys that give the same.
void check_alternatives(Checker& check, const FieldValue& waves, WaveType type) {
  if (type != WaveType::jonswap && type != WaveType::pierson_moskowitz) return;
  const FieldValue *tp = waves.find("tp"), *tz = waves.find("tz");
  if (tp != nullptr && tz != nullptr) {
    check.error(*tz, "tz as well as tp", "one of them",
                "for a given shape of the spectrum each follows from the other");
  }
  if (!waves.mentions("spectrum_file")) return;
  for (const char* key : {"hs", "tp", "tz"}) {
    if (const FieldValue* extra = waves.find(key)) {
      check.error(*extra, std::string(key) + " as well as spectrum_file", "one of them",
                  "the file of a buoy gives height and period");
    }
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

/// Returns the groups of waves of a model file, one or a list.
std::vector<const FieldValue*> wave_groups(const FieldValue& root) {
  const FieldValue* waves = root.find("environment.waves");
  if (waves == nullptr) return {};
  if (waves->kind != FieldValue::Kind::list) return {waves};
  std::vector<const FieldValue*> groups;
  for (const FieldValue& group : waves->children) groups.push_back(&group);
  return groups;
}

void check_group(Checker& check, const FieldValue& waves, const std::optional<double>& depth) {
  const auto type = waves.get_word<WaveType>("type");
  if (!type || *type == WaveType::none) return;
  for (const WaveKeys& keys : wave_keys()) {
    if (*type == keys.type) check_keys(check, waves, keys);
  }
  check_alternatives(check, waves, *type);
  const FieldValue* from = waves.find("from");
  if (from != nullptr && !from->given && !waves.mentions("spectrum_file")) {
    check.warn(waves, "no direction is given (from): the waves come from the north");
  }
  if (*type == WaveType::airy || *type == WaveType::stokes5) {
    if (depth) check_regular(check, waves, *type, *depth);
  } else if (*type != WaveType::user) {
    check_sea(check, waves);
  }
}

/// A wave of Stokes' theory cannot be superposed.
void check_superposition(Checker& check, const std::vector<const FieldValue*>& groups) {
  const auto acts = [](const FieldValue* group) { return group->get_word<WaveType>("type") != WaveType::none; };
  const auto count = std::count_if(groups.begin(), groups.end(), acts);
  for (const FieldValue* group : groups) {
    if (count < 2 || group->get_word<WaveType>("type") != WaveType::stokes5) continue;
    check.error(*group->find("type"), "stokes5 among " + std::to_string(count) + " groups of waves",
                "type airy, or stokes5 alone", "a Stokes wave is not linear: other waves cannot be added to it");
  }
}

/// The height at which waves of a sea break, for the sea of all groups together.
void check_breaking(Checker& check, const FieldValue& key, double hs, double depth) {
  const double breaking = kShallowBreaking * depth, highest = kHighestOfThousand * hs;
  if (highest <= breaking) return;
  const auto metres = [](double length) { return format_quantity(length, "m", "m", 3); };
  check.warn(key, "of 1,000 waves of a sea with a significant height of " + metres(hs) + " the highest is " +
                      metres(highest) + ", and waves of more than " + metres(breaking) + " break in a water depth of " +
                      metres(depth) + ": a sum of linear waves does not break");
}

/// Returns the key that gives a group's height.
const FieldValue* height_key(const FieldValue& group) {
  for (const char* key : {"hs", "parts", "spectrum_file", "elevation_file"}) {
    if (const FieldValue* value = group.find(key)) return value;
  }
  return nullptr;
}

/// Directions of a file, and none.
void check_file_direction(Checker& check, const FieldValue& group, const WavesDescription& waves) {
  const FieldValue* from = group.find("from");
  if (from == nullptr || waves.spectrum_file.empty()) return;
  if (from->given && waves.file_gives_direction) {
    check.error(*from, from->shown + " as well as the directions of the file", "one of them",
                "leave out from: " + waves.spectrum_file + " gives the direction");
  } else if (!from->given && !waves.file_gives_direction) {
    check.warn(group, "no direction is given (from): the waves come from the north");
  }
}

/// Warns of a run that is longer than a measured elevation, which then repeats.
void check_record_length(Checker& check, const FieldValue& group, const WavesDescription& waves) {
  const FieldValue* file = group.find("elevation_file");
  const auto duration = check.root().get_number("analysis.dynamic.duration");
  const double length = waves.record.duration();
  if (file == nullptr || !duration || length <= 0.0 || *duration <= length) return;
  check.warn(*file, "the record of " + format_number(length, 5) + " s is shorter than the run of " +
                        format_number(*duration, 5) + " s: beyond its end the sea repeats the record");
}

}  // namespace

void check_sea_over_bed(const FieldValue& root, const Description& description, Diagnostics& diagnostics) {
  Checker check(root, description.source_file, diagnostics);
  const std::vector<const FieldValue*> groups = wave_groups(root);
  const double hs = significant_height(description.environment.waves);
  for (const FieldValue* group : groups) {
    const auto type = group->get_word<WaveType>("type");
    const FieldValue* key = type && is_irregular(*type) ? height_key(*group) : nullptr;
    if (key == nullptr) continue;
    check_breaking(check, groups.size() == 1 ? *key : *root.find("environment.waves"), hs,
                   description.environment.water_depth);
    return;
  }
}

void check_wave_files(const FieldValue& root, const Description& description, Diagnostics& diagnostics) {
  Checker check(root, description.source_file, diagnostics);
  const std::vector<const FieldValue*> groups = wave_groups(root);
  for (std::size_t i = 0; i < groups.size() && i < description.environment.waves.size(); ++i) {
    check_file_direction(check, *groups[i], description.environment.waves[i]);
    check_record_length(check, *groups[i], description.environment.waves[i]);
  }
}

void check_waves(const FieldValue& root, const std::string& file, Diagnostics& diagnostics) {
  Checker check(root, file, diagnostics);
  const std::vector<const FieldValue*> groups = wave_groups(root);
  for (const FieldValue* group : groups) check_group(check, *group, root.get_number("environment.water_depth"));
  check_superposition(check, groups);
}

}  // namespace overbend
