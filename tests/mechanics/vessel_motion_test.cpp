#include "mechanics/vessel_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "model/waves/wave_theory.h"
#include "support/fixtures.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

Description with_raos() {
  Description d = testing::plain_description();  // heading east
  d.vessel.motion = VesselMotion::raos;
  d.vessel.raos = testing::bgl1_raos();
  return d;
}

/// Large motions in all freedoms, of a point off the origin.
VesselMotionModel wild_motion() {
  Description d = testing::plain_description();
  d.vessel.trim = 1.5 * kDegree;
  d.vessel.heel = -2.0 * kDegree;
  d.vessel.heading = 37.0 * kDegree;
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.motion_reference_V = Vec3(7.0, -3.0, 4.0);
  d.vessel.harmonic = {{"surge", {2.0, 11.0, 0.3}},           {"sway", {1.5, 9.0, 1.0}},
                       {"heave", {3.0, 8.0, -0.5}},           {"roll", {15.0 * kDegree, 7.0, 0.2}},
                       {"pitch", {9.0 * kDegree, 6.0, -1.2}}, {"yaw", {20.0 * kDegree, 13.0, 2.0}}};
  return make_vessel_motion(build_model(d), Sea{});
}

RigidMotion motion_at(const VesselMotionModel& motion, double t) {
  return vessel_motion(motion, t, half_cosine(t, 60.0));
}

/// Central differences of a function of time.
template <typename F>
Vec3 rate(const F& f, double t, double h = 1e-4) {
  return (f(t + h) - f(t - h)) / (2.0 * h);
}

TEST(vessel_motion, velocities_and_accelerations_are_the_derivatives_of_places_and_directions) {
  const VesselMotionModel motion = wild_motion();
  const Vec3 p_V(-60.0, 2.0, 3.818), d_V = Vec3(0.6, -0.64, 0.48);
  for (const double t : {-59.0, -31.7, -4.0, 0.5, 17.3, 1000.1}) {
    const PointMotion p = point_motion(motion_at(motion, t), p_V);
    const DirectionMotion d = direction_motion(motion_at(motion, t), d_V);
    const auto point = [&](double u) { return point_motion(motion_at(motion, u), p_V); };
    const auto direction = [&](double u) { return direction_motion(motion_at(motion, u), d_V); };
    // Central differences err by h^2/6 times the third derivative, here below 1e-7 of some 60 m times a few rad/s^3.
    EXPECT_LT((p.velocity - rate([&](double u) { return point(u).place; }, t)).norm(), 2e-7) << t;
    EXPECT_LT((p.acceleration - rate([&](double u) { return point(u).velocity; }, t)).norm(), 2e-7) << t;
    EXPECT_LT((d.rate - rate([&](double u) { return direction(u).direction; }, t)).norm(), 1e-8) << t;
    EXPECT_LT((d.acceleration - rate([&](double u) { return direction(u).rate; }, t)).norm(), 1e-8) << t;
    const RigidMotion m = motion_at(motion, t);
    EXPECT_LT((m.alpha - rate([&](double u) { return motion_at(motion, u).omega; }, t)).norm(), 1e-8) << t;
    EXPECT_LT((m.acceleration - rate([&](double u) { return motion_at(motion, u).velocity; }, t)).norm(), 2e-7) << t;
  }
}

TEST(vessel_motion, angular_velocity_turns_the_axes) {
  const VesselMotionModel motion = wild_motion();
  for (const double t : {-20.0, 3.3, 41.0}) {
    const RigidMotion m = motion_at(motion, t);
    for (int k = 0; k < 3; ++k) {
      const Vec3 turned = rate([&](double u) { return Vec3(motion_at(motion, u).pose.R_WV.col(k)); }, t);
      EXPECT_LT((turned - m.omega.cross(m.pose.R_WV.col(k))).norm(), 1e-8);
    }
    EXPECT_LT((m.pose.R_WV.transpose() * m.pose.R_WV - Mat3::Identity()).norm(), 1e-14);
  }
}

TEST(vessel_motion, the_vessel_is_rigid) {
  const VesselMotionModel motion = wild_motion();
  const Vec3 a_V(-60.0, 0.0, 3.8), b_V(50.0, 14.0, 9.0);
  for (const double t : {-45.0, 0.0, 12.3}) {
    const RigidMotion m = motion_at(motion, t);
    const PointMotion a = point_motion(m, a_V), b = point_motion(m, b_V);
    EXPECT_NEAR((a.place - b.place).norm(), (a_V - b_V).norm(), 1e-11);
    EXPECT_NEAR((a.velocity - b.velocity).dot(a.place - b.place), 0.0, 1e-9) << "the distance does not change";
  }
}

TEST(vessel_motion, the_reference_point_moves_by_the_translations_along_the_mean_axes) {
  const VesselMotionModel motion = wild_motion();
  const RigidMotion m = motion_at(motion, 7.7);
  const PointMotion p = point_motion(m, motion.reference_V);
  const Vec3 moved = motion.mean.R_WV.transpose() * (p.place - motion.mean.p_WV) - motion.reference_V;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(moved(k), m.freedoms[static_cast<std::size_t>(k)], 1e-12);
}

TEST(vessel_motion, positive_rotations_lower_starboard_and_bow_and_turn_the_bow_to_port) {
  Description d = testing::plain_description();
  d.vessel.motion = VesselMotion::harmonic;
  const auto quarter = [&](const char* freedom) {
    d.vessel.harmonic = {{freedom, {5.0 * kDegree, 8.0, 0.0}}};
    return vessel_motion(make_vessel_motion(build_model(d), Sea{}), 2.0, {});
  };
  EXPECT_LT(point_motion(quarter("roll"), Vec3(0.0, -15.0, 0.0)).place.z(), -1.0);
  EXPECT_LT(point_motion(quarter("pitch"), Vec3(60.0, 0.0, 0.0)).place.z(), -5.0);
  EXPECT_GT(point_motion(quarter("yaw"), Vec3(60.0, 0.0, 0.0)).place.y(), 5.0) << "port is north of a barge going east";
}

TEST(vessel_motion, harmonic_motion_is_the_sine_it_is_described_as) {
  Description d = testing::plain_description();
  d.vessel.motion = VesselMotion::harmonic;
  d.vessel.harmonic = {{"heave", {1.5, 8.0, 30.0 * kDegree}}};
  const VesselMotionModel motion = make_vessel_motion(build_model(d), Sea{});
  const double w = 2.0 * kPi / 8.0;
  for (const double t : {0.0, 1.1, 6.9, 500.0}) {
    const RigidMotion m = vessel_motion(motion, t, {});
    EXPECT_NEAR(m.freedoms[2], 1.5 * std::sin(w * t + 30.0 * kDegree), 1e-12);
    EXPECT_NEAR(m.velocity.z(), 1.5 * w * std::cos(w * t + 30.0 * kDegree), 1e-12);
    EXPECT_NEAR(m.acceleration.z(), -1.5 * w * w * std::sin(w * t + 30.0 * kDegree), 1e-12);
  }
}

TEST(vessel_motion, a_fixed_vessel_and_one_in_a_calm_sea_rest_in_the_mean_pose) {
  Description d = with_raos();
  d.vessel.trim = 1.0 * kDegree;
  const Model model = build_model(d);
  for (const bool raos : {true, false}) {
    Model changed_model = model;
    if (!raos) changed_model.description.vessel.motion = VesselMotion::fixed;
    const VesselMotionModel motion = make_vessel_motion(changed_model, Sea{});
    EXPECT_FALSE(motion.moving());
    const RigidMotion m = vessel_motion(motion, 12.0, {});
    EXPECT_LT((m.pose.p_WV - model.mean_pose.p_WV).norm(), 1e-14);
    EXPECT_LT((m.pose.R_WV - model.mean_pose.R_WV).norm(), 1e-15);
    EXPECT_EQ(m.velocity.norm() + m.acceleration.norm() + m.omega.norm() + m.alpha.norm(), 0.0);
  }
}

TEST(vessel_motion, a_regular_wave_gives_amplitude_and_phase_of_the_raos_back) {
  const Model model = build_model(with_raos());
  const double omega = 0.5, amplitude = 1.25, phase = 0.8;
  for (const double towards : {0.0, 60.0, 90.0, 215.0}) {  // anticlockwise from east, which is the barge's bow
    const Sea sea =
        make_sea({{amplitude, omega, 0.0, std::cos(towards * kDegree), std::sin(towards * kDegree), phase}}, 89.0);
    const VesselMotionModel motion = make_vessel_motion(model, sea);
    const RaoTable::Response z = model.description.vessel.raos->at(towards * kDegree, omega);
    for (const double t : {0.0, 3.0, 7.7}) {
      const RigidMotion m = vessel_motion(motion, t, {});
      for (std::size_t k = 0; k < 6; ++k) {
        const double lag = -std::arg(z[k]);
        // The crest passes the origin when omega t = phase.
        EXPECT_NEAR(m.freedoms[k], amplitude * std::abs(z[k]) * std::cos(omega * t - phase - lag), 1e-12)
            << towards << " deg " << kFreedomNames[k];
      }
    }
  }
}

TEST(vessel_motion, waves_from_the_south_reach_a_barge_going_east_from_starboard) {
  Description d = with_raos();
  d.environment.waves.front().type = WaveType::airy;
  d.environment.waves.front().height = 2.0;
  d.environment.waves.front().period = 12.9;
  d.environment.waves.front().from = kPi;
  const Model model = build_model(d);
  const VesselMotionModel motion = make_vessel_motion(model, make_sea(d.environment.waves, 89.0, 1));
  ASSERT_EQ(motion.terms.size(), 1U);
  const RaoTable::Response beam = d.vessel.raos->at(90.0 * kDegree, 2.0 * kPi / 12.9);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(std::abs(motion.terms[0].amplitude[k]), std::abs(beam[k]), 1e-12);
  EXPECT_NEAR(std::abs(motion.terms[0].amplitude[1]), 0.909, 2e-3) << "README of the data";
  EXPECT_NEAR(std::abs(motion.terms[0].amplitude[3]) / kDegree, 1.679, 5e-3);
}

TEST(vessel_motion, phases_count_from_the_wave_at_the_wave_origin) {
  Description d = with_raos();
  d.vessel.raos->wave_origin_V = Vec3(30.0, 0.0, 0.0);
  const Sea sea = make_sea({{1.0, 0.5, 0.0, 1.0, 0.0, 0.0}}, 89.0);  // runs east, as does the bow
  const VesselMotionModel moved = make_vessel_motion(build_model(d), sea);
  const VesselMotionModel plain = make_vessel_motion(build_model(with_raos()), sea);
  const double later = sea.components[0].kx * 30.0;
  EXPECT_GT(later, 0.5);
  EXPECT_NEAR(std::abs(moved.terms[0].amplitude[2] - plain.terms[0].amplitude[2] * std::polar(1.0, -later)), 0.0,
              1e-13);
}

/// Two equal hulls in a swell that runs east: that which lies a wave further east moves alike, at half a wave the other
/// way, and one that lies north by any way at the same time.
TEST(body_motion, meets_the_wave_where_the_body_lies) {
  const Model model = build_model(with_raos());
  const Sea sea = make_sea({{1.25, 0.5, 0.0, 1.0, 0.0, 0.8}}, 89.0);
  const double wave = 2.0 * kPi / sea.components[0].kx;
  const VesselMotionModel vessel = make_vessel_motion(model, sea);
  const auto heave = [&](const Vec3& place, double t) {
    VesselPose pose = model.mean_pose;
    pose.p_WV += place;
    return vessel_motion(make_body_motion(model.description.vessel, pose, sea), t, {}).freedoms[2];
  };
  for (const double t : {0.0, 2.0, 5.5}) {
    const double original = vessel_motion(vessel, t, {}).freedoms[2];
    EXPECT_NEAR(heave(Vec3(wave, 0.0, 0.0), t), original, 1e-9) << t;
    EXPECT_NEAR(heave(Vec3(0.5 * wave, 0.0, 0.0), t), -original, 1e-9) << t;
    EXPECT_NEAR(heave(Vec3(0.0, 170.0, 0.0), t), original, 1e-9) << t;
  }
}

TEST(vessel_motion, between_points_of_the_table_it_does_not_matter_from_where_phases_count) {
  // The barge's responses with phases that count from a crest at the stern: the same motion, between headings and
  // frequencies as at them.
  Description d = with_raos();
  RaoTable& raos = *d.vessel.raos;
  raos.wave_origin_V = Vec3(-60.0, 9.0, 0.0);
  for (std::size_t i = 0; i < raos.headings.size(); ++i) {
    const Vec3 travel(std::cos(raos.headings[i]), std::sin(raos.headings[i]), 0.0);
    for (std::size_t j = 0; j < raos.omegas.size(); ++j) {
      const double later = linear_wave_number(raos.omegas[j], 89.0) * travel.dot(raos.wave_origin_V);
      for (std::size_t k = 0; k < 6; ++k) {
        raos.values[(i * raos.omegas.size() + j) * 6 + k] *= std::polar(1.0, later);
      }
    }
  }
  for (const double towards : {7.5, 127.0, 232.5}) {
    const Sea sea = make_sea({{1.0, 0.79, 0.0, std::cos(towards * kDegree), std::sin(towards * kDegree), 0.3}}, 89.0);
    const VesselMotionModel moved = make_vessel_motion(build_model(d), sea);
    const VesselMotionModel plain = make_vessel_motion(build_model(with_raos()), sea);
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_NEAR(std::abs(moved.terms[0].amplitude[k] - plain.terms[0].amplitude[k]), 0.0, 1e-12)
          << towards << " deg " << kFreedomNames[k];
    }
  }
}

WavesDescription paper_sea(int components) {
  WavesDescription waves;
  waves.type = WaveType::jonswap;
  waves.hs = 4.0;
  waves.tp = 12.9;
  waves.gamma = 3.3;
  waves.from = kPi;
  waves.components = components;
  return waves;
}

TEST(vessel_motion, standard_deviations_in_the_beam_sea_are_those_of_the_data) {
  const RaoTable& raos = testing::bgl1_raos();
  const WavesDescription waves = paper_sea(400);
  std::array<double, 6> variance{};
  const double step = 0.002;
  for (double omega = 0.2; omega < 2.2; omega += step) {
    const double density = spectral_density(waves, omega);
    const RaoTable::Response z = raos.at(0.5 * kPi, omega);
    for (std::size_t k = 0; k < 6; ++k) variance[k] += std::norm(z[k]) * density * step;
  }
  EXPECT_NEAR(std::sqrt(variance[1]), 0.84, 0.01);
  EXPECT_NEAR(std::sqrt(variance[2]), 1.02, 0.01);
  EXPECT_NEAR(std::sqrt(variance[3]) / kDegree, 3.1, 0.05);

  // The same from the motion in time: the terms' sum, and a record of eight hours.
  const VesselMotionModel motion = make_vessel_motion(build_model(with_raos()), make_sea(waves, 89.0, 3));
  std::array<double, 6> of_terms{}, of_record{};
  for (std::size_t i = 0; i < motion.terms.size(); ++i) {
    for (std::size_t k = 0; k < 6; ++k) of_terms[k] += 0.5 * std::norm(motion.terms[i].amplitude[k]);
  }
  const int samples = 28800;
  for (int i = 0; i < samples; ++i) {
    const RigidMotion m = vessel_motion(motion, i, {});
    for (std::size_t k = 0; k < 6; ++k) of_record[k] += m.freedoms[k] * m.freedoms[k] / samples;
  }
  for (const std::size_t k : {1U, 2U, 3U}) {
    EXPECT_NEAR(std::sqrt(of_terms[k] / variance[k]), 1.0, 0.03)
        << kFreedomNames[k] << ": the sea's components are drawn";
    EXPECT_NEAR(std::sqrt(of_record[k] / of_terms[k]), 1.0, 0.03) << kFreedomNames[k];
  }
  for (const std::size_t k : {0U, 4U, 5U}) EXPECT_LT(of_record[k], 1e-10) << "a beam sea leaves " << kFreedomNames[k];
  EXPECT_LT(motion.above_table, 0.01);
}

VesselMotionModel recorded(const std::vector<double>& time, std::size_t freedom, double (*f)(double)) {
  Description d = testing::plain_description();
  d.vessel.motion = VesselMotion::history;
  d.vessel.history.emplace();
  for (const double t : time) {
    d.vessel.history->time.push_back(t);
    d.vessel.history->freedoms.push_back({});
    d.vessel.history->freedoms.back()[freedom] = f(t);
  }
  return make_vessel_motion(build_model(d), Sea{});
}

std::vector<double> instants(double from, double to, double step) {
  std::vector<double> time;
  for (double t = from; t <= to + 1e-9; t += step) time.push_back(t);
  return time;
}

double swing(double t) {
  return 0.3 + std::sin(0.7 * t);
}

TEST(vessel_motion, a_record_reproduces_its_points_and_the_curve_between) {
  const std::vector<double> time = instants(0.0, 60.0, 0.25);
  const VesselMotionModel motion = recorded(time, 2, swing);
  EXPECT_EQ(motion.first, 0.0);
  EXPECT_DOUBLE_EQ(motion.last, 60.0);
  for (const double t : time) EXPECT_NEAR(vessel_motion(motion, t, {}).freedoms[2], swing(t), 1e-14);
  for (const double t : {20.1, 30.33, 41.9}) {
    const RigidMotion m = vessel_motion(motion, t, {});
    EXPECT_NEAR(m.freedoms[2], swing(t), 5.0 / 384.0 * std::pow(0.7 * 0.25, 4.0)) << "bound of cubic splines";
    EXPECT_NEAR(m.velocity.z(), 0.7 * std::cos(0.7 * t), 1e-4);
    EXPECT_NEAR(m.acceleration.z(), -0.49 * std::sin(0.7 * t), 3e-3);
  }
}

TEST(vessel_motion, a_record_sets_in_without_a_jump_and_rests_at_its_end) {
  const VesselMotionModel motion = recorded(instants(0.0, 40.0, 0.5), 2, swing);
  const auto place = [&](double t) { return point_motion(motion_at(motion, t), Vec3::Zero()); };
  for (const double t : {-30.2, -0.3, 0.25}) {
    EXPECT_LT((place(t).velocity - rate([&](double u) { return place(u).place; }, t)).norm(), 1e-7) << t;
    EXPECT_LT((place(t).acceleration - rate([&](double u) { return place(u).velocity; }, t)).norm(), 1e-7) << t;
  }
  // At t = 0 only the build-up's own curvature jumps, by 0.5 (pi/60)^2 of the 0.3 m that stand there.
  const double jump = (place(1e-9).acceleration - place(-1e-9).acceleration).z();
  EXPECT_NEAR(jump, 0.3 * 0.5 * std::pow(kPi / 60.0, 2), 1e-7);
  EXPECT_DOUBLE_EQ(vessel_motion(motion, 50.0, {}).freedoms[2], swing(40.0));
  EXPECT_EQ(vessel_motion(motion, 50.0, {}).velocity.norm(), 0.0);
}

TEST(vessel_motion, what_can_not_be_followed_is_rejected_with_a_message) {
  Description d = testing::plain_description();
  d.vessel.motion_file = "nowhere.csv";
  for (const auto& [kind, message] : {std::pair{VesselMotion::raos, "nowhere.csv"},
                                      {VesselMotion::history, "nowhere.csv"},
                                      {VesselMotion::coupled, "not available"}}) {
    d.vessel.motion = kind;
    try {
      make_vessel_motion(build_model(d), Sea{});
      ADD_FAILURE() << message;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace overbend
