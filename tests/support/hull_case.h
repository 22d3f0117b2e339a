/// The hull of BGL-1 and small seas, for tests.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "hull/hull_run.h"
#include "hull/make_hull.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend::testing {

inline HydrodynamicData good_hydrodynamics(const HydrodynamicsSource& source) {
  Diagnostics diagnostics;
  const auto data = read_hydrodynamics(source, diagnostics);
  for (const std::string& line : diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return data ? *data : HydrodynamicData{};
}

/// Drift below 0.5 rad/s is noise there.
inline const HydrodynamicData& bgl1_hydrodynamics() {
  static const HydrodynamicData kData =
      good_hydrodynamics({.path = std::string(OVERBEND_SOURCE_DIR) + "/data/bgl1/bgl1",
                          .origin_V = Vec3(0.0, 0.0, 0.818),
                          .drift_from = 0.5});
  return kData;
}

/// BGL-1 heading east (psi = 0), 5 % of critical roll damping, no current; calm sea.
inline Description bgl1_hull_description() {
  Description d;
  d.environment.water_depth = 89.0;
  d.environment.water_weight_density = 1025.0 * 9.80665;
  d.environment.seabed.stiffness = 100e3;
  d.vessel.length = 120.0;
  d.vessel.beam = 30.0;
  d.vessel.draught = 5.182;
  d.vessel.heading = 0.5 * std::numbers::pi;
  d.vessel.motion = VesselMotion::coupled;
  CoupledHullDescription hull;
  hull.data = bgl1_hydrodynamics();
  hull.mass = 19121580.0;
  hull.centre_of_gravity = Vec3(0.0, 0.0, 0.818);
  hull.gyration = Vec3(10.5, 30.0, 30.0);
  hull.damping = {{"roll", 0.05, std::nullopt, std::nullopt}};
  hull.current.form = HullCurrentModel::none;
  d.vessel.coupled = hull;
  return d;
}

inline const MadeHull& made_bgl1_hull() {
  static const MadeHull kHull = make_hull(build_model(bgl1_hull_description()), Sea{}, 0.0);
  return kHull;
}

/// A long-crested sea from DNV's JONSWAP that travels at an angle anticlockwise from east [rad].
inline Sea long_crested(double hs, double tp, double direction, std::uint64_t seed, int components = 200) {
  WavesDescription waves;
  waves.type = WaveType::jonswap;
  waves.hs = hs;
  waves.tp = tp;
  waves.from = 0.5 * std::numbers::pi - direction + std::numbers::pi;
  waves.components = components;
  return make_sea(waves, 89.0, seed);
}

inline Sea regular_sea(double amplitude, double omega, double direction, double phase = 0.0) {
  WaveComponent wave;
  wave.amplitude = amplitude;
  wave.omega = omega;
  wave.kx = std::cos(direction);
  wave.ky = std::sin(direction);
  wave.phase = phase;
  return make_sea({wave}, 89.0);
}

/// BGL-1 in a sea, drawn with heading psi as in the model.
inline Hull bgl1_in(const Sea& sea, WaveDrift drift) {
  Hull hull = made_bgl1_hull().hull;
  hull.waves = make_hull_waves(bgl1_hydrodynamics(), sea, drift, 5.182, hull.drawn(5));
  return hull;
}

/// Stiffness of eight lines at 300 kN about the centre of gravity.
inline HullSprings on_eight_lines(const Vec6& rest) {
  HullSprings springs;
  Mat6& K = springs.stiffness;
  K.diagonal() << 1.8479e5, 1.8479e5, 1.1845e4, 2.7285e6, 1.3382e8, 5.1281e8;
  K(0, 4) = K(4, 0) = 2.455e6;
  K(1, 3) = K(3, 1) = -9.4315e5;
  springs.rest = rest;
  return springs;
}

}  // namespace overbend::testing
