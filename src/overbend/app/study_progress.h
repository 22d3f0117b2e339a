/// Runs a study with progress on the terminal and handling of Ctrl-C.
#pragma once

#include <filesystem>
#include <string>

#include "study/seeds/study.h"

namespace overbend {

/// Runs the plan with progress on stderr until it ends or is interrupted. `noun` names the cases, e.g. "seeds".
StudyOutcome follow_study(const Description& base, const StudyPlan& plan, const std::filesystem::path& folder,
                          const CaseOptions& options, const std::string& noun);

}  // namespace overbend
