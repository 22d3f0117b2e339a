#include "study/study_remarks.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace overbend {
namespace {

/// "KEY: what is said of it" of a model's warnings that are about one of the keys.
std::set<std::string> about(const std::vector<KeySetting>& keys, const std::vector<std::string>& warnings) {
  std::set<std::string> found;
  for (const std::string& warning : warnings) {
    for (const KeySetting& setting : keys) {
      const std::string mark = ": warning: ";
      const std::size_t at = warning.find(mark + setting.key + ": ");
      if (at != std::string::npos) found.insert(warning.substr(at + mark.size()));
    }
  }
  return found;
}

bool is_random(const WavesDescription& waves) {
  return waves.type != WaveType::none && waves.type != WaveType::airy && waves.type != WaveType::stokes5;
}

}  // namespace

std::vector<std::string> study_remarks(const CaseBase& base, const StudyCases& cases) {
  std::set<std::string> common;
  bool looked = false, random = false;
  for (const std::size_t number : std::set<std::size_t>{0, cases.count() / 2, cases.count() - 1}) {
    const std::vector<KeySetting> keys = cases.question(number).keys;
    try {
      const Description description = base.described(keys, false);
      std::set<std::string> found = about(keys, description.warnings);
      if (looked) std::erase_if(found, [&](const std::string& words) { return !common.contains(words); });
      common = std::move(found);
      looked = true;
      random = random || is_random(description.environment.waves);
    } catch (const std::runtime_error&) {  // the case itself says why
    }
  }
  std::vector<std::string> remarks(common.begin(), common.end());
  if (looked && !random && cases.seeds() > 1) {
    remarks.emplace_back("the sea is not random: all seeds give the same results");
  }
  return remarks;
}

}  // namespace overbend
