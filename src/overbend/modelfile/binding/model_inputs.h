/// The numbers of a model file as inputs: what they are called, what they are, and the model with one of them changed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/description.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// A number of the model file that an analysis may depend on.
struct ModelInput {
  std::string key;   ///< Where it stands: "supports.stinger.boxes[2].z".
  std::string name;  ///< The same with the names of items: "supports.stinger.boxes[stinger 3].z".
  std::string text;  ///< What it is, the table's line.
  std::string unit;  ///< SI; "1" for a plain number.
  std::string show;  ///< Unit to show it in, empty for a plain number.
  double value = 0.0;
  std::vector<std::size_t> place;  ///< Among the children of the groups and lists down to it.
};

/// Every number that stands in the file, but for counters and for what says how to compute, what the sea and the vessel
/// do in time, and where the vessel's moorings hold it.
std::vector<ModelInput> numeric_inputs(const FieldValue& root);

/// A model file kept as its values.
class ModelValues {
 public:
  /// Of a description that was read; from its text.
  explicit ModelValues(const Description& description);

  const FieldValue& root() const { return root_; }
  const std::vector<ModelInput>& inputs() const { return inputs_; }
  /// The input of that key or name; nothing where there is none.
  std::optional<std::size_t> find(const std::string& key_or_name) const;
  /// The description with another number [SI] there. Of what the files that it names hold it has the depths of the
  /// seabed, which statics needs; it is not checked.
  Description with(const ModelInput& input, double value);

 private:
  std::string source_file_;
  FieldValue root_;
  std::vector<ModelInput> inputs_;
  std::optional<Bathymetry> bathymetry_;
};

}  // namespace overbend
