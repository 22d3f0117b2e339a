#include "study/campaign/study_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include "base/units.h"
#include "model/site/wave_groups.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

/// Returns "KEY: message" of a model's findings on one of the keys.
std::set<std::string> about(const std::vector<KeySetting>& keys, const Findings& findings) {
  std::set<std::string> found;
  for (const Finding& finding : findings) {
    for (const KeySetting& setting : keys) {
      if (finding.object != setting.key) continue;
      found.insert(finding.message.substr(finding.message.find(setting.key + ": ")));
    }
  }
  return found;
}

bool follows_rule(const WavesDescription& waves) {
  return waves.type == WaveType::jonswap && !waves.gamma && !waves.tz && waves.spectrum_file.empty();
}

/// Height or period of a case, as one of its keys sets it.
double set_value(const std::vector<KeySetting>& keys, const std::string& key, const std::string& unit,
                 double otherwise) {
  for (const KeySetting& setting : keys) {
    if (setting.key == key) return parse_quantity(setting.value, unit).value.value_or(otherwise);
  }
  return otherwise;
}

/// Warns of seas whose shape changes with their height: a higher sea may load the pipe less.
std::optional<std::string> make_gamma_remark(const WavesDescription& waves, const StudyCases& cases) {
  constexpr std::size_t kMaxCases = 20'000;
  if (!follows_rule(waves)) return std::nullopt;
  std::vector<double> gammas;
  for (std::size_t number = 0; number < std::min(cases.count(), kMaxCases); ++number) {
    const std::vector<KeySetting> keys = cases.question(number).keys;
    gammas.push_back(jonswap_gamma(set_value(keys, waves.key + ".hs", "m", waves.hs),
                                   set_value(keys, waves.key + ".tp", "s", waves.tp)));
  }
  const auto [min, max] = std::minmax_element(gammas.begin(), gammas.end());
  if (*max - *min < 0.01) return std::nullopt;
  return fmt::format(
      "the peak enhancement of JONSWAP follows height and period by the rule of DNV-RP-C205, from {:.3g} to {:.3g} in "
      "this study: seas of different height have different shapes, and a higher one may load the pipe less; give "
      "{}.gamma to compare seas of one shape",
      *min, *max, waves.key);
}

}  // namespace

Findings study_findings(const CaseBase& base, const StudyCases& cases) {
  std::set<std::string> common;
  bool looked = false, random = false;
  WaveGroups waves;
  for (const std::size_t number : std::set<std::size_t>{0, cases.count() / 2, cases.count() - 1}) {
    const std::vector<KeySetting> keys = cases.question(number).keys;
    try {
      const Description description = base.described(keys, false);
      std::set<std::string> found = about(keys, description.findings);
      if (looked) std::erase_if(found, [&](const std::string& message) { return !common.contains(message); });
      common = std::move(found);
      looked = true;
      random = random || is_random(description.environment.waves);
      waves = description.environment.waves;
    } catch (const std::runtime_error&) {  // the case itself reports the error
    }
  }
  Findings findings;
  for (const std::string& message : common) findings.push_back({FindingCode::unusual_input, message});
  if (looked && !random && cases.seeds() > 1) {
    findings.push_back({FindingCode::sea_not_random, "the sea is not random: all seeds give the same results"});
  }
  for (const WavesDescription& group : waves) {
    if (std::optional<std::string> remark = make_gamma_remark(group, cases)) {
      findings.push_back({FindingCode::study_inputs, std::move(*remark)});
    }
  }
  return findings;
}

}  // namespace overbend
