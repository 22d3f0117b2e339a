/// A model in Python: its text, with keys that can be set.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/yaml_document.h"
#include "model/description/description.h"
#include "modelfile/yaml/yaml_edit.h"

namespace overbend {

/// Thrown if a text is not a valid model; contains the diagnostics.
class UnreadableModel : public std::runtime_error {
 public:
  explicit UnreadableModel(Diagnostics found)
      : std::runtime_error("the model cannot be read"), found_(std::move(found)) {}
  const Diagnostics& diagnostics() const { return found_; }

 private:
  Diagnostics found_;
};

/// Immutable for users. Keeps the tree of the text, so that scalars can be changed without reading the text; contents
/// that need a complete reading (referenced files, warnings) are read on request.
class ModelHandle {
 public:
  /// Reads a file. Throws UnreadableModel, like the functions below.
  static std::shared_ptr<ModelHandle> read(const std::string& path);
  /// Reads a text. `file` names it in messages and gives the folder of referenced files.
  static std::shared_ptr<ModelHandle> from_text(const std::string& text, const std::string& file);

  /// Returns the model with keys set in order. A key may select items by pattern. Also throws YamlEditError if a key
  /// cannot be set, and std::invalid_argument if it does not exist or selects nothing.
  std::shared_ptr<ModelHandle> changed(const std::vector<YamlChange>& changes) const;

  /// Returns the description from a complete reading of the text.
  const Description& description() const;
  /// Returns a description sufficient for statics.
  const Description& statics_description() const {
    return statics_description_ ? *statics_description_ : *full_description_;
  }
  const std::string& text() const;
  const std::string& file() const { return file_; }
  /// Returns the node of a key in the text (of the first item that it selects); null if it is not given. Throws
  /// std::invalid_argument if it is not a valid key.
  const YamlNode* find(const std::string& key) const;
  const YamlNode& tree() const { return tree_; }

 private:
  ModelHandle() = default;

  std::string file_;
  YamlNode tree_;
  std::vector<YamlChange> pending_;  ///< Changes not yet applied to the text.
  std::optional<Description> statics_description_;
  mutable std::mutex mutex_;  ///< Guards the members below, which are made on request.
  mutable std::string text_;
  mutable bool text_is_new_ = true;
  mutable std::optional<Description> full_description_;
};

}  // namespace overbend
