#include "app/compare_variants.h"

#include <stdexcept>

#include "modelfile/yaml_edit.h"
#include "modelfile/yaml_reader.h"

namespace overbend {

const std::vector<Variant>& variants_of(ComparisonOf of) {
  static const std::vector<Variant> kTensioner = {{"off", "Off, held by its brake", "tensioner.mode", "locked"},
                                                  {"controlled", "Controlled", "tensioner.mode", "controlled"},
                                                  {"constant", "Constant (ideal)", "tensioner.mode", "constant"}};
  static const std::vector<Variant> kContact = {{"rollers", "Rollers", "supports.contact", "rollers"},
                                                {"gap_springs", "Gap springs", "supports.contact", "gap_springs"}};
  return of == ComparisonOf::tensioner ? kTensioner : kContact;
}

std::optional<std::string> comparison_obstacle(ComparisonOf of, const Description& description) {
  if (of == ComparisonOf::tensioner && !description.tensioner.range_low) {
    return "tensioner.range is missing: a controlled tensioner needs a range, for example [240 kN, 260 kN]";
  }
  if (of == ComparisonOf::contact && description.supports.boxes.empty()) {
    return "the model has no supports, so there is no contact to compare";
  }
  return std::nullopt;
}

Description vary(const Description& description, const Variant& variant) {
  const std::string text =
      edit_yaml(description.source_text, {{variant.path, YamlChange::Kind::scalar, variant.value}});
  ModelReading reading = read_model_text(text, description.source_file);
  if (!reading.description) {
    const std::vector<std::string> errors = reading.diagnostics.lines(Severity::error);
    throw std::runtime_error("the variant " + variant.name + ": " + (errors.empty() ? "" : errors.front()));
  }
  return std::move(*reading.description);
}

}  // namespace overbend
