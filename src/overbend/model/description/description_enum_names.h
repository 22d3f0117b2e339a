/// Texts of the description's enumerations: the names of their values in the model file, its schema and messages.
#pragma once

#include <array>

#include "base/enum_names.h"
#include "model/description/check_settings.h"
#include "model/description/description.h"
#include "model/description/line_description.h"

namespace overbend {

template <>
inline constexpr std::array kEnumNames<MaterialLaw> = {
    Word{MaterialLaw::linear, "linear"},
    Word{MaterialLaw::moment_ramberg_osgood, "moment_ramberg_osgood"},
    Word{MaterialLaw::ramberg_osgood, "ramberg_osgood"},
    Word{MaterialLaw::bilinear, "bilinear"},
    Word{MaterialLaw::stress_strain, "stress_strain"},
    Word{MaterialLaw::moment_curvature, "moment_curvature"},
};

template <>
inline constexpr std::array kEnumNames<WaveType> = {
    Word{WaveType::none, "none"},
    Word{WaveType::airy, "airy"},
    Word{WaveType::stokes5, "stokes5"},
    Word{WaveType::jonswap, "jonswap"},
    Word{WaveType::pierson_moskowitz, "pierson_moskowitz"},
    Word{WaveType::ochi_hubble, "ochi_hubble"},
    Word{WaveType::torsethaugen, "torsethaugen"},
    Word{WaveType::user, "user"},
    Word{WaveType::elevation, "elevation"},
};

template <>
inline constexpr std::array kEnumNames<TorsethaugenModel> = {
    Word{TorsethaugenModel::simplified, "simplified"},
    Word{TorsethaugenModel::full, "full"},
};

template <>
inline constexpr std::array kEnumNames<VesselMotion> = {
    Word{VesselMotion::fixed, "fixed"},       Word{VesselMotion::raos, "raos"},
    Word{VesselMotion::history, "history"},   Word{VesselMotion::coupled, "coupled"},
    Word{VesselMotion::harmonic, "harmonic"},
};

template <>
inline constexpr std::array kEnumNames<Guide> = {Word{Guide::clamped, "clamped"}, Word{Guide::pinned, "pinned"}};

template <>
inline constexpr std::array kEnumNames<TensionerMode> = {
    Word{TensionerMode::controlled, "controlled"},
    Word{TensionerMode::locked, "locked"},
    Word{TensionerMode::constant, "constant"},
};

template <>
inline constexpr std::array kEnumNames<RollerDamping> = {
    Word{RollerDamping::clipped, "clipped"},
    Word{RollerDamping::textbook, "textbook"},
};

template <>
inline constexpr std::array kEnumNames<ImpactTreatment> = {
    Word{ImpactTreatment::resolved, "resolved"},
    Word{ImpactTreatment::captured, "captured"},
};

template <>
inline constexpr std::array kEnumNames<RollerStiffness> = {
    Word{RollerStiffness::physical, "physical"},
    Word{RollerStiffness::penalty, "penalty"},
};

template <>
inline constexpr std::array kEnumNames<Structure> = {Word{Structure::ramp, "ramp"},
                                                     Word{Structure::stinger, "stinger"}};

template <>
inline constexpr std::array kEnumNames<SupportContact> = {
    Word{SupportContact::rollers, "rollers"},
    Word{SupportContact::gap_springs, "gap_springs"},
};

template <>
inline constexpr std::array kEnumNames<StaticMethod> = {
    Word{StaticMethod::newton, "newton"},
    Word{StaticMethod::dynamic_relaxation, "dynamic_relaxation"},
};

template <>
inline constexpr std::array kEnumNames<LayHistory> = {
    Word{LayHistory::laying, "laying"},
    Word{LayHistory::monotonic, "monotonic"},
};

template <>
inline constexpr std::array kEnumNames<SeabedLayHistory> = {
    Word{SeabedLayHistory::steady, "steady"},
    Word{SeabedLayHistory::pulled_sideways, "static"},
};

template <>
inline constexpr std::array kEnumNames<RollerFriction> = {
    Word{RollerFriction::none, "none"},
    Word{RollerFriction::lay, "lay"},
    Word{RollerFriction::haul, "haul"},
};

template <>
inline constexpr std::array kEnumNames<BathymetryValues> = {
    Word{BathymetryValues::depth, "depth"},
    Word{BathymetryValues::elevation, "elevation"},
};

template <>
inline constexpr std::array kEnumNames<SoilModel> = {
    Word{SoilModel::linear, "linear"},
    Word{SoilModel::hyperbolic, "hyperbolic"},
    Word{SoilModel::bilinear, "bilinear"},
};

template <>
inline constexpr std::array kEnumNames<CheckCodes> = {
    Word{CheckCodes::both, "both"},
    Word{CheckCodes::dnv, "dnv"},
    Word{CheckCodes::api, "api"},
};

template <>
inline constexpr std::array kEnumNames<SafetyClass> = {
    Word{SafetyClass::low, "low"},
    Word{SafetyClass::medium, "medium"},
    Word{SafetyClass::high, "high"},
};

template <>
inline constexpr std::array kEnumNames<Manufacture> = {
    Word{Manufacture::seamless, "seamless"}, Word{Manufacture::erw, "erw"}, Word{Manufacture::hfw, "hfw"},
    Word{Manufacture::trb, "trb"},           Word{Manufacture::uo, "uo"},   Word{Manufacture::uoe, "uoe"},
};

template <>
inline constexpr std::array kEnumNames<YieldBasis> = {Word{YieldBasis::smys, "smys"}, Word{YieldBasis::fy, "fy"}};

template <>
inline constexpr std::array kEnumNames<ApiEdition> = {
    Word{ApiEdition::third, "third"},
    Word{ApiEdition::fourth, "fourth"},
    Word{ApiEdition::fifth, "fifth"},
};

template <>
inline constexpr std::array kEnumNames<CurrentLoad> = {
    Word{CurrentLoad::environmental, "environmental"},
    Word{CurrentLoad::functional, "functional"},
};

template <>
inline constexpr std::array kEnumNames<Radiation> = {
    Word{Radiation::state_space, "state_space"},
    Word{Radiation::convolution, "convolution"},
};

template <>
inline constexpr std::array kEnumNames<WaveDrift> = {
    Word{WaveDrift::none, "none"},
    Word{WaveDrift::mean, "mean"},
    Word{WaveDrift::newman, "newman"},
};

template <>
inline constexpr std::array kEnumNames<WaveDriftDamping> = {
    Word{WaveDriftDamping::none, "none"},
    Word{WaveDriftDamping::aranha, "aranha"},
};

template <>
inline constexpr std::array kEnumNames<Ballast> = {Word{Ballast::trim, "trim"}, Word{Ballast::as_given, "as_given"}};

template <>
inline constexpr std::array kEnumNames<HullCurrentModel> = {
    Word{HullCurrentModel::none, "none"},
    Word{HullCurrentModel::strips, "strips"},
    Word{HullCurrentModel::table, "table"},
    Word{HullCurrentModel::ufc, "ufc"},
};

template <>
inline constexpr std::array kEnumNames<CurrentRelativeTo> = {
    Word{CurrentRelativeTo::water, "water"},
    Word{CurrentRelativeTo::earth, "earth"},
};

template <>
inline constexpr std::array kEnumNames<CoefficientAxes> = {
    Word{CoefficientAxes::to_from_bow, "to_from_bow"},
    Word{CoefficientAxes::from_bow, "from_bow"},
    Word{CoefficientAxes::from_stern_ocimf, "from_stern_ocimf"},
};

template <>
inline constexpr std::array kEnumNames<RopeCore> = {Word{RopeCore::wire, "wire"}, Word{RopeCore::fibre, "fibre"}};

template <>
inline constexpr std::array kEnumNames<ChainLink> = {
    Word{ChainLink::studless, "studless"},
    Word{ChainLink::studlink, "studlink"},
};

template <>
inline constexpr std::array kEnumNames<PointKind> = {Word{PointKind::clump, "clump"}, Word{PointKind::buoy, "buoy"}};

template <>
inline constexpr std::array kEnumNames<BuoyShape> = {
    Word{BuoyShape::sphere, "sphere"},
    Word{BuoyShape::cylinder, "cylinder"},
};

template <>
inline constexpr std::array kEnumNames<LineEndKind> = {
    Word{LineEndKind::fixed, "fixed"},
    Word{LineEndKind::body, "body"},
    Word{LineEndKind::bed, "bed"},
    Word{LineEndKind::water, "water"},
};

template <>
inline constexpr std::array kEnumNames<MooringModel> = {
    Word{MooringModel::elements, "elements"},
    Word{MooringModel::quasi_static, "quasi_static"},
};

template <>
inline constexpr std::array kEnumNames<WinchMode> = {
    Word{WinchMode::hold, "hold"},
    Word{WinchMode::speed, "speed"},
    Word{WinchMode::length, "length"},
    Word{WinchMode::tension, "tension"},
};

template <>
inline constexpr std::array kEnumNames<FindMooring> = {
    Word{FindMooring::pose, "pose"},
    Word{FindMooring::lengths, "lengths"},
};

template <>
inline constexpr std::array kEnumNames<OperationType> = {
    Word{OperationType::none, "none"},
    Word{OperationType::moored, "moored"},
    Word{OperationType::pull_ahead, "pull_ahead"},
    Word{OperationType::anchor_move, "anchor_move"},
    Word{OperationType::anchor_plan, "anchor_plan"},
    Word{OperationType::abandonment, "abandonment"},
    Word{OperationType::recovery, "recovery"},
    Word{OperationType::lay_down, "lay_down"},
    Word{OperationType::start_up, "start_up"},
    Word{OperationType::move, "move"},
    Word{OperationType::passage, "passage"},
    Word{OperationType::ballast, "ballast"},
    Word{OperationType::lift, "lift"},
    Word{OperationType::shore_pull, "shore_pull"},
    Word{OperationType::hold_back, "hold_back"},
};

template <>
inline constexpr std::array kEnumNames<StageTension> = {
    Word{StageTension::hold, "hold"},
    Word{StageTension::bottom, "bottom"},
    Word{StageTension::seek, "seek"},
};

template <>
inline constexpr std::array kEnumNames<MoveShape> = {
    Word{MoveShape::trapezoid, "trapezoid"},
    Word{MoveShape::minimum_jerk, "minimum_jerk"},
    Word{MoveShape::zero_vibration, "zero_vibration"},
};

template <>
inline constexpr std::array kEnumNames<LayTableVary> = {
    Word{LayTableVary::tension, "tension"},
    Word{LayTableVary::lay_back, "lay_back"},
    Word{LayTableVary::depth, "depth"},
};

template <>
inline constexpr std::array kEnumNames<RouteTension> = {
    Word{RouteTension::hold, "hold"},
    Word{RouteTension::minimum, "least"},
};

/// Boolean as text.
template <>
inline constexpr std::array kEnumNames<bool> = {Word{false, "no"}, Word{true, "yes"}};

}  // namespace overbend
