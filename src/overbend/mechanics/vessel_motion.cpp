#include "mechanics/vessel_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/require.h"
#include "mechanics/moving_vessel.h"
#include "mechanics/sea_outside_range.h"

namespace overbend {
namespace {

using Six = std::array<double, 6>;

/// The six degrees of freedom with their time derivatives.
struct Freedoms {
  Six value{}, rate{}, acceleration{};
};

// Terms from the description ------------------------------------------------------------------------------------

/// Returns the response to one component of the sea. `heading_W` is the azimuth of V's x axis, anticlockwise from W's
/// x.
MotionTerm respond(const RaoTable& raos, const WaveComponent& wave, double heading_W, const Vec3& wave_origin_W) {
  MotionTerm term;
  term.omega = wave.omega;
  const RaoTable::Response z = raos.at(std::atan2(wave.ky, wave.kx) - heading_W, wave.omega);
  const double lag = wave.kx * wave_origin_W.x() + wave.ky * wave_origin_W.y() + wave.phase;
  const std::complex<double> crest = std::polar(wave.amplitude, -lag);
  std::transform(z.begin(), z.end(), term.amplitude.begin(), [&](const auto& response) { return response * crest; });
  return term;
}

void add_rao_terms(VesselMotionModel& motion, const RaoTable& table, const Sea& sea) {
  const RaoTable raos = sea.calm() ? table : with_phases_from_midship(table, sea.depth);
  motion.reference_V = raos.reference_V;
  const Vec3 forward = motion.mean.R_WV.col(0);
  const double heading_W = std::atan2(forward.y(), forward.x());
  const Vec3 wave_origin_W = motion.mean.p_WV + motion.mean.R_WV * raos.wave_origin_V;
  for (const WaveComponent& wave : sea.components) motion.terms.add(respond(raos, wave, heading_W, wave_origin_W));
  const SeaOutsideRange sea_range = sea_outside_range(sea, raos.omegas.front(), raos.omegas.back());
  motion.below_table = sea_range.below;
  motion.above_table = sea_range.above;
}

void add_harmonic_terms(VesselMotionModel& motion, const VesselDescription& vessel) {
  motion.reference_V = vessel.motion_reference_V;
  for (std::size_t k = 0; k < kFreedomNames.size(); ++k) {
    const auto found = vessel.harmonic.find(kFreedomNames[k]);
    if (found == vessel.harmonic.end()) continue;
    const HarmonicMotion& harmonic = found->second;
    MotionTerm term;
    term.omega = 2.0 * std::numbers::pi / harmonic.period;
    term.amplitude[k] = std::polar(harmonic.amplitude, harmonic.phase - 0.5 * std::numbers::pi);  // sine, not cosine
    motion.terms.add(term);
  }
}

/// Second derivatives of the natural cubic spline through the points of one freedom (Thomas' algorithm).
void find_second_derivatives(const MotionHistory& history, std::size_t freedom, std::vector<Six>& curve) {
  const std::vector<double>& t = history.time;
  const std::size_t n = t.size();
  const auto y = [&](std::size_t i) { return history.freedoms[i][freedom]; };
  std::vector<double> upper(n, 0.0), right(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
    const double bend = 6.0 * ((y(i + 1) - y(i)) / after - (y(i) - y(i - 1)) / before);
    const double pivot = 2.0 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    right[i] = (bend - before * right[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) curve[i][freedom] = right[i] - upper[i] * curve[i + 1][freedom];
}

void set_motion_spline(VesselMotionModel& motion, const VesselDescription& vessel) {
  const MotionHistory& history = *vessel.history;
  require(history.time.size() >= 2 && history.freedoms.size() == history.time.size(),
          "a recorded motion needs at least two instants with six freedoms each");
  motion.reference_V = vessel.motion_reference_V;
  motion.spline.time = history.time;
  motion.spline.value = history.freedoms;
  motion.spline.curve.assign(history.time.size(), Six{});
  for (std::size_t k = 0; k < 6; ++k) find_second_derivatives(history, k, motion.spline.curve);
  motion.first = history.time.front();
  motion.last = history.time.back();
}

// Evaluation ------------------------------------------------------------------------------------------------------

ResponseSums response_sums_for(Isa isa) {
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) return isa_avx512::sum_responses;
  if (isa == Isa::avx2) return isa_avx2::sum_responses;
#endif
  (void)isa;
  return isa_baseline::sum_responses;
}

void add_terms(const MotionTerms& terms, const MoveAhead& move, double t, Freedoms& f) {
  static const ResponseSums kSums = response_sums_for(best_isa());
  const ResponseInstant instant{t,
                                move.at.distance,
                                move.at.speed,
                                move.at.acceleration,
                                move.wave_numbers.data(),
                                static_cast<int>(std::min(move.wave_numbers.size(), terms.size()))};
  std::array<double, 18> sums{};
  kSums(terms.view(), instant, sums.data());
  for (std::size_t k = 0; k < 6; ++k) {
    f.value[k] += sums[3 * k];
    f.rate[k] += sums[3 * k + 1];
    f.acceleration[k] += sums[3 * k + 2];
  }
}

/// The spline within its range.
Freedoms on_spline(const MotionSpline& spline, double t) {
  const auto after = std::upper_bound(spline.time.begin() + 1, spline.time.end() - 1, t);
  const auto j = static_cast<std::size_t>(after - spline.time.begin()), i = j - 1;
  const double h = spline.time[j] - spline.time[i];
  const double b = (t - spline.time[i]) / h, a = 1.0 - b;
  Freedoms f;
  for (std::size_t k = 0; k < 6; ++k) {
    const double yi = spline.value[i][k], yj = spline.value[j][k], ci = spline.curve[i][k], cj = spline.curve[j][k];
    f.value[k] = a * yi + b * yj + (a * (a * a - 1.0) * ci + b * (b * b - 1.0) * cj) * h * h / 6.0;
    f.rate[k] = (yj - yi) / h + ((1.0 - 3.0 * a * a) * ci + (3.0 * b * b - 1.0) * cj) * h / 6.0;
    f.acceleration[k] = a * ci + b * cj;
  }
  return f;
}

Freedoms at_rest(const Six& value) {
  return {value, {}, {}};
}

Freedoms from_history(const MotionSpline& spline, double t) {
  const double first = spline.time.front(), last = spline.time.back();
  if (t >= last) return at_rest(spline.value.back());
  if (t >= first) return on_spline(spline, t);
  // The second derivative is zero at the ends, so that point reflection leaves the acceleration continuous.
  const double image = 2.0 * first - t;
  Freedoms f = image < last ? on_spline(spline, image) : at_rest(spline.value.back());
  for (std::size_t k = 0; k < 6; ++k) {
    f.value[k] = 2.0 * spline.value.front()[k] - f.value[k];
    f.acceleration[k] = -f.acceleration[k];
  }
  return f;
}

void build_up(Freedoms& f, const BuildUp& b) {
  for (std::size_t k = 0; k < 6; ++k) {
    f.acceleration[k] = b.acceleration * f.value[k] + 2.0 * b.rate * f.rate[k] + b.value * f.acceleration[k];
    f.rate[k] = b.rate * f.value[k] + b.value * f.rate[k];
    f.value[k] *= b.value;
  }
}

Vec3 translation(const Six& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

MotionTerm MotionTerms::operator[](std::size_t i) const {
  MotionTerm term;
  term.omega = omega_[i];
  for (std::size_t k = 0; k < 6; ++k) term.amplitude[k] = {parts_[2 * k][i], parts_[2 * k + 1][i]};
  return term;
}

void MotionTerms::add(const MotionTerm& term) {
  if (count_ == omega_.size()) {
    omega_.resize(count_ + kLanes, 0.0);
    for (AlignedDoubles& part : parts_) part.resize(count_ + kLanes, 0.0);
  }
  omega_[count_] = term.omega;
  for (std::size_t k = 0; k < 6; ++k) {
    parts_[2 * k][count_] = term.amplitude[k].real();
    parts_[2 * k + 1][count_] = term.amplitude[k].imag();
  }
  ++count_;
}

ResponseView MotionTerms::view() const {
  ResponseView view{static_cast<int>(omega_.size()), omega_.data(), {}};
  std::transform(parts_.begin(), parts_.end(), view.parts, [](const AlignedDoubles& part) { return part.data(); });
  return view;
}

VesselMotionModel make_vessel_motion(const Model& model, const Sea& sea) {
  VesselMotionModel motion = make_body_motion(model.description.vessel, model.mean_pose, sea);
  motion.ahead_W = level_ahead(model.nominal_pose);
  return motion;
}

VesselMotionModel make_body_motion(const VesselDescription& vessel, const VesselPose& mean, const Sea& sea) {
  VesselMotionModel motion;
  motion.mean = mean;
  motion.ahead_W = level_ahead(mean);
  switch (vessel.motion) {
    case VesselMotion::fixed:
      return motion;
    case VesselMotion::harmonic:
      add_harmonic_terms(motion, vessel);
      return motion;
    case VesselMotion::raos:
      if (!vessel.raos) throw std::invalid_argument("the vessel's RAOs, " + vessel.motion_file + ", could not be read");
      add_rao_terms(motion, *vessel.raos, sea);
      return motion;
    case VesselMotion::history:
      if (!vessel.history) {
        throw std::invalid_argument("the motion history of the vessel, " + vessel.motion_file + ", could not be read");
      }
      set_motion_spline(motion, vessel);
      return motion;
    case VesselMotion::coupled:
      break;
  }
  throw std::invalid_argument("coupled vessel motion (vessel.motion.coupled) is not available here");
}

Vec3 level_ahead(const VesselPose& mean) {
  const Vec3 forward = mean.R_WV.col(0);
  return Vec3(forward.x(), forward.y(), 0.0).normalized();
}

std::vector<double> wave_numbers_ahead(const VesselMotionModel& motion, const Sea& sea) {
  std::vector<double> numbers;
  if (motion.terms.size() != sea.components.size()) return numbers;  // terms that do not belong to waves
  const Vec3& ahead = motion.ahead_W;
  for (const WaveComponent& wave : sea.components) numbers.push_back(wave.kx * ahead.x() + wave.ky * ahead.y());
  return numbers;
}

RigidMotion vessel_motion(const VesselMotionModel& motion, double t, const BuildUp& b) {
  return vessel_motion(motion, {}, t, b);
}

RigidMotion vessel_motion(const VesselMotionModel& motion, const MoveAhead& move, double t, const BuildUp& b) {
  const MoveState& ahead = move.at;
  Freedoms f = motion.spline.time.empty() ? Freedoms{} : from_history(motion.spline, t);
  add_terms(motion.terms, move, t, f);
  build_up(f, b);

  // R = R_mean Rz(yaw) Ry(pitch) Rx(roll); rotation axes of yaw, pitch and roll, in the frame of the mean pose.
  const Mat3 Rz = Eigen::AngleAxisd(f.value[5], Vec3::UnitZ()).toRotationMatrix();
  const Mat3 Rzy = Rz * Eigen::AngleAxisd(f.value[4], Vec3::UnitY()).toRotationMatrix();
  const Vec3 yaw_rate = f.rate[5] * Vec3::UnitZ();
  const Vec3 pitch_rate = f.rate[4] * Rz.col(1);
  const Vec3 roll_rate = f.rate[3] * Rzy.col(0);
  const Vec3 omega = yaw_rate + pitch_rate + roll_rate;
  const Vec3 alpha = f.acceleration[5] * Vec3::UnitZ() + f.acceleration[4] * Rz.col(1) +
                     f.acceleration[3] * Rzy.col(0) + yaw_rate.cross(pitch_rate) +
                     (yaw_rate + pitch_rate).cross(roll_rate);

  RigidMotion m;
  const Mat3& R = motion.mean.R_WV;
  m.freedoms = f.value;
  m.omega = R * omega;
  m.alpha = R * alpha;
  m.pose.R_WV = R * Rzy * Eigen::AngleAxisd(f.value[3], Vec3::UnitX()).toRotationMatrix();
  const Vec3 r = m.pose.R_WV * motion.reference_V;  // from V's origin to the reference point
  m.pose.p_WV = motion.mean.p_WV + R * (motion.reference_V + translation(f.value)) - r;
  m.velocity = R * translation(f.rate) - m.omega.cross(r);
  m.acceleration = R * translation(f.acceleration) - m.alpha.cross(r) - m.omega.cross(m.omega.cross(r));
  if (ahead.distance != 0.0 || ahead.speed != 0.0 || ahead.acceleration != 0.0) {
    const Vec3& along = motion.ahead_W;
    m.pose.p_WV += ahead.distance * along;
    m.velocity += ahead.speed * along;
    m.acceleration += ahead.acceleration * along;
  }
  return m;
}

PointMotion point_motion(const RigidMotion& m, const Vec3& p_V) {
  const DirectionMotion r = direction_motion(m, p_V);
  return {m.pose.p_WV + r.direction, m.velocity + r.rate, m.acceleration + r.acceleration};
}

DirectionMotion direction_motion(const RigidMotion& m, const Vec3& d_V) {
  const Vec3 d = m.pose.R_WV * d_V;
  const Vec3 rate = m.omega.cross(d);
  return {d, rate, m.alpha.cross(d) + m.omega.cross(rate)};
}

}  // namespace overbend
