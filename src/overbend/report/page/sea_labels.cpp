#include "report/page/sea_labels.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "base/constants.h"
#include "base/shown_unit.h"
#include "mechanics/wave_spectrum.h"
#include "model/site/sea_statistics.h"
#include "model/waves/rao_table.h"

namespace overbend {
namespace {

std::string direction_label(const WavesDescription& waves) {
  if (!waves.directions.empty()) {
    return fmt::format("mainly from {:.4g} deg", std::fmod(waves.from * kToDegrees + 360.0, 360.0));
  }
  return fmt::format("from {:.4g} deg", waves.from == 0.0 ? 0.0 : waves.from * kToDegrees);
}

std::string regular(const char* kind, const WavesDescription& waves) {
  return fmt::format("{}, height {}, period {:.4g} s, {}", kind, shown_digits(waves.height, "m", 4), waves.period,
                     direction_label(waves));
}

std::string crests(const WavesDescription& waves) {
  if (!waves.directions.sectors.empty()) return "directions of the file";
  if (!waves.directions.spreading.empty()) return "spread as in the file";
  return waves.spreading ? fmt::format("spread as cos^2s with s = {:.4g}", *waves.spreading) : "long-crested";
}

std::string random_sea(const std::string& spectrum, const WavesDescription& waves) {
  return fmt::format("{}, {}, {}", spectrum, direction_label(waves), crests(waves));
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::string peak_period_label(const WavesDescription& waves) {
  return fmt::format("Tp {:.4g} s{}", waves.tp, waves.tz ? fmt::format(" from Tz {:.4g} s", *waves.tz) : "");
}

std::string ochi_hubble(const WavesDescription& waves) {
  std::string text = "Ochi-Hubble";
  for (const SpectrumPart& part : waves.parts) {
    text += fmt::format("{} Hs {}, Tp {:.4g} s, lambda {:.3g}", &part == waves.parts.data() ? "," : " and",
                        shown_digits(part.hs, "m", 4), part.tp, part.lambda);
  }
  return text;
}

std::string measured(const WavesDescription& waves) {
  const SeaStatistics sea = record_statistics(waves.record);
  return fmt::format("measured elevation of {}, {:.4g} s with Hs {}, Tz {:.3g} s, {}", file_name(waves.elevation_file),
                     waves.record.duration(), shown_digits(sea.hs, "m", 3), sea.tz, direction_label(waves));
}

std::string group_label(const WavesDescription& waves) {
  switch (waves.type) {
    case WaveType::none:
      return "calm water";
    case WaveType::airy:
      return regular("regular Airy wave", waves);
    case WaveType::stokes5:
      return regular("regular Stokes wave of fifth order", waves);
    case WaveType::jonswap:
      return random_sea(
          fmt::format("JONSWAP, Hs {}, {}, gamma {:.3g}{}", shown_digits(waves.hs, "m", 4), peak_period_label(waves),
                      waves.gamma ? *waves.gamma : jonswap_gamma(waves.hs, waves.tp), waves.gamma ? "" : " by rule"),
          waves);
    case WaveType::pierson_moskowitz:
      return random_sea(
          fmt::format("Pierson-Moskowitz, Hs {}, {}", shown_digits(waves.hs, "m", 4), peak_period_label(waves)), waves);
    case WaveType::ochi_hubble:
      return random_sea(ochi_hubble(waves), waves);
    case WaveType::torsethaugen:
      return random_sea(fmt::format("Torsethaugen, {}, Hs {}, Tp {:.4g} s",
                                    waves.model == TorsethaugenModel::full ? "full" : "simplified",
                                    shown_digits(waves.hs, "m", 4), waves.tp),
                        waves);
    case WaveType::elevation:
      return measured(waves);
    case WaveType::user:
      break;
  }
  const std::string heights = waves.spectrum.empty() ? "" : ", " + sea_statistics_label(waves.spectrum);
  return random_sea("spectrum of " + file_name(waves.spectrum_file) + heights, waves);
}

}  // namespace

std::string sea_label(const WaveGroups& groups) {
  if (groups.size() == 1) return group_label(groups.front());
  std::string text;
  for (const WavesDescription& waves : groups) {
    if (waves.type != WaveType::none) text += (text.empty() ? "" : "; ") + group_label(waves);
  }
  if (text.empty()) return "calm water";
  const double hs = significant_height(groups);
  return hs > 0.0 ? fmt::format("Hs {} together: {}", shown_digits(hs, "m", 4), text) : text;
}

std::string motion_label(const VesselDescription& vessel) {
  switch (vessel.motion) {
    case VesselMotion::fixed:
      return "none, fixed";
    case VesselMotion::raos:
      return "RAOs of " + file_name(vessel.motion_file);
    case VesselMotion::history:
      return "recorded, " + file_name(vessel.motion_file);
    case VesselMotion::coupled:
      return "floating free" + (vessel.coupled ? ", by " + file_name(vessel.coupled->hydrodynamics) : std::string());
    case VesselMotion::harmonic:
      break;
  }
  std::string text;
  for (const char* freedom : kFreedomNames) {  // in the order of the freedoms, not alphabetical
    if (vessel.harmonic.count(freedom) != 0) {
      text += (text.empty() ? "harmonic: " : ", ") + std::string(freedom);
    }
  }
  return text.empty() ? "none, fixed" : text;
}

}  // namespace overbend
