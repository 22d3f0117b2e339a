/// Axes and samples of a study file, held to the keys of the base model. For modelfile/study_file/study_reader.cpp.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/yaml_document.h"
#include "model/description/study_description.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {

/// The keys of the base model that the study sets: each may be set once.
class StudyKeys {
 public:
  explicit StudyKeys(const YamlNode& model) : model_(model) {}

  /// The row of a key that the model has; null, with the complaint made, where it is none or is set already. `at` is
  /// where it stands in the study file.
  const Field* take(Checker& check, const FieldValue& at, const std::string& key);

 private:
  const YamlNode& model_;
  std::set<std::string> taken_;
};

std::vector<StudyAxis> read_axes(Checker& check, StudyKeys& keys);
std::optional<StudySample> read_sample(Checker& check, StudyKeys& keys);

/// A text as a value of the row; complains and returns nothing where it is none.
std::optional<double> checked_number(Checker& check, const FieldValue& at, const Field& row);

}  // namespace overbend
