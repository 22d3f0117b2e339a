/// Reads a study file, and the base model that it names.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/description.h"
#include "model/description/study_description.h"

namespace overbend {

struct StudyReading {
  std::optional<StudyDescription> study;  ///< Both only when there is no error.
  std::optional<Description> base;
  Diagnostics diagnostics;
};

/// Strict as the model file: units, ranges and names of keys are held to the base model's. Everything that is wrong is
/// told at once. Never throws on what the files hold.
StudyReading read_study_file(const std::string& path);

/// The same for a text; `path` names it in messages and gives the folder of the files it mentions.
StudyReading read_study_text(const std::string& text, const std::string& path);

/// The same of a base model that has been read already, whatever file the text names.
StudyReading read_study_of(const std::string& text, const std::string& path, Description base);

}  // namespace overbend
