#include "modelfile/check_binder.h"

#include "modelfile/binding.h"

namespace overbend {
namespace {

void take_flag(const FieldValue& group, const std::string& key, bool& target) {
  if (const auto text = group.get_text(key)) target = *text == "yes";
}

void bind_api(const FieldValue& group, ApiSettings& api) {
  take_choice(group, "api.edition", std::array{"third", "fourth", "fifth"}, api.edition);
  take(group, "api.collapse_factor", api.collapse_factor);
  take(group, "api.bending_factor", api.bending_factor);
  take(group, "api.ovality", api.ovality);
}

void bind_yield_share(const FieldValue& group, YieldShares& share) {
  take(group, "yield_share.overbend_static", share.overbend_static);
  take(group, "yield_share.overbend_dynamic", share.overbend_dynamic);
  take(group, "yield_share.sagbend_static", share.sagbend_static);
  take(group, "yield_share.sagbend_dynamic", share.sagbend_dynamic);
}

void bind_limits(const FieldValue& group, EquipmentLimits& limits) {
  take(group, "limits.roller_load", limits.roller_load);
  take(group, "limits.coating_line_load", limits.coating_line_load);
  take(group, "limits.tension", limits.tension);
  take(group, "limits.tip_clearance", limits.tip_clearance);
}

}  // namespace

CheckSettings bind_checks(const FieldValue& root) {
  CheckSettings checks;
  const FieldValue* group = root.find("checks");
  if (group == nullptr) return checks;
  take_choice(*group, "codes", std::array{"both", "dnv", "api"}, checks.codes);
  take_choice(*group, "safety_class", std::array{"low", "medium", "high"}, checks.safety_class);
  take_word<Manufacture>(*group, "manufacture", std::array{"seamless", "erw", "hfw", "trb", "uo", "uoe"},
                         checks.manufacture);
  take(*group, "alpha_u", checks.alpha_u);
  take(*group, "alpha_fab", checks.alpha_fab);
  take(*group, "wall_tolerance", checks.wall_tolerance);
  take(*group, "ovality", checks.ovality);
  take(*group, "alpha_h", checks.alpha_h);
  take(*group, "condition_factor", checks.condition_factor);
  take_flag(*group, "system_effects", checks.system_effects);
  take_choice(*group, "yield_basis", std::array{"smys", "fy"}, checks.yield_basis);
  take_choice(*group, "current_load", std::array{"environmental", "functional"}, checks.current_load);
  take(*group, "grade", checks.grade);
  take_flag(*group, "point_load", checks.point_load);
  if (const FieldValue* arrestor = group->find("arrestor")) {
    checks.arrestor = ArrestorSettings{};
    take(*arrestor, "propagation_pressure", checks.arrestor->propagation_pressure);
    take(*arrestor, "length", checks.arrestor->length);
  }
  bind_api(*group, checks.api);
  bind_yield_share(*group, checks.yield_share);
  bind_limits(*group, checks.limits);
  return checks;
}

}  // namespace overbend
