#include "study/seeds/compare_variants.h"

#include "statics/solver/unsupported_statics.h"

namespace overbend {
namespace {

Case variant(const char* name, const char* label, const char* path, const char* value) {
  return {name, label, {{path, YamlChange::Kind::scalar, value}}};
}

}  // namespace

std::vector<Case> make_variants(ComparisonType of) {
  if (of == ComparisonType::contact) {
    return {variant("rollers", "Rollers", "supports.contact", "rollers"),
            variant("gap_springs", "Gap springs", "supports.contact", "gap_springs")};
  }
  if (of == ComparisonType::impacts) {
    return {variant("resolved", "Impacts resolved", "analysis.dynamic.impacts", "resolved"),
            variant("captured", "Impacts captured", "analysis.dynamic.impacts", "captured")};
  }
  return {variant("off", "Off, held by its brake", "tensioner.mode", "locked"),
          variant("controlled", "Controlled", "tensioner.mode", "controlled"),
          variant("constant", "Constant (ideal)", "tensioner.mode", "constant")};
}

std::optional<std::string> unsupported_comparison(ComparisonType of, const Description& description) {
  if (auto unsupported = missing_pipe_message(description, "a comparison of tensioners, contacts or impacts")) {
    return unsupported;
  }
  if (of == ComparisonType::tensioner && !description.tensioner.range_low) {
    return "tensioner.range is missing: a controlled tensioner needs a range, for example [240 kN, 260 kN]";
  }
  if (of != ComparisonType::tensioner && description.supports.boxes.empty()) {
    return "the model has no supports, so that there is no contact to compare";
  }
  return std::nullopt;
}

}  // namespace overbend
