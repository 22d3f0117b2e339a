#include "dynamics/integrator/water_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mechanics/line_kernel.h"

namespace overbend {
namespace {

/// A straight line that dips from the surface to the bed, 2 m elements, moving slowly.
struct Dip {
  LineMesh mesh;
  std::vector<double> q, v;

  Dip() {
    constexpr int kNodes = 100;
    for (int i = 0; i < kNodes; ++i) {
      const double s = 2.0 * i;
      mesh.s.push_back(s);
      if (i + 1 < kNodes) {
        mesh.length.push_back(2.0);
        mesh.section.push_back(0);
      }
      q.insert(q.end(), {0.9 * s, 5.0, -80.0 + 0.4 * s, 0.9, 0.0, 0.4});
      v.insert(v.end(), {0.2, 0.1, 0.4 * std::sin(0.01 * s), 0.0, 0.0, 0.0});
    }
  }
};

Sea storm() {
  WavesDescription waves;
  waves.type = WaveType::jonswap;
  waves.hs = 4.0;
  waves.tp = 12.9;
  waves.components = 60;
  return make_sea(waves, 89.0, 3);
}

TEST(water_field, agrees_with_the_sums_of_the_waves_within_its_stated_error) {
  const Sea sea = storm();
  const Dip dip;
  const double interval = water_interval(sea, 0.5);
  WaterField field(sea, dip.mesh, dip.q, 0.0, interval);
  WaterMemory memory;
  field.start(memory, 10.0, dip.q, dip.v);
  std::vector<double> water(static_cast<std::size_t>(kWaterValues) * dip.mesh.s.size());
  double worst_v = 0.0, worst_a = 0.0, max_v = 0.0, max_a = 0.0;
  for (const double share : {0.0, 0.3, 0.5, 0.9}) {
    const double t = 10.0 + share * interval;
    field.nodes_at(memory, t, water);
    for (std::size_t node = 0; node < dip.mesh.s.size(); ++node) {
      const Vec3 r(dip.q[6 * node], dip.q[6 * node + 1], dip.q[6 * node + 2]);
      const Vec3 v(dip.v[6 * node], dip.v[6 * node + 1], dip.v[6 * node + 2]);
      const Vec3 point = r + share * interval * v;
      WaterState exact;
      water_state(sea, t, BuildUp{}, {&point, 1}, {&exact, 1});
      const double* got = water.data() + static_cast<std::size_t>(kWaterValues) * node;
      worst_v = std::max(worst_v, (Vec3(got[0], got[1], got[2]) - exact.velocity).norm());
      worst_a = std::max(worst_a, (Vec3(got[3], got[4], got[5]) - exact.acceleration).norm());
      max_v = std::max(max_v, exact.velocity.norm());
      max_a = std::max(max_a, exact.acceleration.norm());
    }
  }
  // Waves of twice the peak's frequency lose (k d)^2 / 8 = 0.6 % between stations 2 m apart and (omega D)^2 / 8 = 0.8 %
  // of their acceleration between moments; shorter ones more, of less. The moving pipe adds v k / omega of the
  // velocity's rate, a few per cent, between moments.
  EXPECT_LT(worst_v, 0.01 * max_v);
  EXPECT_LT(worst_a, 0.04 * max_a);
}

TEST(water_field, goes_on_from_moment_to_moment_without_a_jump) {
  const Sea sea = storm();
  const Dip dip;
  const std::vector<double> at_rest(dip.v.size(), 0.0);
  const double interval = water_interval(sea, 0.5);
  WaterField field(sea, dip.mesh, dip.q, 0.0, interval);
  WaterMemory memory;
  field.start(memory, 0.0, dip.q, at_rest);
  std::vector<double> before(static_cast<std::size_t>(kWaterValues) * dip.mesh.s.size()), after(before);
  field.nodes_at(memory, interval, before);
  field.advance(memory, dip.q, at_rest);
  field.nodes_at(memory, interval, after);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(after[i], before[i], 1e-12);
  }
}

TEST(water_field, is_calm_where_there_are_no_waves) {
  const Dip dip;
  EXPECT_TRUE(WaterField(Sea{}, dip.mesh, dip.q, 0.0, 0.5).calm());
}

TEST(water_interval, divides_the_output_step) {
  const double interval = water_interval(storm(), 0.5);
  EXPECT_NEAR(0.5 / interval, std::round(0.5 / interval), 1e-12);
  EXPECT_LE(interval, 0.5);
}

TEST(water_field, a_memory_made_anew_in_mid_interval_is_that_of_before) {
  Dip dip;
  const Sea sea = storm();
  WaterField field(sea, dip.mesh, dip.q, 0.0, 0.5);
  WaterMemory memory, anew;
  field.start(memory, 20.0, dip.q, dip.v);
  std::vector<double> later = dip.q;
  for (std::size_t i = 0; i < later.size(); ++i) later[i] += 0.2 * dip.v[i];
  WaterField same(sea, dip.mesh, field.station_nodes(), 0.0, 0.5);
  anew.time = memory.time;
  same.renew(anew, 20.2, later, dip.v);
  std::vector<double> a(dip.mesh.s.size() * kWaterValues), b(a.size());
  field.nodes_at(memory, 20.3, a);
  same.nodes_at(anew, 20.3, b);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << i;
}

}  // namespace
}  // namespace overbend
