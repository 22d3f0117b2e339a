// Content of the first column of WAMIT's files.
#include "seafiles/wave_column.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "base/constants.h"
#include "hull/made_radiation.h"
#include "model/waves/wave_theory.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

constexpr double kDepth = 89.0;

double deep_wavenumber(double omega) {
  return omega * omega / 9.81;
}

double written(WaveColumn column, double omega) {
  if (column == WaveColumn::periods) return kTurn / omega;
  if (column == WaveColumn::rad_per_s) return omega;
  if (column == WaveColumn::hz) return omega / kTurn;
  // The files' gravity, 9.81 m/s2, is not that of the wave theory.
  const double slower = omega * std::sqrt(9.80665 / 9.81);
  return column == WaveColumn::wavenumbers ? linear_wave_number(slower, kDepth) : deep_wavenumber(omega);
}

/// Files of BGL-1 with another first column; 0 and -1 change places where it does not hold periods.
std::string rewritten_files(WaveColumn column) {
  const std::string from = testing::bgl1_file("bgl1"), stem = ::testing::TempDir() + "column_" + enum_name(column);
  for (const char* ending : {".1", ".3", ".8", ".hst"}) {
    std::ifstream in(from + ending);
    std::ofstream out(stem + ending);
    for (std::string line; std::getline(in, line);) {
      std::istringstream cells(line);
      double first = 0.0;
      std::string rest;
      cells >> first;
      std::getline(cells, rest);
      out.precision(17);
      if (ending == std::string(".hst")) {
        out << line << '\n';
      } else {
        const double limit = column == WaveColumn::periods ? first : -1.0 - first;
        out << (first > 0.0 ? written(column, kTurn / first) : limit) << rest << '\n';
      }
    }
  }
  return stem;
}

HydrodynamicsSource make_source(const std::string& stem) {
  HydrodynamicsSource source;
  source.path = stem;
  source.water_depth = kDepth;
  return source;
}

TEST(wave_column, each_kind_gives_the_same_coefficients) {
  const HydrodynamicData& given = testing::bgl1_data();
  for (const WaveColumn column :
       {WaveColumn::rad_per_s, WaveColumn::hz, WaveColumn::deep_wavenumbers, WaveColumn::wavenumbers}) {
    HydrodynamicsSource source = make_source(rewritten_files(column));
    source.frequencies = column;
    Diagnostics diagnostics;
    const auto data = read_hydrodynamics(source, diagnostics);
    ASSERT_TRUE(data) << diagnostics.lines(Severity::error)[0];
    ASSERT_EQ(data->radiation.size(), given.radiation.size());
    EXPECT_TRUE(data->has_infinite);
    EXPECT_EQ(data->added_mass_infinite, given.added_mass_infinite);
    for (std::size_t k = 0; k < given.radiation.size(); ++k) {
      EXPECT_NEAR(data->radiation[k].omega, given.radiation[k].omega, 1e-9) << enum_name(column);
      EXPECT_EQ(data->radiation[k].added_mass, given.radiation[k].added_mass);
      EXPECT_LT((data->radiation[k].damping - given.radiation[k].damping).norm(),
                1e-9 * given.radiation[k].damping.norm());
    }
    EXPECT_LT((data->force[30] - given.force[30]).norm(), 1e-12 * given.force[30].norm());
    EXPECT_NEAR(data->drift.omega[7], given.drift.omega[7], 1e-9);
  }
}

TEST(wave_column, frequencies_that_are_not_said_to_be_some_are_rejected) {
  for (const WaveColumn column : {WaveColumn::rad_per_s, WaveColumn::hz, WaveColumn::deep_wavenumbers}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_hydrodynamics(make_source(rewritten_files(column)), diagnostics));
    ASSERT_TRUE(diagnostics.has_errors());
    const std::string first = diagnostics.lines(Severity::error)[0];
    EXPECT_NE(first.find("expected wave periods in s"), std::string::npos) << first;
    EXPECT_NE(first.find("convention.frequencies"), std::string::npos) << first;
  }
}

TEST(wave_column, periods_said_to_be_frequencies_are_warned_of) {
  HydrodynamicsSource source = make_source(testing::bgl1_file("bgl1"));
  source.frequencies = WaveColumn::rad_per_s;
  Diagnostics diagnostics;
  read_hydrodynamics(source, diagnostics);
  ASSERT_FALSE(diagnostics.lines(Severity::warning).empty());
  EXPECT_NE(diagnostics.lines(Severity::warning)[0].find("look like periods"), std::string::npos);
}

TEST(wave_column, raos_of_wamit_may_be_by_frequency_too) {
  const std::string rows = " 0 1 0.9 90 0 0.9\n", middle = " 0 3 1 0 1 0\n";
  const auto file = [&](double a, double b) {
    std::ostringstream text;
    for (const double first : {a, b}) text << first << rows << first << middle;
    return text.str();
  };
  const testing::WrittenFile periods("p.4", file(kTurn / 0.5, kTurn)), frequencies("f.4", file(0.5, 1.0));
  RaoSettings by_frequency;
  by_frequency.values["frequencies"] = "rad_per_s";
  const RaoTable a = testing::good_raos(periods.path()), b = testing::good_raos(frequencies.path(), by_frequency);
  EXPECT_NEAR(a.omegas[0], b.omegas[0], 1e-5);  // six digits
  Diagnostics diagnostics;
  EXPECT_FALSE(read_raos(frequencies.path(), {}, kDepth, diagnostics));
  EXPECT_NE(diagnostics.lines(Severity::error)[0].find("vessel.motion.convention.frequencies"), std::string::npos);
}

}  // namespace
}  // namespace overbend
