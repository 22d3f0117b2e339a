#include "modelfile/binding/wave_resolution.h"

#include <algorithm>
#include <cmath>

#include "model/waves/peak_period.h"

namespace overbend {
namespace {

void resolve_period(WavesDescription& waves) {
  if (!waves.tz) return;
  if (waves.type == WaveType::pierson_moskowitz) {
    waves.tp = peak_period(waves.hs, *waves.tz, 1.0);
  } else if (waves.type == WaveType::jonswap && (waves.gamma || waves.hs > 0.0)) {
    waves.tp = peak_period(waves.hs, *waves.tz, waves.gamma);
  }
}

void resolve_parts(WavesDescription& waves) {
  if (waves.type != WaveType::ochi_hubble || waves.parts.empty()) return;
  double squares = 0.0;
  for (const SpectrumPart& part : waves.parts) squares += part.hs * part.hs;
  waves.hs = std::sqrt(squares);
  const auto lower = [](const SpectrumPart& a, const SpectrumPart& b) { return a.hs < b.hs; };
  waves.tp = std::max_element(waves.parts.begin(), waves.parts.end(), lower)->tp;
}

}  // namespace

void resolve_waves(Description& description) {
  for (WavesDescription& waves : description.environment.waves) {
    resolve_period(waves);
    resolve_parts(waves);
  }
}

}  // namespace overbend
