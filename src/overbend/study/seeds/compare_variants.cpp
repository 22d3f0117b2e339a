#include "study/seeds/compare_variants.h"

#include "statics/solver/static_obstacle.h"

namespace overbend {
namespace {

Case variant(const char* name, const char* words, const char* path, const char* value) {
  return {name, words, {{path, YamlChange::Kind::scalar, value}}};
}

}  // namespace

std::vector<Case> variants_of(ComparisonOf of) {
  if (of == ComparisonOf::contact) {
    return {variant("rollers", "Rollers", "supports.contact", "rollers"),
            variant("gap_springs", "Gap springs", "supports.contact", "gap_springs")};
  }
  if (of == ComparisonOf::impacts) {
    return {variant("resolved", "Impacts resolved", "analysis.dynamic.impacts", "resolved"),
            variant("captured", "Impacts captured", "analysis.dynamic.impacts", "captured")};
  }
  return {variant("off", "Off, held by its brake", "tensioner.mode", "locked"),
          variant("controlled", "Controlled", "tensioner.mode", "controlled"),
          variant("constant", "Constant (ideal)", "tensioner.mode", "constant")};
}

std::optional<std::string> comparison_obstacle(ComparisonOf of, const Description& description) {
  if (auto obstacle = pipe_obstacle(description, "a comparison of tensioners, contacts or impacts")) return obstacle;
  if (of == ComparisonOf::tensioner && !description.tensioner.range_low) {
    return "tensioner.range is missing: a controlled tensioner needs a range, for example [240 kN, 260 kN]";
  }
  if (of != ComparisonOf::tensioner && description.supports.boxes.empty()) {
    return "the model has no supports, so there is no contact to compare";
  }
  return std::nullopt;
}

}  // namespace overbend
