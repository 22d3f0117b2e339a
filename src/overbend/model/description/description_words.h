/// The words of the description's enumerations: what the model file, its schema and messages call their enumerators.
#pragma once

#include <array>

#include "base/words.h"
#include "model/description/check_settings.h"
#include "model/description/description.h"
#include "model/description/line_description.h"

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
inline constexpr std::array kWords<ImpactTreatment> = {
    Word{ImpactTreatment::resolved, "resolved"},
    Word{ImpactTreatment::captured, "captured"},
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
inline constexpr std::array kWords<Laying> = {
    Word{Laying::steady, "steady"},
    Word{Laying::pulled_across, "static"},
};

template <>
inline constexpr std::array kWords<RollerFriction> = {
    Word{RollerFriction::none, "none"},
    Word{RollerFriction::lay, "lay"},
    Word{RollerFriction::haul, "haul"},
};

template <>
inline constexpr std::array kWords<SoilModel> = {
    Word{SoilModel::linear, "linear"},
    Word{SoilModel::hyperbolic, "hyperbolic"},
    Word{SoilModel::bilinear, "bilinear"},
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

template <>
inline constexpr std::array kWords<Radiation> = {
    Word{Radiation::state_space, "state_space"},
    Word{Radiation::convolution, "convolution"},
};

template <>
inline constexpr std::array kWords<WaveDrift> = {
    Word{WaveDrift::none, "none"},
    Word{WaveDrift::mean, "mean"},
    Word{WaveDrift::newman, "newman"},
};

template <>
inline constexpr std::array kWords<WaveDriftDamping> = {
    Word{WaveDriftDamping::none, "none"},
    Word{WaveDriftDamping::aranha, "aranha"},
};

template <>
inline constexpr std::array kWords<Ballast> = {Word{Ballast::trim, "trim"}, Word{Ballast::as_given, "as_given"}};

template <>
inline constexpr std::array kWords<HullCurrentForm> = {
    Word{HullCurrentForm::none, "none"},
    Word{HullCurrentForm::strips, "strips"},
    Word{HullCurrentForm::table, "table"},
    Word{HullCurrentForm::ufc, "ufc"},
};

template <>
inline constexpr std::array kWords<CurrentRelativeTo> = {
    Word{CurrentRelativeTo::water, "water"},
    Word{CurrentRelativeTo::earth, "earth"},
};

template <>
inline constexpr std::array kWords<CoefficientAxes> = {
    Word{CoefficientAxes::to_from_bow, "to_from_bow"},
    Word{CoefficientAxes::from_bow, "from_bow"},
    Word{CoefficientAxes::from_stern_ocimf, "from_stern_ocimf"},
};

template <>
inline constexpr std::array kWords<RopeCore> = {Word{RopeCore::wire, "wire"}, Word{RopeCore::fibre, "fibre"}};

template <>
inline constexpr std::array kWords<ChainLink> = {
    Word{ChainLink::studless, "studless"},
    Word{ChainLink::studlink, "studlink"},
};

template <>
inline constexpr std::array kWords<PointKind> = {Word{PointKind::clump, "clump"}, Word{PointKind::buoy, "buoy"}};

template <>
inline constexpr std::array kWords<BuoyShape> = {
    Word{BuoyShape::sphere, "sphere"},
    Word{BuoyShape::cylinder, "cylinder"},
};

template <>
inline constexpr std::array kWords<LineEndKind> = {
    Word{LineEndKind::fixed, "fixed"},
    Word{LineEndKind::body, "body"},
    Word{LineEndKind::bed, "bed"},
    Word{LineEndKind::water, "water"},
};

template <>
inline constexpr std::array kWords<MooringModel> = {
    Word{MooringModel::elements, "elements"},
    Word{MooringModel::quasi_static, "quasi_static"},
};

template <>
inline constexpr std::array kWords<WinchMode> = {
    Word{WinchMode::hold, "hold"},
    Word{WinchMode::speed, "speed"},
    Word{WinchMode::length, "length"},
    Word{WinchMode::tension, "tension"},
};

template <>
inline constexpr std::array kWords<FindMooring> = {
    Word{FindMooring::pose, "pose"},
    Word{FindMooring::lengths, "lengths"},
};

template <>
inline constexpr std::array kWords<OperationType> = {
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
inline constexpr std::array kWords<StageTension> = {
    Word{StageTension::hold, "hold"},
    Word{StageTension::bottom, "bottom"},
    Word{StageTension::seek, "seek"},
};

template <>
inline constexpr std::array kWords<MoveShape> = {
    Word{MoveShape::trapezoid, "trapezoid"},
    Word{MoveShape::minimum_jerk, "minimum_jerk"},
    Word{MoveShape::zero_vibration, "zero_vibration"},
};

template <>
inline constexpr std::array kWords<LayTableVary> = {
    Word{LayTableVary::tension, "tension"},
    Word{LayTableVary::lay_back, "lay_back"},
    Word{LayTableVary::depth, "depth"},
};

template <>
inline constexpr std::array kWords<RouteTension> = {
    Word{RouteTension::hold, "hold"},
    Word{RouteTension::least, "least"},
};

/// A plain yes or no.
template <>
inline constexpr std::array kWords<bool> = {Word{false, "no"}, Word{true, "yes"}};

}  // namespace overbend
