#include "seafiles/rao_convention.h"

#include <cmath>

#include "base/constants.h"
#include "base/require.h"
#include "model/waves/rao_table.h"
#include "model/waves/wave_theory.h"
#include "seafiles/wave_column.h"

namespace overbend {
namespace {

const std::map<std::string, ConventionValues>& differences_from_house() {
  static const std::map<std::string, ConventionValues> kSets = {
      {"house", {}},
      {"wamit", {{"phase", "lead"}, {"rotation", "rad_per_m"}}},
      {"orcaflex", {}},
      {"aqwa", {}},
      {"moses",
       {{"phase", "lead"},
        {"positive.surge", "aft"},
        {"positive.sway", "starboard"},
        {"positive.roll", "port_down"},
        {"positive.pitch", "bow_up"}}},
      {"flexcom", {{"heading_zero", "bow"}}},
  };
  return kSets;
}

}  // namespace

const std::vector<ConventionKey>& convention_keys() {
  static const std::vector<ConventionKey> kKeys = {
      {"phase", "Sense of a positive phase: behind (lag) or ahead of (lead) the wave.", {"lag", "lead"}},
      {"phase_zero",
       "Event of the wave at its origin to which phases refer.",
       {"crest", "trough", "up_crossing", "down_crossing"}},
      {"heading_zero",
       "End of the vessel that waves of heading 0 reach first: the stern (they come from astern) or the bow.",
       {"stern", "bow"}},
      {"heading_sense", "Sense of increasing heading, seen from above.", {"anticlockwise", "clockwise"}},
      {"rotation",
       "Unit of roll, pitch and yaw: per wave amplitude, per maximum slope (k a; in the unit of the angle) or per "
       "steepness (height over length).",
       {"deg_per_m", "rad_per_m", "per_slope", "rad_per_steepness", "deg_per_steepness"}},
      {"frequencies",
       "First column of a WAMIT file, set by IPEROUT: periods, rad_per_s, hz, deep_wavenumbers (omega^2 L/g) or "
       "wavenumbers (k L).",
       enum_names<WaveColumn>()},
      {"positive.surge", "Positive surge.", {"forward", "aft"}},
      {"positive.sway", "Positive sway.", {"port", "starboard"}},
      {"positive.heave", "Positive heave.", {"up", "down"}},
      {"positive.roll", "Positive roll.", {"starboard_down", "port_down"}},
      {"positive.pitch", "Positive pitch.", {"bow_down", "bow_up"}},
      {"positive.yaw", "Positive yaw.", {"bow_to_port", "bow_to_starboard"}},
  };
  return kKeys;
}

std::vector<std::string> convention_sets() {
  return {"house", "wamit", "orcaflex", "aqwa", "moses", "flexcom"};
}

ConventionValues convention_set(const std::string& name) {
  ConventionValues convention;
  for (const ConventionKey& key : convention_keys()) convention[key.key] = key.values.front();
  const auto set = differences_from_house().find(name);
  if (set == differences_from_house().end()) return convention;
  for (const auto& [key, word] : set->second) convention[key] = word;
  return convention;
}

RaoTranslation::RaoTranslation(const ConventionValues& convention, double length_scale, double depth)
    : length_scale_(length_scale), depth_(depth) {
  for (const ConventionKey& key : convention_keys()) {
    if (convention.count(key.key) == 0) broken_promise("the convention of a file must define every key: " + key.key);
  }
  for (std::size_t k = 0; k < 6; ++k) {
    const std::string key = std::string("positive.") + kFreedomNames[k];
    signs_[k] = convention.at(key) == convention_set("house").at(key) ? 1.0 : -1.0;
  }
  if (convention.at("phase") == "lead") lead_ = -1.0;
  const std::string& zero = convention.at("phase_zero");
  event_ = zero == "trough" ? kPi : zero == "down_crossing" ? 0.5 * kPi : zero == "up_crossing" ? -0.5 * kPi : 0.0;
  if (convention.at("heading_zero") == "bow") zero_ = kPi;
  if (convention.at("heading_sense") == "clockwise") sense_ = -1.0;
  const std::string& rotation = convention.at("rotation");
  if (rotation.substr(0, 3) == "deg") angle_ = kPi / 180.0;
  if (rotation == "per_slope") per_slope_ = 1.0;
  if (rotation.find("steepness") != std::string::npos) per_slope_ = 1.0 / kPi;
}

double RaoTranslation::heading(double numbered) const {
  const double turned = std::fmod(zero_ + sense_ * numbered, 2.0 * kPi);
  const double positive = turned < 0.0 ? turned + 2.0 * kPi : turned;
  return 2.0 * kPi - positive < 1e-7 ? 0.0 : positive;
}

std::complex<double> RaoTranslation::response(const RaoRecord& record) const {
  const auto k = static_cast<std::size_t>(record.freedom);
  double size = signs_[k] * record.amplitude;
  if (record.freedom >= 3) {
    size *= angle_ / length_scale_;
    if (per_slope_ > 0.0) size *= per_slope_ * linear_wave_number(record.omega, depth_);
  }
  return std::polar(1.0, -(lead_ * record.phase + event_)) * size;
}

}  // namespace overbend
