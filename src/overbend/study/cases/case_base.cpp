// The base model of a study with changed keys.
#include <algorithm>
#include <stdexcept>

#include "modelfile/reading/yaml_reader.h"
#include "modelfile/yaml/chosen_keys.h"
#include "study/cases/case_evaluation.h"
#include "study/run/case.h"

namespace overbend {
namespace {

YamlNode parsed(const Description& description) {
  Diagnostics diagnostics;
  std::optional<YamlNode> tree = parse_yaml(description.source_text, description.source_file, diagnostics);
  if (!tree || diagnostics.has_errors()) throw std::runtime_error("the text of the base model cannot be parsed again");
  return std::move(*tree);
}

Description taken(ModelReading reading) {
  if (reading.description) return std::move(*reading.description);
  const std::vector<std::string> errors = reading.diagnostics.lines(Severity::error);
  throw std::runtime_error(errors.empty() ? "the model cannot be read" : errors.front());
}

}  // namespace

CaseBase::CaseBase(Description base, StudyDescription study)
    : base_(std::move(base)), study_(std::move(study)), tree_(parsed(base_)) {}

std::vector<YamlChange> CaseBase::changes(const std::vector<KeySetting>& keys) const {
  std::vector<YamlChange> list;
  for (const KeySetting& setting : keys) {
    const auto parts = split_result_path(setting.key);
    if (!parts) throw std::runtime_error("'" + setting.key + "' is not a key");
    for (const ChosenKey& key : chosen_keys(tree_, *parts)) {
      list.push_back({key.path, YamlChange::Kind::scalar, setting.value});
    }
  }
  return list;
}

/// Edits the parsed tree if possible; edits and reads the text if a key is missing in an unusual place, or if files
/// that only a complete reading loads are needed.
Description CaseBase::described(const std::vector<KeySetting>& keys, bool statics_only) const {
  const std::vector<YamlChange> list = changes(keys);
  const bool hull_files = base_.vessel.coupled.has_value();
  if (statics_only && !hull_files) {
    YamlNode tree = tree_;
    if (edit_tree(tree, list)) return taken(read_statics_inputs(tree, base_.source_file));
  }
  Description model = taken(read_model_text(edit_yaml(base_.source_text, list), base_.source_file));
  set_duration(model, study_.duration);
  return model;
}

}  // namespace overbend
