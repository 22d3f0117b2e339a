#include "checks/recheck_key.h"

#include <array>
#include <span>

namespace overbend {
namespace {

/// True if statics separate the contribution of the current.
bool stores_current_part(const CheckSettings& settings) {
  return settings.current_load == CurrentLoad::environmental && settings.codes != CheckCodes::api;
}

struct SettingDifference {
  const char* key;
  bool differs;
};

std::string first_difference(std::span<const SettingDifference> all) {
  for (const SettingDifference& difference : all) {
    if (difference.differs) return difference.key;
  }
  return "";
}

}  // namespace

std::string key_for_new_analysis(const Model& before, const Model& after, bool over_time) {
  const CheckSettings &a = before.description.checks, &b = after.description.checks;
  const bool asks_current =
      stores_current_part(b) && !stores_current_part(a) && !after.description.environment.current.empty();
  const std::array statics_names = {
      SettingDifference{"checks.current_load", asks_current && a.current_load != b.current_load},
      SettingDifference{"checks.codes", asks_current},
  };
  if (std::string key = first_difference(statics_names); !key.empty() || !over_time) return key;
  const std::array moving = {
      SettingDifference{"checks.current_load", a.current_load != b.current_load},
      SettingDifference{"checks.condition_factor", a.condition_factor != b.condition_factor},
      SettingDifference{"checks.system_effects", a.system_effects != b.system_effects},
      SettingDifference{"checks.point_load", a.point_load != b.point_load},
      SettingDifference{"checks.manufacture", a.manufacture != b.manufacture},
      SettingDifference{"checks.alpha_fab", a.alpha_fab != b.alpha_fab},
      SettingDifference{"checks.alpha_u", a.alpha_u != b.alpha_u},
      SettingDifference{"checks.alpha_h", a.alpha_h != b.alpha_h},
      SettingDifference{"checks.ovality", a.ovality != b.ovality},
  };
  return first_difference(moving);
}

void select_safety_class(StationDesign& design, SafetyClass safety) {
  static_cast<DesignPeaks&>(design) = design.of_class.at(static_cast<std::size_t>(safety));
}

}  // namespace overbend
