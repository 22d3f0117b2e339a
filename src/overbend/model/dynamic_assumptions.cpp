#include "model/dynamic_assumptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "model/wave_theory.h"

namespace overbend {
namespace {

using Sentences = std::vector<std::string>;

void assume_time(Sentences& list, const DynamicSettings& settings) {
  if (settings.build_up > 0.0) {
    list.push_back(fmt::format(
        "Waves and vessel motion grow by half a cosine over the {:.4g} s before t = 0; statistics count from "
        "t = 0.",
        settings.build_up));
  } else {
    list.push_back("Waves and vessel motion begin at full size at t = 0, without build-up.");
  }
  list.push_back("The current is as in statics, at every time.");
}

std::string seed_words(const WavesDescription& waves, const DynamicSettings& settings) {
  if (settings.seeds.size() > 1) {
    return fmt::format("seeds {}", fmt::join(settings.seeds, ", "));
  }
  return fmt::format("seed {}", settings.seeds.empty() ? waves.seed : settings.seeds.front());
}

std::string spectrum_words(const WavesDescription& waves) {
  switch (waves.type) {
    case WaveType::jonswap: {
      const double gamma = waves.gamma.value_or(jonswap_gamma(waves.hs, waves.tp));
      return fmt::format("a JONSWAP spectrum with gamma = {:.3g} {}", gamma,
                         waves.gamma ? "as given" : "by the rule of DNV-RP-C205");
    }
    case WaveType::pierson_moskowitz:
      return "a Pierson-Moskowitz spectrum";
    default:
      return "the spectrum of the user's file";
  }
}

void assume_sea(Sentences& list, const WavesDescription& waves, const DynamicSettings& settings) {
  list.push_back(fmt::format("The sea has {}.", spectrum_words(waves)));
  list.push_back(fmt::format(
      "It is the sum of {} linear waves with random frequencies and phases, {}{}.", waves.components,
      seed_words(waves, settings),
      waves.spreading
          ? fmt::format(", their directions spread as cos^2s of half the angle with s = {:.4g}", *waves.spreading)
          : ", all of one direction"));
}

void assume_waves(Sentences& list, const Model& model, const DynamicSettings& settings) {
  const WavesDescription& waves = model.description.environment.waves;
  if (waves.type == WaveType::none) {
    list.push_back("There are no waves.");
    return;
  }
  if (waves.type == WaveType::stokes5) {
    list.push_back("The regular wave follows Stokes' theory of the fifth order, without a current of its own.");
  } else {
    if (waves.type == WaveType::airy) {
      list.push_back("The regular wave is linear.");
    } else {
      assume_sea(list, waves, settings);
    }
    list.push_back("Wheeler's stretching brings the motion of linear waves up to the surface.");
  }
  list.push_back(fmt::format(
      "The waves run over a level bed in the water depth at the stern shoe, {:.2f} m; pipe and vessel do not "
      "disturb them.",
      model.description.environment.water_depth));
}

void assume_vessel_motion(Sentences& list, const VesselDescription& vessel) {
  static const std::map<VesselMotion, const char*> kWords{
      {VesselMotion::fixed, "The vessel does not move."},
      {VesselMotion::harmonic, "The vessel moves harmonically as given, whatever the waves."},
      {VesselMotion::history, "The vessel moves as recorded, whatever the waves."},
  };
  const auto words = kWords.find(vessel.motion);
  if (words != kWords.end()) {
    list.push_back(words->second);
  }
}

void assume_water_forces(Sentences& list, const Model& model) {
  const Section& pipe = model.sections.front();
  list.push_back(fmt::format(
      "Morison's coefficients do not depend on speed, frequency or the nearness of the bed: drag {:.3g} across and "
      "{:.3g} along the pipe, added mass {:.3g} across and {:.3g} along.",
      pipe.drag_normal, pipe.drag_axial, pipe.added_mass_normal, pipe.added_mass_axial));
}

void assume_rollers(Sentences& list, const Model& model, const DynamicSettings& settings) {
  if (model.supports.rollers.empty()) {
    return;
  }
  if (model.description.supports.contact == SupportContact::rollers) {
    list.push_back(
        "Hard impacts make the smallest differences grow: the largest force of a single impact, and what it does to "
        "tension and stress, are those of this one run. Means hold; several seeds show the scatter.");
    bool textbook = false, tenth = false;
    for (const Roller& roller : model.supports.rollers) {
      textbook = textbook || roller.damping == RollerDamping::textbook;
      tenth = tenth || roller.tangential_stiffness <= 0.0;
    }
    list.push_back(
        "The damping of a roller gives its coefficient of restitution to the mass of pipe that bending waves reach "
        "within the contact, 2.5 (EI/k)^(1/3) of its length, with added mass under water.");
    if (textbook) {
      list.push_back(
          "Where a roller's damping is by the textbook, its rebounds are faster than the coefficient of restitution "
          "says, because no roller pulls the pipe back.");
    }
    if (tenth) {
      list.push_back(
          fmt::format("Where no tangential stiffness of a roller is given, it is {:.3g} of the normal stiffness.",
                      kTangentialShare));
    }
    list.push_back(
        "The friction of rollers acts in time, but not in the static start: it is mobilised by the motion alone.");
  }
  list.push_back(fmt::format("Impacts weaker than {:.4g} kN are neither resolved in time nor recorded.",
                             1e-3 * settings.impact_force));
  list.push_back(
      "Dents follow from the relation of DNV-RP-F107 for bare steel, which leaves out what coatings, pressure, tension "
      "and bending do.");
}

std::string machine_words(const TensionerDescription& t) {
  std::string words = fmt::format(
      "The tensioner waits {:.4g} s when the tension has left its range of {:.4g} to {:.4g} kN, then moves at up to "
      "{:.4g} m/s until the tension it wants is back",
      t.delay, 1e-3 * t.range_low.value_or(0.0), 1e-3 * t.range_high.value_or(0.0), t.velocity);
  words += t.acceleration ? fmt::format("; it gathers speed and brakes at {:.4g} m/s2", *t.acceleration)
                          : std::string("; no acceleration is given: it gathers that speed in 0.5 s and brakes alike");
  words += t.travel ? fmt::format("; its travel ends {:.4g} m either way.", *t.travel)
                    : std::string("; its travel is not limited.");
  return words;
}

void assume_held_top(Sentences& list, const TensionerDescription& tensioner) {
  switch (tensioner.mode) {
    case TensionerMode::controlled:
      list.push_back(machine_words(tensioner));
      list.push_back(
          "During the build-up the tensioner is brought in with the waves: it may use the same share of its speed.");
      break;
    case TensionerMode::constant:
      list.push_back(
          "The tensioner keeps the tension constant, without mass, friction, delay or limit: an ideal to compare "
          "with.");
      break;
    case TensionerMode::locked:
      list.push_back("In time the tensioner is a locked brake that moves with the vessel.");
      return;
  }
  list.push_back(
      "What the tensioner pays out moves the pipe's top end along the guide; the pipe behind it has no mass or weight "
      "of "
      "its own.");
}

/// Each section has its own law.
void assume_steel(Sentences& list, const Model& model) {
  const auto yields = [](const Section& section) { return section.bending.has_value(); };
  const bool any = std::any_of(model.sections.begin(), model.sections.end(), yields);
  if (any) {
    list.push_back(
        "Steel that yields does so in time as in statics: it goes on from what statics left in it, and what it "
        "dissipates is part of the energy balance.");
  }
  if (!std::all_of(model.sections.begin(), model.sections.end(), yields)) {
    list.push_back(
        any ? "Sections of linear steel stay linear in time: their stress beyond yield is reported, not limited."
            : "The steel stays linear in time as well: stress beyond yield is reported, not limited.");
  }
}

void assume_laid_pipe(Sentences& list, const Model& model) {
  if (model.description.pipe.length) return;
  list.push_back(model.seabed.friction_axial > 0.0 ? "Behind the static line the laid pipe goes on for as long as "
                                                     "axial friction needs to take up the tension at "
                                                     "the tensioner, 3 km at most."
                                                   : "The bed has no axial friction: the laid pipe is held where the "
                                                     "static line ends, and changes of tension hang "
                                                     "on that length (environment.seabed.friction lets it be found).");
}

}  // namespace

void assume_dynamics(Sentences& list, const Model& model) {
  const DynamicSettings settings = model.description.dynamics.value_or(DynamicSettings{});
  assume_time(list, settings);
  assume_waves(list, model, settings);
  assume_vessel_motion(list, model.description.vessel);
  assume_water_forces(list, model);
  assume_laid_pipe(list, model);
  assume_held_top(list, model.description.tensioner);
  assume_rollers(list, model, settings);
  assume_steel(list, model);
}

}  // namespace overbend
