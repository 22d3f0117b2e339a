/// Texts of the fatigue enumerations in the model file and results.
#pragma once

#include <array>

#include "base/enum_names.h"
#include "model/description/fatigue_description.h"

namespace overbend {

template <>
inline constexpr std::array kEnumNames<FatigueCurve> = {
    Word{FatigueCurve::b1, "B1"}, Word{FatigueCurve::b2, "B2"}, Word{FatigueCurve::c, "C"},
    Word{FatigueCurve::c1, "C1"}, Word{FatigueCurve::c2, "C2"}, Word{FatigueCurve::d, "D"},
    Word{FatigueCurve::e, "E"},   Word{FatigueCurve::f, "F"},   Word{FatigueCurve::f1, "F1"},
    Word{FatigueCurve::f3, "F3"}, Word{FatigueCurve::g, "G"},   Word{FatigueCurve::w1, "W1"},
    Word{FatigueCurve::w2, "W2"}, Word{FatigueCurve::w3, "W3"},
};

template <>
inline constexpr std::array kEnumNames<FatigueEdition> = {
    Word{FatigueEdition::year_2016, "2016"},
    Word{FatigueEdition::year_2024, "2024"},
};

template <>
inline constexpr std::array kEnumNames<FatigueMedium> = {
    Word{FatigueMedium::air, "air"},
    Word{FatigueMedium::seawater_protected, "seawater_protected"},
    Word{FatigueMedium::seawater_free, "seawater_free"},
};

enum class FatigueSurface { outside, inside };

template <>
inline constexpr std::array kEnumNames<FatigueSurface> = {
    Word{FatigueSurface::outside, "outside"},
    Word{FatigueSurface::inside, "inside"},
};

}  // namespace overbend
