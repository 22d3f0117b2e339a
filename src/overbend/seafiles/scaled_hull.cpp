#include "seafiles/scaled_hull.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/constants.h"
#include "base/require.h"

namespace overbend {
namespace {

constexpr std::size_t kSway = 1, kRoll = 3;

/// Returns the frequencies of the original scaled by both ratios, in increasing order without duplicates.
std::vector<double> scaled_frequencies(const std::vector<double>& omegas, double by_length, double by_beam) {
  std::vector<double> all;
  for (const double omega : omegas) {
    all.push_back(omega / std::sqrt(by_length));
    all.push_back(omega / std::sqrt(by_beam));
  }
  std::sort(all.begin(), all.end());
  const double slack = 1e-6 * all.back();
  all.erase(std::unique(all.begin(), all.end(), [&](double a, double b) { return b - a <= slack; }), all.end());
  return all;
}

}  // namespace

RaoTable scale_raos(const RaoTable& raos, const HullDimensions& original, const HullDimensions& scaled) {
  require(original.length > 0.0 && original.beam > 0.0 && scaled.length > 0.0 && scaled.beam > 0.0,
          "scale_raos: dimensions above zero");
  const double by_length = scaled.length / original.length, by_beam = scaled.beam / original.beam;
  RaoTable table = raos;
  table.omegas = scaled_frequencies(raos.omegas, by_length, by_beam);
  table.values.clear();
  for (const double heading : table.headings) {
    for (const double omega : table.omegas) {
      const RaoTable::Response along = raos.at(heading, omega * std::sqrt(by_length));
      const RaoTable::Response across = raos.at(heading, omega * std::sqrt(by_beam));
      for (std::size_t k = 0; k < along.size(); ++k) {
        const bool beam = k == kSway || k == kRoll;
        const double rotation = k < 3 ? 1.0 : beam ? by_beam : by_length;
        table.values.push_back((beam ? across : along)[k] / rotation);
      }
    }
  }
  const Vec3 ratios(by_length, by_beam, by_beam);
  table.reference_V = raos.reference_V.cwiseProduct(ratios);
  table.wave_origin_V = raos.wave_origin_V.cwiseProduct(ratios);
  return table;
}

std::string rao_csv(const RaoTable& raos, const std::string& title, const std::string& assumption) {
  const Vec3 &point = raos.reference_V, &origin = raos.wave_origin_V;
  std::string text = fmt::format("# {}\n# assumption: {}\n# reference: {:.6g} {:.6g} {:.6g}\n", title, assumption,
                                 point.x(), point.y(), point.z());
  text += fmt::format("# wave_origin: {:.6g} {:.6g}\n", origin.x(), origin.y());
  text += "heading_deg,omega_rad_s,dof,amplitude,phase_deg\n";
  for (std::size_t i = 0; i < raos.headings.size(); ++i) {
    for (std::size_t j = 0; j < raos.omegas.size(); ++j) {
      for (std::size_t k = 0; k < kFreedomNames.size(); ++k) {
        const std::complex<double> z = raos.value(i, j, k);
        const double lag = z == 0.0 ? 0.0 : -std::arg(z) * kToDegrees;
        fmt::format_to(std::back_inserter(text), "{:.6g},{:.7g},{},{:.6e},{:.3f}\n", raos.headings[i] * kToDegrees,
                       raos.omegas[j], kFreedomNames[k], std::abs(z) * (k < 3 ? 1.0 : kToDegrees), lag);
      }
    }
  }
  return text;
}

}  // namespace overbend
