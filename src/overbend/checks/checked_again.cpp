#include "checks/checked_again.h"

#include <array>
#include <span>

namespace overbend {
namespace {

/// Whether statics keep apart what the current adds.
bool keeps_current(const CheckSettings& settings) {
  return settings.current_load == CurrentLoad::environmental && settings.codes != CheckCodes::api;
}

struct Differs {
  const char* key;
  bool differs;
};

std::string first_of(std::span<const Differs> all) {
  for (const Differs& one : all) {
    if (one.differs) return one.key;
  }
  return "";
}

}  // namespace

std::string key_for_new_analysis(const Model& before, const Model& after, bool over_time) {
  const CheckSettings &a = before.description.checks, &b = after.description.checks;
  const bool asks_current = keeps_current(b) && !keeps_current(a) && !after.description.environment.current.empty();
  const std::array still = {
      Differs{"checks.current_load", asks_current && a.current_load != b.current_load},
      Differs{"checks.codes", asks_current},
  };
  if (std::string key = first_of(still); !key.empty() || !over_time) return key;
  const std::array moving = {
      Differs{"checks.current_load", a.current_load != b.current_load},
      Differs{"checks.condition_factor", a.condition_factor != b.condition_factor},
      Differs{"checks.system_effects", a.system_effects != b.system_effects},
      Differs{"checks.point_load", a.point_load != b.point_load},
      Differs{"checks.manufacture", a.manufacture != b.manufacture},
      Differs{"checks.alpha_fab", a.alpha_fab != b.alpha_fab},
      Differs{"checks.alpha_u", a.alpha_u != b.alpha_u},
      Differs{"checks.alpha_h", a.alpha_h != b.alpha_h},
      Differs{"checks.ovality", a.ovality != b.ovality},
  };
  return first_of(moving);
}

void take_class(StationDesign& design, SafetyClass safety) {
  static_cast<DesignPeaks&>(design) = design.of_class.at(static_cast<std::size_t>(safety));
}

}  // namespace overbend
