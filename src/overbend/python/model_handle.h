/// A model as Python holds it: its text, with keys set anew as often as wanted.
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

/// A text that is no model, with all that was found wrong.
class UnreadableModel : public std::runtime_error {
 public:
  explicit UnreadableModel(Diagnostics found)
      : std::runtime_error("the model cannot be read"), found_(std::move(found)) {}
  const Diagnostics& diagnostics() const { return found_; }

 private:
  Diagnostics found_;
};

/// Constant for who looks at it. The tree of the text is kept, so that a change of scalars reads no text; what only a
/// whole reading gives (files that the model names, warnings) is read when it is asked for.
class ModelHandle {
 public:
  /// Throws UnreadableModel, as the functions below.
  static std::shared_ptr<ModelHandle> read(const std::string& path);
  /// `file` names the text in messages and gives the folder of the files that it mentions.
  static std::shared_ptr<ModelHandle> from_text(const std::string& text, const std::string& file);

  /// The model with keys set, one after the other. A key may choose items by pattern. Throws besides YamlEditFault
  /// where a key cannot be set, std::invalid_argument where it is none or chooses nothing.
  std::shared_ptr<ModelHandle> changed(const std::vector<YamlChange>& changes) const;

  /// As read from the whole text.
  const Description& description() const;
  /// Enough for statics.
  const Description& still() const { return still_ ? *still_ : *whole_; }
  const std::string& text() const;
  const std::string& file() const { return file_; }
  /// What the text has for a key, of the first item that it chooses; null where it is left out. Throws
  /// std::invalid_argument where it is no key.
  const YamlNode* find(const std::string& key) const;
  const YamlNode& tree() const { return tree_; }

 private:
  ModelHandle() = default;

  std::string file_;
  YamlNode tree_;
  std::vector<YamlChange> pending_;  ///< Not yet in the text.
  std::optional<Description> still_;
  mutable std::mutex mutex_;  ///< On the members below, which are made when they are asked for.
  mutable std::string text_;
  mutable bool text_is_new_ = true;
  mutable std::optional<Description> whole_;
};

}  // namespace overbend
