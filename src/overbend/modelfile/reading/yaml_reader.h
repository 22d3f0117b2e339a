/// Reads a model file: strict, and with everything that is wrong told at once.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "base/yaml_document.h"
#include "model/description/description.h"

namespace overbend {

struct ModelReading {
  std::optional<Description> description;  ///< Only when there is no error.
  Diagnostics diagnostics;
  std::shared_ptr<const YamlNode> tree{};  ///< Of read_model_text(), as far as the text could be parsed; else null.
};

/// Reads the file at `path`. Warnings are copied into Description::warnings. Never throws on what the file holds.
ModelReading read_model(const std::string& path);

/// The same for a text; `path` names it in messages and gives the folder of the files it mentions.
ModelReading read_model_text(const std::string& text, const std::string& path);

/// The same for a text whose tree is known, with what was found wrong in parsing it.
ModelReading read_model_tree(std::shared_ptr<const YamlNode> tree, const Diagnostics& faults, const std::string& text,
                             const std::string& path);

/// For a text that was read before and is kept with its results: the files that it names are not looked for, and what
/// was checked then is not checked again. No description where keys are unknown, missing or of another kind.
ModelReading read_stored_model(const std::string& text, const std::string& path);

/// The same for a tree, without the file of the vessel's motion: enough for statics, where it is done many times a
/// second.
ModelReading read_still_model(const YamlNode& root, const std::string& path);

}  // namespace overbend
