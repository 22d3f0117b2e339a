/// Texts of the study enumerations in the study file.
#pragma once

#include <array>

#include "base/enum_names.h"
#include "model/description/study_description.h"

namespace overbend {

template <>
inline constexpr std::array kEnumNames<StudyAnalysis> = {
    Word{StudyAnalysis::statics, "static"},
    Word{StudyAnalysis::dynamic, "dynamic"},
    Word{StudyAnalysis::operation, "operation"},
    Word{StudyAnalysis::seek, "seek"},
};

template <>
inline constexpr std::array kEnumNames<ScatterPeriod> = {
    Word{ScatterPeriod::tp, "tp"},
    Word{ScatterPeriod::tz, "tz"},
};

template <>
inline constexpr std::array kEnumNames<Distribution> = {
    Word{Distribution::uniform, "uniform"},     Word{Distribution::normal, "normal"},
    Word{Distribution::lognormal, "lognormal"}, Word{Distribution::triangular, "triangular"},
    Word{Distribution::weibull, "weibull"},
};

}  // namespace overbend
