/// Reader of model files: strict, and reports all errors at once.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "base/yaml_document.h"
#include "model/description/description.h"

namespace overbend {

struct ModelReading {
  std::optional<Description> description;  ///< Only if there is no error.
  Diagnostics diagnostics;
  std::shared_ptr<const YamlNode> tree{};  ///< Result of read_model_text(), if the text could be parsed; else null.
};

/// Reads the file at `path`. Warnings are copied into Description::warnings. Never throws because of the file's
/// contents.
ModelReading read_model(const std::string& path);

/// The same for a text; `path` names it in messages and determines the folder of the files it names.
ModelReading read_model_text(const std::string& text, const std::string& path);

/// The same for a text whose tree is known, with the diagnostics of its parsing.
ModelReading read_model_tree(std::shared_ptr<const YamlNode> tree, const Diagnostics& diagnostics,
                             const std::string& text, const std::string& path);

/// Reads a text that was read before and is stored with its results: the files that it names are not read, and checks
/// are not repeated. No description if keys are unknown, missing or of another kind.
ModelReading read_stored_model(const std::string& text, const std::string& path);

/// Reads a tree without the file of the vessel's motion, as needed for statics many times a second.
ModelReading read_statics_inputs(const YamlNode& root, const std::string& path);

}  // namespace overbend
