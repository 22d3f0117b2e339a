/// Reader of study files and their base models.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/description/description.h"
#include "model/description/study_description.h"

namespace overbend {

struct StudyReading {
  std::optional<StudyDescription> study;  ///< Both only if there is no error.
  std::optional<Description> base;
  Diagnostics diagnostics;
};

/// Reads a study file as strictly as a model file: units, ranges and key names are checked against the base model. All
/// errors are reported at once. Never throws because of the files' contents.
StudyReading read_study_file(const std::string& path);

/// The same for a text; `path` names it in messages and determines the folder of the files it names.
StudyReading read_study_text(const std::string& text, const std::string& path);

/// The same with a base model that has been read, whichever file the text names.
StudyReading read_study_with_base(const std::string& text, const std::string& path, Description base);

}  // namespace overbend
