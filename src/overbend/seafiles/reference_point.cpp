#include "seafiles/reference_point.h"

#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

Mat3 cross_matrix(const Vec3& a) {
  return (Mat3() << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0).finished();
}

/// Returns the matrix that gives the motion of a point at `arm` [m] from the reference point: v + omega x arm.
Mat6 motion_of_point(const Vec3& arm) {
  Mat6 motion = Mat6::Identity();
  motion.topRightCorner<3, 3>() = -cross_matrix(arm);
  return motion;
}

void move_excitation(HydrodynamicData& data, const Mat6& motion, const Vec3& from_crest, double depth) {
  for (std::size_t i = 0; i < data.excitation.omega.size(); ++i) {
    const double k = linear_wave_number(data.excitation.omega[i], depth);
    for (std::size_t j = 0; j < data.excitation.heading.size(); ++j) {
      const double heading = data.excitation.heading[j];
      const double later = k * (std::cos(heading) * from_crest.x() + std::sin(heading) * from_crest.y());
      CVec6& force = data.force[data.excitation.index(i, j)];
      force = std::polar(1.0, later) * (motion.transpose().cast<std::complex<double>>() * force).eval();
    }
  }
}

}  // namespace

void move_matrix(Mat6& matrix, const Vec3& from, const Vec3& to) {
  const Mat6 motion = motion_of_point(from - to);
  matrix = (motion.transpose() * matrix * motion).eval();
}

void move_coefficients(HydrodynamicData& data, const FilePoints& from, double depth) {
  const Mat6 motion = motion_of_point(from.reference - data.origin_V);
  const auto move = [&](Mat6& matrix) { matrix = (motion.transpose() * matrix * motion).eval(); };
  for (RadiationPoint& point : data.radiation) {
    move(point.added_mass);
    move(point.damping);
  }
  move(data.added_mass_infinite);
  move(data.added_mass_zero);
  move(data.hydrostatic_stiffness);
  move_excitation(data, motion, data.origin_V - from.wave_origin, depth);
  for (Vec6& drift : data.mean_drift) {
    const Vec6 moved = motion.transpose() * drift;
    drift(5) = moved(5);  // heave, roll and pitch are not used
  }
  data.file_origin_V = from.reference;
}

}  // namespace overbend
