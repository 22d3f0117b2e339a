#include "mechanics/spectral_peaks.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/constants.h"
#include "mechanics/sea.h"
#include "mechanics/wave_spectrum.h"

namespace overbend {
namespace {

constexpr std::array<double, 10> kOmegas = {0.3, 0.4, 0.45, 0.5, 0.6, 0.7, 0.85, 1.0, 1.3, 1.8};

/// A sea, its densities at kOmegas with six digits, and its first moments by integrals over all frequencies.
struct Reference {
  WavesDescription waves;
  std::array<double, 10> densities;
  double m0, m1, m2;
};

WavesDescription ochi_hubble(const std::array<double, 3>& low, const std::array<double, 3>& high) {
  WavesDescription waves;
  waves.type = WaveType::ochi_hubble;
  for (const auto& [hs, modal, lambda] : {low, high}) waves.parts.push_back({hs, kTurn / modal, lambda});
  return waves;
}

WavesDescription torsethaugen(double hs, double tp, TorsethaugenModel model = TorsethaugenModel::simplified) {
  WavesDescription waves;
  waves.type = WaveType::torsethaugen;
  waves.hs = hs;
  waves.tp = tp;
  waves.model = model;
  return waves;
}

std::vector<Reference> ochi_hubble_seas() {
  return {
      {ochi_hubble({2.0, 0.45, 3.0}, {1.5, 0.9, 1.4}),
       {0.000530998, 0.967184, 1.47894, 1.14949, 0.32891, 0.15225, 0.267885, 0.241004, 0.0858726, 0.013205},
       0.390625,
       0.272314663071,
       0.236884874168},
      {ochi_hubble({3.0, 0.38, 2.2}, {2.0, 0.75, 1.1}),
       {0.713679, 3.17322, 2.11836, 1.17606, 0.536912, 0.556019, 0.450689, 0.271816, 0.0863301, 0.0165728},
       0.8125,
       0.474170502632,
       0.360612083281},
      {ochi_hubble({1.2, 0.52, 5.0}, {2.6, 0.82, 1.54}),
       {3.13435e-14, 0.0087429, 0.206091, 0.564434, 0.3981, 0.652132, 0.934904, 0.61159, 0.158118, 0.0189078},
       0.5125,
       0.454591204922,
       0.445735875458},
  };
}

std::vector<Reference> torsethaugen_seas() {
  return {
      {torsethaugen(4.0, 8.5),
       {0.00325817, 0.234971, 0.392376, 0.55125, 1.09033, 2.03407, 1.31851, 0.772651, 0.324201, 0.0947486},
       1.0233957216,
       0.9931072067,
       1.3670396317},
      {torsethaugen(2.5, 14.0),
       {0.0354583, 0.502061, 1.3746, 0.639396, 0.344115, 0.381518, 0.339619, 0.24053, 0.105609, 0.0314606},
       0.3963455679,
       0.3345964911,
       0.4408809971},
      {torsethaugen(3.0, 9.5188),
       {4.06913e-09, 0.0116894, 0.118353, 0.381821, 0.988487, 1.14922, 0.663231, 0.411314, 0.162922, 0.046524},
       0.5634736077,
       0.5283703152,
       0.6981173571},
  };
}

/// Integral of omega^n S(omega) up to a frequency, in steps that grow with the frequency.
double moment(const WavesDescription& waves, int n, double highest = 20000.0) {
  const WaveSpectrum spectrum(waves);
  constexpr double kRatio = 1.0005;
  double sum = 0.0;
  for (double a = 0.05; a < highest; a *= kRatio) {
    const double b = a * kRatio, middle = 0.5 * (a + b);
    sum += (b - a) * std::pow(middle, n) * spectrum.density(middle);
  }
  return sum;
}

void expect_reference(const Reference& sea) {
  const WaveSpectrum spectrum(sea.waves);
  for (std::size_t i = 0; i < kOmegas.size(); ++i) {
    EXPECT_NEAR(spectrum.density(kOmegas[i]) / sea.densities[i], 1.0, 5e-6) << kOmegas[i];
  }
  EXPECT_NEAR(spectrum.variance() / sea.m0, 1.0, 1e-5);
  EXPECT_NEAR(moment(sea.waves, 1) / sea.m1, 1.0, 1e-4);
}

TEST(ochi_hubble_peaks, have_the_density_and_moments_of_the_publication) {
  for (const Reference& sea : ochi_hubble_seas()) {
    expect_reference(sea);
    EXPECT_NEAR(moment(sea.waves, 2) / sea.m2, 1.0, 1e-4);
  }
}

TEST(torsethaugen_peaks, simplified_have_the_density_and_moments_of_the_publication) {
  for (const Reference& sea : torsethaugen_seas()) expect_reference(sea);
}

TEST(torsethaugen_peaks, are_not_rescaled_so_that_hs_is_off_by_a_known_amount) {
  const auto error = [](double hs, double tp) {
    return 4.0 * std::sqrt(WaveSpectrum(torsethaugen(hs, tp)).variance()) / hs - 1.0;
  };
  EXPECT_NEAR(error(4.0, 8.5), 0.0116302, 1e-5);
  EXPECT_NEAR(error(2.5, 14.0), 0.0072957, 1e-5);
  EXPECT_NEAR(error(3.0, 9.5188), 0.0008651, 1e-5);
}

TEST(torsethaugen_peaks, of_the_full_model_follow_its_published_parameters) {
  const std::vector<SpectralPeak> wind = torsethaugen_peaks(4.0, 8.5, TorsethaugenModel::full);
  ASSERT_EQ(wind.size(), 2U);
  EXPECT_NEAR(wind[0].n, 0.5 * 2.0 + 3.2, 1e-12);
  EXPECT_NEAR(wind[0].hs, 3.6267034, 1e-6);
  EXPECT_NEAR(wind[0].gamma, 1.8392447 * (1.0 + 3.5 * std::exp(-4.0)), 1e-6);
  EXPECT_NEAR(kTurn / wind[1].peak, 12.476847, 1e-5);  // Tf + 2 s
  const std::vector<SpectralPeak> swell = torsethaugen_peaks(2.5, 14.0, TorsethaugenModel::full);
  EXPECT_NEAR(swell[1].m, 4.0 * (1.0 - 0.7 * std::exp(-2.5 / 3.0)), 1e-12);
  for (const auto& [hs, tp] : {std::pair{4.0, 8.5}, {2.5, 14.0}, {1.0, 10.0}, {6.0, 18.0}}) {
    const WaveSpectrum spectrum(torsethaugen(hs, tp, TorsethaugenModel::full));
    EXPECT_NEAR(4.0 * std::sqrt(spectrum.variance()) / hs, 1.0, 0.02) << hs << " " << tp;
  }
}

TEST(torsethaugen_peaks, are_finite_for_every_height_and_period_of_the_model_file) {
  for (const TorsethaugenModel model : {TorsethaugenModel::simplified, TorsethaugenModel::full}) {
    for (const double hs : {0.01, 0.5, 3.0, 15.0, 40.0}) {
      for (const double tp : {0.5, 2.0, 6.0, 12.0, 25.0, 40.0, 100.0}) {
        const WaveSpectrum spectrum(torsethaugen(hs, tp, model));
        EXPECT_TRUE(std::isfinite(spectrum.variance()) && spectrum.variance() > 0.0) << hs << " " << tp;
        EXPECT_TRUE(std::isfinite(spectrum.density(kTurn / tp))) << hs << " " << tp;
      }
    }
  }
}

TEST(spectral_peaks, seas_of_ten_seeds_have_their_variance_and_mean_frequency) {
  for (const Reference& reference : {ochi_hubble_seas()[0], torsethaugen_seas()[0]}) {
    const double highest = WaveSpectrum(reference.waves).quantile(1.0);
    const double mean_frequency = moment(reference.waves, 1, highest) / moment(reference.waves, 0, highest);
    double mean_m1 = 0.0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      double m0 = 0.0, m1 = 0.0;
      for (const WaveComponent& c : make_sea(reference.waves, 200.0, seed).components) {
        m0 += 0.5 * c.amplitude * c.amplitude;
        m1 += 0.5 * c.amplitude * c.amplitude * c.omega;
      }
      EXPECT_NEAR(m0 / reference.m0, 1.0, 1e-5);
      mean_m1 += 0.1 * m1;
    }
    EXPECT_NEAR(mean_m1 / (reference.m0 * mean_frequency), 1.0, 0.005);
  }
}

}  // namespace
}  // namespace overbend
