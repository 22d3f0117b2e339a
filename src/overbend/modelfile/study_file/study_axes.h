/// Axes and samples of a study file, checked against the keys of the base model. For
/// modelfile/study_file/study_reader.cpp.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/yaml_document.h"
#include "model/description/study_description.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {

/// Keys of the base model that the study sets; each may be set once.
class StudyKeys {
 public:
  explicit StudyKeys(const YamlNode& model) : model_(model) {}

  /// Returns the row of a key of the model; null, with an error, if there is none or it is already set. `value` is its
  /// position in the study file.
  const Field* take(Checker& check, const FieldValue& value, const std::string& key);

 private:
  const YamlNode& model_;
  std::set<std::string> taken_;
};

std::vector<StudyAxis> read_axes(Checker& check, StudyKeys& keys);
std::optional<StudySample> read_sample(Checker& check, StudyKeys& keys);

/// Returns a text as a value of the row; empty, with an error, if it is invalid.
std::optional<double> checked_number(Checker& check, const FieldValue& value, const Field& row);

}  // namespace overbend
