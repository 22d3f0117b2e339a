#include "model/rao_table.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/require.h"

namespace overbend {
namespace {

constexpr double kSlack = 1e-9;  ///< Headings that differ by less are the same [rad].

/// Two points of an axis and the weight of the second; each may be a mirror image.
struct Bracket {
  std::size_t low = 0, high = 0;
  bool mirror_low = false, mirror_high = false;
  double share = 0.0;
};

double wrapped(double angle) {
  const double turned = std::fmod(angle, 2.0 * kPi);
  return turned < 0.0 ? turned + 2.0 * kPi : turned;
}

Bracket between(std::size_t low, std::size_t high, double from, double to, double at) {
  return {low, high, false, false, to > from ? (at - from) / (to - from) : 0.0};
}

/// Place of a heading among those of a whole circle.
Bracket place_on_circle(const std::vector<double>& headings, double heading) {
  const std::size_t last = headings.size() - 1;
  const auto above =
      static_cast<std::size_t>(std::upper_bound(headings.begin(), headings.end(), heading) - headings.begin());
  if (above == 0) return between(last, 0, headings[last] - 2.0 * kPi, headings[0], heading);
  if (above > last) return between(last, 0, headings[last], headings[0] + 2.0 * kPi, heading);
  return between(above - 1, above, headings[above - 1], headings[above], heading);
}

/// Place of a heading between 0 and pi among headings that all lie there: beyond the outermost comes its own image.
Bracket place_on_side(const std::vector<double>& headings, double heading) {
  const std::size_t last = headings.size() - 1;
  if (heading < headings.front()) {
    Bracket b = between(0, 0, -headings.front(), headings.front(), heading);
    b.mirror_low = true;
    return b;
  }
  if (heading > headings.back()) {
    Bracket b = between(last, last, headings.back(), 2.0 * kPi - headings.back(), heading);
    b.mirror_high = true;
    return b;
  }
  return place_on_circle(headings, heading);
}

constexpr std::array<double, 6> kMirror = {1.0, -1.0, 1.0, -1.0, 1.0, -1.0};

/// Frequency axis with the factors for what lies outside the table.
struct FrequencyPlace {
  Bracket bracket;
  double translation = 1.0, rotation = 1.0;
};

FrequencyPlace place_frequency(const std::vector<double>& omegas, double omega) {
  const std::size_t last = omegas.size() - 1;
  if (omega <= omegas.front()) {
    return {Bracket{}, 1.0, std::max(omega, 0.0) / omegas.front()};
  }
  if (omega >= omegas.back()) {
    const double fade = (RaoTable::kFadeOut - omega / omegas.back()) / (RaoTable::kFadeOut - 1.0);
    const double kept = std::clamp(fade, 0.0, 1.0);
    return {Bracket{last, last, false, false, 0.0}, kept, kept};
  }
  const auto above = static_cast<std::size_t>(std::upper_bound(omegas.begin(), omegas.end(), omega) - omegas.begin());
  return {between(above - 1, above, omegas[above - 1], omegas[above], omega), 1.0, 1.0};
}

}  // namespace

bool RaoTable::one_sided() const {
  return !headings.empty() && headings.back() <= kPi + kSlack;
}

RaoTable::Response RaoTable::at(double heading, double omega) const {
  require(!headings.empty() && values.size() == 6 * headings.size() * omegas.size() && !omegas.empty(),
          "a table of RAOs has a response for every heading and frequency");
  double turned = wrapped(heading);
  const bool other_side = one_sided() && turned > kPi;
  if (other_side) turned = 2.0 * kPi - turned;
  const Bracket h = one_sided() ? place_on_side(headings, turned) : place_on_circle(headings, turned);
  const FrequencyPlace w = place_frequency(omegas, omega);
  Response response{};
  for (std::size_t k = 0; k < 6; ++k) {
    const auto along = [&](std::size_t i) {
      return (1.0 - w.bracket.share) * value(i, w.bracket.low, k) + w.bracket.share * value(i, w.bracket.high, k);
    };
    const double low = (1.0 - h.share) * (h.mirror_low ? kMirror[k] : 1.0);
    const double high = h.share * (h.mirror_high ? kMirror[k] : 1.0);
    const double factor = (other_side ? kMirror[k] : 1.0) * (k < 3 ? w.translation : w.rotation);
    response[k] = factor * (low * along(h.low) + high * along(h.high));
  }
  return response;
}

}  // namespace overbend
