#include "seafiles/reference_point.h"

#include <gtest/gtest.h>

#include "base/constants.h"
#include "hull/made_radiation.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

Mat3 cross_matrix(const Vec3& a) {
  return (Mat3() << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0).finished();
}

const Vec3 kCentre(2.0, -0.5, 1.5), kReference(-60.0, 3.0, -5.182);

/// Mass matrix of a rigid body about a point from which its centre of mass lies at `arm`: the parallel axis theorem.
Mat6 mass_matrix(double mass, const Mat3& inertia, const Vec3& arm) {
  Mat6 matrix = Mat6::Zero();
  matrix.topLeftCorner<3, 3>() = mass * Mat3::Identity();
  matrix.topRightCorner<3, 3>() = -mass * cross_matrix(arm);
  matrix.bottomLeftCorner<3, 3>() = mass * cross_matrix(arm);
  matrix.bottomRightCorner<3, 3>() = inertia + mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
  return matrix;
}

void expect_equal(const Mat6& got, const Mat6& expected) {
  EXPECT_LT((got - expected).norm(), 1e-12 * expected.norm()) << got - expected;
}

HydrodynamicData one_wave(double omega, double heading) {
  HydrodynamicData data;
  data.origin_V = kCentre;
  data.excitation.omega = {omega};
  data.excitation.heading = {heading};
  data.force = {CVec6::Zero()};
  return data;
}

TEST(moved_coefficients, inertia_obeys_the_parallel_axis_theorem) {
  Mat3 inertia = Vec3(3e5, 8e5, 9e5).asDiagonal();
  inertia(0, 2) = inertia(2, 0) = 4e4;
  HydrodynamicData data = one_wave(0.5, 0.0);
  const Mat6 about_reference = mass_matrix(2e3, inertia, kCentre - kReference);
  data.radiation = {{0.5, about_reference, 0.1 * about_reference}};
  data.added_mass_infinite = data.added_mass_zero = about_reference;
  move_coefficients(data, {kReference, kReference}, 89.0);
  const Mat6 about_centre = mass_matrix(2e3, inertia, Vec3::Zero());
  expect_equal(data.radiation[0].added_mass, about_centre);
  expect_equal(data.radiation[0].damping, 0.1 * about_centre);
  expect_equal(data.added_mass_infinite, about_centre);
  expect_equal(data.added_mass_zero, about_centre);
  EXPECT_EQ(data.file_origin_V.value(), kReference);
}

/// Heave spring of a waterplane whose centre is at `centre`, with roll and pitch springs of its own.
Mat6 waterplane_stiffness(const Vec3& centre, double heave, double roll, double pitch) {
  Mat6 stiffness = Mat6::Zero();
  stiffness(2, 2) = heave;
  stiffness(2, 3) = stiffness(3, 2) = heave * centre.y();
  stiffness(2, 4) = stiffness(4, 2) = -heave * centre.x();
  stiffness(3, 3) = roll + heave * centre.y() * centre.y();
  stiffness(4, 4) = pitch + heave * centre.x() * centre.x();
  stiffness(3, 4) = stiffness(4, 3) = -heave * centre.x() * centre.y();
  return stiffness;
}

TEST(moved_coefficients, stiffness_is_that_of_the_waterplane_seen_from_the_other_point) {
  const Vec3 waterplane(1.0, 0.5, 0.0);
  HydrodynamicData data = one_wave(0.5, 0.0);
  data.hydrostatic_stiffness = waterplane_stiffness(waterplane - kReference, 3e7, 2e9, 4e10);
  move_coefficients(data, {kReference, kReference}, 89.0);
  expect_equal(data.hydrostatic_stiffness, waterplane_stiffness(waterplane - kCentre, 3e7, 2e9, 4e10));
}

TEST(moved_coefficients, a_force_keeps_its_line_of_action_and_its_time) {
  const double omega = 0.6, heading = 0.7, depth = 60.0;
  HydrodynamicData data = one_wave(omega, heading);
  const Vec3 force(3.0, -2.0, 5.0), point(4.0, 1.0, -2.0), origin(-60.0, 0.0, 0.0);
  data.force[0].head<3>() = force;
  data.force[0].tail<3>() = (point - kReference).cross(force);
  data.drift = data.excitation;
  data.mean_drift = {(Vec6() << force.x(), force.y(), 0.0, 0.0, 0.0, (point - kReference).cross(force).z()).finished()};
  move_coefficients(data, {kReference, origin}, depth);
  // The crest passes the file's origin a time k . d / omega before it passes the new one.
  const Vec3 direction = kCentre - origin;
  const double phase =
      linear_wave_number(omega, depth) * (std::cos(heading) * direction.x() + std::sin(heading) * direction.y());
  CVec6 expected;
  expected << force.cast<std::complex<double>>(), (point - kCentre).cross(force).cast<std::complex<double>>();
  EXPECT_LT((data.force[0] - std::polar(1.0, phase) * expected).norm(), 1e-12 * expected.norm());
  EXPECT_NEAR(data.mean_drift[0](5), (point - kCentre).cross(force).z(), 1e-12);
}

TEST(moved_coefficients, there_and_back_is_nowhere) {
  const HydrodynamicData& barge = testing::bgl1_data();
  HydrodynamicData data = barge;
  data.origin_V = kReference;
  move_coefficients(data, {barge.origin_V, barge.origin_V}, 89.0);
  EXPECT_GT((data.radiation[5].added_mass - barge.radiation[5].added_mass).norm(),
            barge.radiation[5].added_mass.norm());
  data.origin_V = barge.origin_V;
  move_coefficients(data, {kReference, kReference}, 89.0);
  expect_equal(data.radiation[5].added_mass, barge.radiation[5].added_mass);
  expect_equal(data.hydrostatic_stiffness, barge.hydrostatic_stiffness);
  EXPECT_LT((data.force[100] - barge.force[100]).norm(), 1e-12 * barge.force[100].norm());
}

}  // namespace
}  // namespace overbend
