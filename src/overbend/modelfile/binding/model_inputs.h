/// Numbers of a model file as inputs: names, units, and the model with one of them changed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/description.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// Number in the model file on which an analysis may depend.
struct ModelInput {
  std::string key;   ///< Key in the file: "supports.stinger.boxes[2].z".
  std::string name;  ///< The same with item names: "supports.stinger.boxes[stinger 3].z".
  std::string text;  ///< Description from the field table.
  std::string unit;  ///< SI; "1" for a plain number.
  std::string show;  ///< Display unit, empty for a plain number.
  double value = 0.0;
  std::vector<std::size_t> place;  ///< Child indices of the groups and lists down to the value.
};

/// Returns all numbers given in the file except counters, solver settings, the waves and vessel motion over time, and
/// the moorings that hold the vessel.
std::vector<ModelInput> numeric_inputs(const FieldValue& root);

/// Values of a model file, kept for repeated changes.
class ModelValues {
 public:
  /// Parses the text of a description that was read.
  explicit ModelValues(const Description& description);

  const FieldValue& root() const { return root_; }
  const std::vector<ModelInput>& inputs() const { return inputs_; }
  /// Returns the input with that key or name; empty if there is none.
  std::optional<std::size_t> find(const std::string& key_or_name) const;
  /// Returns the description with another value [SI] of an input. Of the files it names it contains only the seabed
  /// depths, which statics needs; it is not checked.
  Description with(const ModelInput& input, double value);

 private:
  std::string source_file_;
  FieldValue root_;
  std::vector<ModelInput> inputs_;
  std::optional<Bathymetry> bathymetry_;
};

}  // namespace overbend
