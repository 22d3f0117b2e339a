#include "model/waves/rao_table.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/require.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

constexpr double kHeadingTolerance = 1e-9;  ///< Headings that differ by less are equal [rad].

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

Bracket between(std::size_t low, std::size_t high, double from, double to, double value) {
  return {low, high, false, false, to > from ? (value - from) / (to - from) : 0.0};
}

/// Bracket of a heading in a table over the whole circle.
Bracket bracket_on_circle(const std::vector<double>& headings, double heading) {
  const std::size_t last = headings.size() - 1;
  const auto above =
      static_cast<std::size_t>(std::upper_bound(headings.begin(), headings.end(), heading) - headings.begin());
  if (above == 0) return between(last, 0, headings[last] - 2.0 * kPi, headings[0], heading);
  if (above > last) return between(last, 0, headings[last], headings[0] + 2.0 * kPi, heading);
  return between(above - 1, above, headings[above - 1], headings[above], heading);
}

/// Bracket of a heading between 0 and pi in a table over that range; beyond the outermost heading its mirror image is
/// used.
Bracket bracket_on_one_side(const std::vector<double>& headings, double heading) {
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
  return bracket_on_circle(headings, heading);
}

constexpr std::array<double, 6> kMirror = {1.0, -1.0, 1.0, -1.0, 1.0, -1.0};

/// Bracket on the frequency axis with the factors outside the table.
struct FrequencyBracket {
  Bracket bracket;
  double translation = 1.0, rotation = 1.0;
};

FrequencyBracket place_frequency(const std::vector<double>& omegas, double omega) {
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

/// Changes the phase reference from the crest at `from` to the crest at `to`.
void change_phase_reference(RaoTable& raos, const Vec3& from, const Vec3& to, double depth) {
  for (std::size_t i = 0; i < raos.headings.size(); ++i) {
    const Vec3 travel(std::cos(raos.headings[i]), std::sin(raos.headings[i]), 0.0);
    for (std::size_t j = 0; j < raos.omegas.size(); ++j) {
      const double later = linear_wave_number(raos.omegas[j], depth) * travel.dot(to - from);
      std::complex<double>* z = raos.values.data() + (i * raos.omegas.size() + j) * 6;
      for (std::size_t k = 0; k < 6; ++k) z[k] *= std::polar(1.0, later);
    }
  }
}

/// Transfers the motions to a point that is `across` further to port.
void transfer_to_port(RaoTable& raos, double across) {
  for (std::size_t offset = 0; offset < raos.values.size(); offset += 6) {
    std::complex<double>* z = raos.values.data() + offset;
    z[0] -= across * z[5];
    z[2] += across * z[3];
  }
}

}  // namespace

bool RaoTable::one_sided() const {
  return !asymmetric && !headings.empty() && headings.back() <= kPi + kHeadingTolerance;
}

RaoTable::Response RaoTable::at(double heading, double omega) const {
  require(!headings.empty() && values.size() == 6 * headings.size() * omegas.size() && !omegas.empty(),
          "a table of RAOs has a response for every heading and frequency");
  double turned = wrapped(heading);
  const bool other_side = one_sided() && turned > kPi;
  if (other_side) turned = 2.0 * kPi - turned;
  const Bracket h = one_sided() ? bracket_on_one_side(headings, turned) : bracket_on_circle(headings, turned);
  const FrequencyBracket w = place_frequency(omegas, omega);
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

RaoTable with_phases_from_midship(RaoTable raos, double depth) {
  const Vec3 from(raos.wave_origin_V.x(), raos.wave_origin_V.y(), 0.0);
  if (from.isZero(0.0)) return raos;
  change_phase_reference(raos, from, Vec3::Zero(), depth);
  raos.wave_origin_V = Vec3(0.0, 0.0, raos.wave_origin_V.z());
  return raos;
}

RaoTable transferred_to_centreline(RaoTable raos, double depth) {
  // Mirrored entries also refer to the mirror images of the points.
  const double side = raos.starboard ? -1.0 : 1.0;
  if (raos.wave_origin_V.y() != 0.0) {
    change_phase_reference(raos, Vec3(0.0, side * raos.wave_origin_V.y(), 0.0), Vec3::Zero(), depth);
    raos.wave_origin_V.y() = 0.0;
  }
  if (raos.reference_V.y() != 0.0) {
    transfer_to_port(raos, -side * raos.reference_V.y());
    raos.reference_V.y() = 0.0;
  }
  return raos;
}

}  // namespace overbend
