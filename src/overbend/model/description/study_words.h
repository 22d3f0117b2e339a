/// The words of a study's enumerations, as the study file writes them.
#pragma once

#include <array>

#include "base/words.h"
#include "model/description/study_description.h"

namespace overbend {

template <>
inline constexpr std::array kWords<StudyAnalysis> = {
    Word{StudyAnalysis::statics, "static"},
    Word{StudyAnalysis::dynamic, "dynamic"},
    Word{StudyAnalysis::operation, "operation"},
    Word{StudyAnalysis::seek, "seek"},
};

template <>
inline constexpr std::array kWords<Distribution> = {
    Word{Distribution::uniform, "uniform"},     Word{Distribution::normal, "normal"},
    Word{Distribution::lognormal, "lognormal"}, Word{Distribution::triangular, "triangular"},
    Word{Distribution::weibull, "weibull"},
};

}  // namespace overbend
