#include "model/dynamic_assumptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/shown_unit.h"
#include "model/description/description_enum_names.h"
#include "model/site/sea_statistics.h"
#include "model/site/wave_groups.h"
#include "model/step_scales.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

void assume_time(Assumptions& list, const DynamicSettings& settings) {
  if (settings.build_up > 0.0) {
    list.push_back({AssumptionRank::setting, fmt::format("Waves and vessel motion are ramped up by half a cosine over "
                                                         "the {:.4g} s before t = 0; statistics start at t = 0.",
                                                         settings.build_up)});
  } else {
    list.push_back(
        {AssumptionRank::setting, "Waves and vessel motion start at full amplitude at t = 0, without build-up."});
  }
  list.push_back({AssumptionRank::other, "The current is that of the static analysis at all times."});
}

/// Returns the seeds of a run with these groups: of each group in a run without seeds.
std::string seed_label(const WaveGroups& groups, const WavesDescription& waves, const DynamicSettings& settings) {
  if (settings.seeds.size() > 1) {
    return fmt::format("seeds {}", fmt::join(settings.seeds, ", "));
  }
  const std::uint64_t run = settings.seeds.empty() ? default_seed(groups) : settings.seeds.front();
  return fmt::format("seed {}", waves.seed + (run - default_seed(groups)));
}

std::string gamma_label(const WavesDescription& waves) {
  return fmt::format("gamma = {:.3g} {}", waves.gamma.value_or(jonswap_gamma(waves.hs, waves.tp)),
                     waves.gamma ? "as given" : "from DNV-RP-C205");
}

std::string ochi_hubble_label(const WavesDescription& waves) {
  std::vector<std::string> parts;
  for (const SpectrumPart& part : waves.parts) {
    parts.push_back(
        fmt::format("Hs {}, Tp {:.4g} s and lambda {:.3g}", shown_digits(part.hs, "m", 4), part.tp, part.lambda));
  }
  return fmt::format("an Ochi-Hubble spectrum of two parts, with {}", fmt::join(parts, ", and "));
}

std::string spectrum_label(const WavesDescription& waves) {
  switch (waves.type) {
    case WaveType::jonswap:
      return "a JONSWAP spectrum with " + gamma_label(waves);
    case WaveType::pierson_moskowitz:
      return "a Pierson-Moskowitz spectrum";
    case WaveType::ochi_hubble:
      return ochi_hubble_label(waves);
    case WaveType::torsethaugen:
      return waves.model == TorsethaugenModel::full
                 ? "the spectrum of Torsethaugen's full model of 1996"
                 : "the spectrum of Torsethaugen's simplified double peak model of 2004";
    default:
      return "a user-defined spectrum from a file" +
             (waves.spectrum.empty() ? std::string() : ", with " + sea_statistics_label(waves.spectrum));
  }
}

std::string directions_label(const WavesDescription& waves) {
  if (!waves.directions.sectors.empty()) {
    return fmt::format(", with directions drawn from the {} sectors of the file", waves.directions.sectors.size());
  }
  if (!waves.directions.spreading.empty()) return ", with mean direction and spreading by frequency as in the file";
  const std::string mean = waves.directions.empty() ? "" : ", with mean direction by frequency as in the file";
  if (!waves.spreading) return waves.directions.empty() ? ", all in one direction" : mean + ", long-crested";
  return mean + fmt::format(", with directional spreading cos^2s of half the angle, s = {:.4g}", *waves.spreading);
}

void assume_period(Assumptions& list, const WavesDescription& waves) {
  if (!waves.tz) return;
  list.push_back({AssumptionRank::setting,
                  fmt::format("The peak period of {:.4g} s is that of a {} spectrum{} with the zero up-crossing period "
                              "of {:.4g} s, by integrals over all frequencies.",
                              waves.tp, waves.type == WaveType::jonswap ? "JONSWAP" : "Pierson-Moskowitz",
                              waves.type == WaveType::jonswap ? " with " + gamma_label(waves) : "", *waves.tz)});
}

void assume_sea(Assumptions& list, const WaveGroups& groups, const WavesDescription& waves,
                const DynamicSettings& settings) {
  const bool only = groups.size() == 1;
  list.push_back({AssumptionRank::setting, fmt::format("{} has {}.", only ? "The sea" : "It", spectrum_label(waves))});
  assume_period(list, waves);
  list.push_back({AssumptionRank::setting,
                  fmt::format("It is the sum of {} linear waves with random frequencies and phases, {}{}.",
                              waves.components, seed_label(groups, waves, settings), directions_label(waves))});
  if (waves.type == WaveType::torsethaugen) {
    list.push_back(
        {AssumptionRank::other,
         fmt::format("Torsethaugen's peaks are normalised by the factors of the publication and not rescaled: "
                     "the significant wave height differs from the given one by up to {} %.",
                     waves.model == TorsethaugenModel::full ? "2" : "1.2")});
  }
}

void assume_record(Assumptions& list, const WavesDescription& waves) {
  const SeaStatistics sea = record_statistics(waves.record);
  list.push_back({AssumptionRank::setting,
                  fmt::format("The sea is a measured elevation of {:.4g} s with Hs {}, Tz {:.3g} s, as the sum of its "
                              "Fourier components: linear waves in one direction that meet the record at its point.",
                              waves.record.duration(), shown_digits(sea.hs, "m", 3), sea.tz)});
  list.push_back(
      {AssumptionRank::governing,
       "Before and after the record the sea repeats it, with a gap of some 20 s that leads from its end back "
       "to its beginning; waves shorter than 0.5 s are left out."});
}

void assume_group(Assumptions& list, const WaveGroups& groups, const WavesDescription& waves,
                  const DynamicSettings& settings) {
  switch (waves.type) {
    case WaveType::none:
      break;
    case WaveType::stokes5:
      list.push_back({AssumptionRank::setting,
                      "The regular wave follows Stokes' fifth-order theory, with zero mean Eulerian current."});
      break;
    case WaveType::airy:
      list.push_back({AssumptionRank::setting, "The regular wave is linear."});
      break;
    case WaveType::elevation:
      assume_record(list, waves);
      break;
    default:
      assume_sea(list, groups, waves, settings);
  }
  for (const Assumption& assumption : waves.assumptions) list.push_back(assumption);
}

/// Appends the sentences of one group of several, with its number and type in front.
void assume_numbered_group(Assumptions& list, const WaveGroups& groups, std::size_t index,
                           const DynamicSettings& settings) {
  Assumptions of_group;
  assume_group(of_group, groups, groups[index], settings);
  for (const Assumption& assumption : of_group) {
    list.push_back(
        {assumption.rank, fmt::format("Waves {} ({}): {}", index + 1, enum_name(groups[index].type), assumption.text)});
  }
}

void assume_groups(Assumptions& list, const WaveGroups& groups, const DynamicSettings& settings) {
  if (groups.size() == 1) return assume_group(list, groups, groups.front(), settings);
  const double hs = significant_height(groups);
  list.push_back({AssumptionRank::setting,
                  fmt::format("The sea is the sum of {} groups of waves{}; each has random numbers of its own.",
                              groups.size(), hs > 0.0 ? " with Hs " + shown_digits(hs, "m", 4) + " together" : "")});
  for (std::size_t i = 0; i < groups.size(); ++i) assume_numbered_group(list, groups, i, settings);
}

void assume_waves(Assumptions& list, const Model& model, const DynamicSettings& settings) {
  const WaveGroups& groups = model.description.environment.waves;
  if (is_calm(groups)) {
    list.push_back({AssumptionRank::governing, "There are no waves."});
    return;
  }
  assume_groups(list, groups, settings);
  if (groups.size() > 1 || groups.front().type != WaveType::stokes5) {
    list.push_back(
        {AssumptionRank::other, "The kinematics of linear waves are extended to the surface by Wheeler stretching."});
  }
  list.push_back({AssumptionRank::other, fmt::format("The waves are those of a constant water depth, that at the stern "
                                                     "shoe, {}; pipe and vessel do not disturb them.",
                                                     shown(model.description.environment.water_depth, "m", 2))});
}

void assume_vessel_motion(Assumptions& list, const VesselDescription& vessel) {
  static const std::map<VesselMotion, Assumption> kSaid{
      {VesselMotion::fixed, {AssumptionRank::governing, "The vessel is fixed."}},
      {VesselMotion::harmonic,
       {AssumptionRank::setting, "The vessel moves harmonically as given, independent of the waves."}},
      {VesselMotion::history, {AssumptionRank::setting, "The vessel moves as recorded, independent of the waves."}},
  };
  const auto said = kSaid.find(vessel.motion);
  if (said != kSaid.end()) list.push_back(said->second);
  if (vessel.history && vessel.history->passages > 0) {
    list.push_back({AssumptionRank::other,
                    fmt::format("The recorded angles wrap around the full circle {} times; they are made continuous.",
                                vessel.history->passages)});
  }
}

void assume_water_forces(Assumptions& list, const Model& model) {
  const Section& pipe = model.pipe_section();
  list.push_back({AssumptionRank::setting,
                  fmt::format("Morison's coefficients do not depend on speed, frequency or distance from the seabed: "
                              "drag {:.3g} normal and {:.3g} axial, added mass {:.3g} normal and {:.3g} axial.",
                              pipe.drag_normal, pipe.drag_axial, pipe.added_mass_normal, pipe.added_mass_axial)});
}

void assume_rollers(Assumptions& list, const Model& model, const DynamicSettings& settings) {
  if (model.supports.rollers.empty()) {
    return;
  }
  if (model.description.supports.contact == SupportContact::rollers) {
    list.push_back(
        {AssumptionRank::governing,
         "Hard impacts amplify the smallest differences: the largest force of a single impact, and its effect on "
         "tension and stress, are valid for this run only. Means are reproducible; several seeds show the scatter."});
    bool textbook = false, tenth = false;
    for (const Roller& roller : model.supports.rollers) {
      textbook = textbook || roller.damping == RollerDamping::textbook;
      tenth = tenth || roller.tangential_stiffness <= 0.0;
    }
    list.push_back(
        {AssumptionRank::other,
         "Roller damping follows from the coefficient of restitution and the participating mass, that of 2.5 "
         "(EI/k)^(1/3) of pipe, which bending waves reach during the contact, with added mass under water."});
    if (textbook) {
      list.push_back({AssumptionRank::other,
                      "For rollers with textbook damping, rebounds are faster than the coefficient of restitution, "
                      "because no roller pulls the pipe back."});
    }
    if (tenth) {
      list.push_back(
          {AssumptionRank::other,
           fmt::format("The tangential stiffness of a roller, if not given, is {:.3g} of the normal stiffness.",
                       kTangentialStiffnessRatio)});
    }
    list.push_back(
        {AssumptionRank::other, model.description.statics.roller_friction == RollerFriction::none
                                    ? "Roller friction acts in the dynamic analysis, but not in the static "
                                      "initial state: it is mobilised by the motion only."
                                    : "Roller friction acts in the dynamic analysis. Its initial state is that of "
                                      "statics, full along the pipe, and it follows the motion from there."});
  }
  if (settings.impacts == ImpactTreatment::captured) {
    list.push_back(
        {AssumptionRank::governing,
         "Impacts are captured, not resolved: steps stay long, rebounds are damped out, and the peak force is that of "
         "the participating mass on an undamped roller plus the static roller force after the step. Stresses, and the "
         "histories, percentiles and extremes over hours of reactions, are those at the ends of steps, without these "
         "peaks. For screening; 'overbend compare --of impacts' shows the difference."});
  }
  list.push_back({AssumptionRank::setting,
                  fmt::format("Impacts weaker than {} are neither {} nor recorded.",
                              shown_digits(settings.impact_force.value_or(step_scales(model).force), "N", 4),
                              settings.impacts == ImpactTreatment::captured ? "counted" : "resolved")});
  list.push_back({AssumptionRank::other,
                  "Dents follow from the relation of DNV-RP-F107 for bare steel, which neglects the effects of "
                  "coatings, pressure, tension and bending."});
}

std::string tensioner_sentence(const TensionerDescription& t) {
  std::string text = fmt::format(
      "The tensioner waits {:.4g} s when the tension has left its range of {} to {}, then moves at up to {} until the "
      "set tension is restored",
      t.delay, shown_digits_number(t.range_low.value_or(0.0), shown_unit("N"), 4),
      shown_digits(t.range_high.value_or(0.0), "N", 4), shown_digits(t.velocity, "m/s", 4));
  text += t.acceleration
              ? fmt::format("; it accelerates and brakes at {}", shown_digits(*t.acceleration, "m/s2", 4))
              : std::string("; no acceleration is given: it reaches that speed in 0.5 s and brakes likewise");
  text += t.travel ? fmt::format("; its travel is limited to {} either way.", shown_digits(*t.travel, "m", 4))
                   : std::string("; its travel is not limited.");
  return text;
}

/// Returns true if the steps resolve the axial vibrations of the pipe that trigger the tensioner, see
/// docs/theory/dynamics.md.
bool follows_axial_vibrations(const DynamicSettings& settings) {
  constexpr double kMaxResolvingStep = 0.02;  // s
  return settings.step.value_or(settings.max_step.value_or(1.0)) <= kMaxResolvingStep;
}

void assume_held_top(Assumptions& list, const TensionerDescription& tensioner, const DynamicSettings& settings) {
  switch (tensioner.mode) {
    case TensionerMode::controlled:
      list.push_back({AssumptionRank::setting, tensioner_sentence(tensioner)});
      list.push_back(
          {AssumptionRank::other,
           "During the build-up the speed limit of the tensioner is reduced by the same factor as the waves."});
      if (!follows_axial_vibrations(settings)) {
        list.push_back(
            {AssumptionRank::other,
             "The time integration damps axial vibrations of the pipe that its steps do not resolve; such vibrations "
             "make a tensioner act more often. In the BGL-1 example in a regular wave, steps of at most 20 ms "
             "(analysis.dynamic.max_step) raise the largest tension by 2 % and its standard deviation by 3 to 8 %."});
      }
      break;
    case TensionerMode::constant:
      list.push_back({AssumptionRank::governing,
                      "The tensioner keeps the tension constant, without mass, friction, delay or limit: an ideal "
                      "machine for comparison."});
      break;
    case TensionerMode::locked:
      list.push_back({AssumptionRank::governing,
                      "In the dynamic analysis the tensioner is a locked brake that moves with the vessel."});
      return;
  }
  list.push_back({AssumptionRank::other,
                  "Pay-out moves the top end of the pipe along the guide; mass and weight of the pipe behind the "
                  "tensioner are neglected."});
}

/// Each section has its own material law.
void assume_steel(Assumptions& list, const Model& model) {
  const auto yields = [](const Section& section) { return section.bending.has_value(); };
  const bool any = std::any_of(model.sections.begin(), model.sections.end(), yields);
  if (any) {
    list.push_back({AssumptionRank::other,
                    "Yielding in the dynamic analysis continues from the plastic state of the static analysis; its "
                    "dissipation is part of the energy balance."});
  }
  if (!std::all_of(model.sections.begin(), model.sections.end(), yields)) {
    list.push_back(any ? Assumption{AssumptionRank::other,
                                    "Sections of linear steel stay linear in the dynamic analysis: their stress beyond "
                                    "yield is reported, not limited."}
                       : Assumption{AssumptionRank::governing,
                                    "The steel stays linear in the dynamic analysis as well: stress beyond yield is "
                                    "reported, not limited."});
  }
}

void assume_laid_pipe(Assumptions& list, const Model& model) {
  constexpr double kMaxLaidLength = 3000.0;  // [m], equal to kMaxTailLength of dynamics/laid_tail.h
  if (model.description.pipe.length) return;
  if (model.seabed.surface.shape() != nullptr) {
    list.push_back({AssumptionRank::other, "On an uneven seabed the laid pipe is held at the end of the static line."});
    return;
  }
  list.push_back(
      {AssumptionRank::other,
       model.seabed.friction_axial > 0.0
           ? fmt::format("The laid pipe is extended behind the static line by the length over which axial friction "
                         "balances the tension at the tensioner, {} at most.",
                         shown_digits(kMaxLaidLength, route_length(), 4))
           : "The seabed has no axial friction: the laid pipe is held at the end of the static line, and changes of "
             "tension depend on that length (give environment.seabed.friction to have it determined)."});
}

void assume_turning_stinger(Assumptions& list, const SupportsDescription& supports) {
  bool floats = false, stops = false;
  for (const StingerSectionDescription& section : supports.sections) {
    floats = floats || (section.floats() && !section.angle);
    stops = stops || section.limits;
  }
  if (!floats) {
    return;
  }
  list.push_back({AssumptionRank::other,
                  "The stinger rotates about its hinges during the dynamic analysis. Its tanks are strips with "
                  "buoyancy up to the instantaneous surface and Morison forces normal to their axis; the current on "
                  "them is ramped up with the waves. Ballast water does not move in its tank; slamming, and the waves "
                  "radiated by the tanks, are neglected."});
  if (stops) {
    list.push_back({AssumptionRank::other,
                    "The stinger's stops are springs with 5 % of critical damping: it rebounds with about 85 % of its "
                    "impact speed."});
  }
}

}  // namespace

void assume_dynamics(Assumptions& list, const Model& model) {
  const DynamicSettings settings = model.description.dynamics.value_or(DynamicSettings{});
  assume_time(list, settings);
  assume_waves(list, model, settings);
  assume_vessel_motion(list, model.description.vessel);
  assume_water_forces(list, model);
  assume_laid_pipe(list, model);
  assume_held_top(list, model.description.tensioner, settings);
  assume_rollers(list, model, settings);
  assume_turning_stinger(list, model.description.supports);
  assume_steel(list, model);
}

}  // namespace overbend
