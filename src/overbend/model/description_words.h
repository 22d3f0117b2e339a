/// The words of the description's enumerations: what the model file, its schema and messages call their enumerators.
#pragma once

#include <array>

#include "base/words.h"
#include "model/check_settings.h"
#include "model/description.h"

namespace overbend {

template <>
inline constexpr std::array kWords<MaterialLaw> = {
    Word{MaterialLaw::linear, "linear"},
    Word{MaterialLaw::moment_ramberg_osgood, "moment_ramberg_osgood"},
    Word{MaterialLaw::ramberg_osgood, "ramberg_osgood"},
    Word{MaterialLaw::bilinear, "bilinear"},
    Word{MaterialLaw::stress_strain, "stress_strain"},
    Word{MaterialLaw::moment_curvature, "moment_curvature"},
};

template <>
inline constexpr std::array kWords<WaveType> = {
    Word{WaveType::none, "none"},
    Word{WaveType::airy, "airy"},
    Word{WaveType::stokes5, "stokes5"},
    Word{WaveType::jonswap, "jonswap"},
    Word{WaveType::pierson_moskowitz, "pierson_moskowitz"},
    Word{WaveType::user, "user"},
};

template <>
inline constexpr std::array kWords<VesselMotion> = {
    Word{VesselMotion::fixed, "fixed"},       Word{VesselMotion::raos, "raos"},
    Word{VesselMotion::history, "history"},   Word{VesselMotion::coupled, "coupled"},
    Word{VesselMotion::harmonic, "harmonic"},
};

template <>
inline constexpr std::array kWords<Guide> = {Word{Guide::clamped, "clamped"}, Word{Guide::pinned, "pinned"}};

template <>
inline constexpr std::array kWords<TensionerMode> = {
    Word{TensionerMode::controlled, "controlled"},
    Word{TensionerMode::locked, "locked"},
    Word{TensionerMode::constant, "constant"},
};

template <>
inline constexpr std::array kWords<RollerDamping> = {
    Word{RollerDamping::clipped, "clipped"},
    Word{RollerDamping::textbook, "textbook"},
};

template <>
inline constexpr std::array kWords<RollerStiffness> = {
    Word{RollerStiffness::physical, "physical"},
    Word{RollerStiffness::penalty, "penalty"},
};

template <>
inline constexpr std::array kWords<Structure> = {Word{Structure::ramp, "ramp"}, Word{Structure::stinger, "stinger"}};

template <>
inline constexpr std::array kWords<SupportContact> = {
    Word{SupportContact::rollers, "rollers"},
    Word{SupportContact::gap_springs, "gap_springs"},
};

template <>
inline constexpr std::array kWords<StaticMethod> = {
    Word{StaticMethod::newton, "newton"},
    Word{StaticMethod::dynamic_relaxation, "dynamic_relaxation"},
};

template <>
inline constexpr std::array kWords<LayHistory> = {
    Word{LayHistory::laying, "laying"},
    Word{LayHistory::monotonic, "monotonic"},
};

template <>
inline constexpr std::array kWords<CheckCodes> = {
    Word{CheckCodes::both, "both"},
    Word{CheckCodes::dnv, "dnv"},
    Word{CheckCodes::api, "api"},
};

template <>
inline constexpr std::array kWords<SafetyClass> = {
    Word{SafetyClass::low, "low"},
    Word{SafetyClass::medium, "medium"},
    Word{SafetyClass::high, "high"},
};

template <>
inline constexpr std::array kWords<Manufacture> = {
    Word{Manufacture::seamless, "seamless"}, Word{Manufacture::erw, "erw"}, Word{Manufacture::hfw, "hfw"},
    Word{Manufacture::trb, "trb"},           Word{Manufacture::uo, "uo"},   Word{Manufacture::uoe, "uoe"},
};

template <>
inline constexpr std::array kWords<YieldBasis> = {Word{YieldBasis::smys, "smys"}, Word{YieldBasis::fy, "fy"}};

template <>
inline constexpr std::array kWords<ApiEdition> = {
    Word{ApiEdition::third, "third"},
    Word{ApiEdition::fourth, "fourth"},
    Word{ApiEdition::fifth, "fifth"},
};

template <>
inline constexpr std::array kWords<CurrentLoad> = {
    Word{CurrentLoad::environmental, "environmental"},
    Word{CurrentLoad::functional, "functional"},
};

/// A plain yes or no.
template <>
inline constexpr std::array kWords<bool> = {Word{false, "no"}, Word{true, "yes"}};

}  // namespace overbend
