#include "modelfile/checks/hull_plausibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/shown_unit.h"
#include "base/units.h"
#include "model/pipe/section.h"
#include "model/waves/wave_theory.h"
#include "seafiles/displaced_volume.h"

namespace overbend {
namespace {

const std::string kHull = "vessel.motion.coupled";

class HullChecker {
 public:
  HullChecker(const FieldValue& root, const Description& description, Diagnostics& diagnostics)
      : root_(root),
        description_(description),
        vessel_(description.vessel),
        hull_(*description.vessel.coupled),
        water_density_(description.environment.water_weight_density / kGravity),
        diagnostics_(diagnostics) {}

  void check() {
    check_gyration();
    check_centre_of_gravity();
    if (!hull_.data) return;
    check_mass();
    check_metacentres();
    check_flotation();
    check_density();
    check_long_waves();
  }

 private:
  void report(Severity severity, const std::string& key, std::string found, std::string expected = {},
              std::string hint = {}) {
    const FieldValue* value = root_.find(kHull + "." + key);
    diagnostics_.add({severity, description_.source_file, value != nullptr ? value->line : 0, 0, kHull + "." + key,
                      std::move(found), std::move(expected), std::move(hint)});
  }

  void check_mass() {
    constexpr double kShare = 0.02;  // fraction of the displaced mass that may be pull of lines and pipe
    const auto estimate =
        displaced_volume(*hull_.data, {vessel_.length, vessel_.draught, description_.environment.water_depth});
    if (!estimate) return check_fineness();
    const double displaced = water_density_ * estimate->volume, ratio = hull_.mass / displaced;
    if (std::abs(ratio - 1.0) <= kShare + estimate->uncertainty) return;
    report(Severity::error, "mass", "a mass of " + format_quantity(hull_.mass, "kg", "t"),
           fmt::format(
               "the {} of water displaced by the hull, which the long-wave forces in its files give within {:.1f} %",
               format_quantity(displaced, "kg", "t", 5), 100.0 * (kShare + estimate->uncertainty)),
           fmt::format("constant forces of {} would balance the difference{}",
                       format_quantity(std::abs(hull_.mass - displaced) * kGravity, "N", "MN", 3),
                       ratio < 2e-3 ? "; is the mass in t?" : ""));
  }

  /// Without long waves in the files: block coefficient and waterplane coefficient are related.
  void check_fineness() {
    constexpr double kError = 0.4, kUnusual = 0.6;
    const double plane = hull_.data->hydrostatic_stiffness(2, 2) / (hull_.data->water_density * hull_.data->gravity);
    const double prism = water_density_ * plane * vessel_.draught, ratio = hull_.mass / prism;
    if (ratio > kUnusual) return;
    report(ratio > kError ? Severity::warning : Severity::error, "mass",
           fmt::format("a mass of {}, {:.2g} times the water under the waterplane down to the keel",
                       format_quantity(hull_.mass, "kg", "t"), ratio),
           ratio > kError ? "" : fmt::format("{:.1f} to 1.0 times {}", kUnusual, format_quantity(prism, "kg", "t", 5)),
           ratio < 2e-3 ? "is the mass in t?" : "");
  }

  /// Checks a radius of gyration against typical fractions of a hull dimension.
  void check_radius(const char* key, double radius, double size, const char* size_name, double low, double high) {
    const double share = radius / size;
    if (share >= low && share <= high) return;
    report(Severity::warning, std::string("gyration.") + key,
           fmt::format("{:.4g} m is {:.2g} times the {}; usual are {:.2g} to {:.2g} times", radius, share, size_name,
                       low, high));
  }

  void check_gyration() {
    const Vec3& r = hull_.gyration;
    check_radius("roll", r.x(), vessel_.beam, "beam", 0.25, 0.5);
    check_radius("pitch", r.y(), vessel_.length, "length", 0.18, 0.35);
    check_radius("yaw", r.z(), vessel_.length, "length", 0.18, 0.35);
    const Vec3 inertia = r.cwiseAbs2();
    Eigen::Index axis = 0;
    const double max_inertia = inertia.maxCoeff(&axis);
    if (max_inertia <= 1.01 * (inertia.sum() - max_inertia)) return;
    constexpr const char* kKeys[] = {"roll", "pitch", "yaw"};
    report(Severity::error, std::string("gyration.") + kKeys[axis], fmt::format("{:.4g} m", r(axis)),
           "a square not larger than the sum of the squares of the other two, as for any rigid body");
  }

  void check_centre_of_gravity() {
    const Vec3& g = hull_.centre_of_gravity;
    const double deck = vessel_.depth - vessel_.draught;
    const auto outside = [&](const char* axis, double value, double low, double high) {
      if (value >= low && value <= high) return;
      report(
          Severity::warning, std::string("centre_of_gravity.") + axis,
          fmt::format(
              "{:.4g} m is outside the hull, from {:.4g} m to {:.4g} m; is it measured from midship at the water line?",
              value, low, high));
    };
    outside("x", g.x(), -0.5 * vessel_.length, 0.5 * vessel_.length);
    outside("y", g.y(), -0.5 * vessel_.beam, 0.5 * vessel_.beam);
    outside("z", g.z(), -vessel_.draught, deck);
  }

  void check_metacentres() {
    check_metacentre("roll", 3, vessel_.length * std::pow(vessel_.beam, 3) / 12.0, 0.15);
    check_metacentre("pitch", 4, vessel_.beam * std::pow(vessel_.length, 3) / 12.0, 0.1 * vessel_.length);
  }

  /// `inertia`: that of the waterplane of a box, the maximum for a hull of this size.
  void check_metacentre(const char* freedom, int mode, double inertia, double lowest) {
    const double stiffness = hull_.data->hydrostatic_stiffness(mode, mode);
    if (!(stiffness > 0.0)) return;  // reported as an error before
    const double weight = hull_.mass * kGravity, height = stiffness / weight;
    const double highest = hull_.data->water_density * hull_.data->gravity * inertia / weight + vessel_.draught;
    if (height > 1.05 * highest) {
      report(Severity::error, "hydrodynamics",
             fmt::format("a metacentric height of {} in {}, from the stiffness in the files and the mass",
                         shown_digits(height, "m", 4), freedom),
             fmt::format("at most {}, that of a box of this length, beam and draught", shown_digits(highest, "m", 4)),
             "is convention.length_scale right, and are these the files of this hull?");
    } else if (height < lowest) {
      report(Severity::warning, "hydrodynamics",
             fmt::format("the metacentric height in {} is {}, from the stiffness in the files and the mass: the hull "
                         "is nearly unstable; do the files refer to this centre of gravity?",
                         freedom, shown_digits(height, "m", 2)));
    }
  }

  /// Checks that the centre of flotation, which the files give relative to the centre of gravity, is near midship and
  /// the centreline.
  void check_flotation() {
    constexpr double kOfLength = 0.1, kOfBeam = 0.05;
    const Mat6& stiffness = hull_.data->hydrostatic_stiffness;
    const Vec3& g = hull_.centre_of_gravity;
    check_flotation_along("x", g.x(), -stiffness(2, 4) / stiffness(2, 2), vessel_.length, kOfLength);
    check_flotation_along("y", g.y(), stiffness(2, 3) / stiffness(2, 2), vessel_.beam, kOfBeam);
  }

  void check_flotation_along(const char* axis, double gravity, double arm, double size, double share) {
    const double place = gravity + arm;
    if (std::abs(gravity) > 0.5 * size || std::abs(place) <= share * size) return;
    report(Severity::warning, std::string("centre_of_gravity.") + axis,
           fmt::format("with the centre of gravity at {} the centre of the waterplane is at {}, from the stiffness in "
                       "the files; it is usually within {} of {}: do the files refer to the centre of gravity?",
                       shown_digits(gravity, "m", 4), shown_digits(place, "m", 4), shown_digits(share * size, "m", 3),
                       axis[0] == 'x' ? "midship" : "the centreline"));
  }

  void check_density() {
    constexpr double kSame = 0.005;
    const double file = hull_.data->water_density;
    if (std::abs(file / water_density_ - 1.0) <= kSame) return;
    report(Severity::warning, "convention.water_density",
           fmt::format("the values in the files are for water of {:.5g} kg/m^3, the water of the model has {:.5g} "
                       "kg/m^3 (environment.water_weight_density): forces and stiffness of the hull differ by {:.1f} %",
                       file, water_density_, 100.0 * std::abs(file / water_density_ - 1.0)));
  }

  /// Checks the forces of the longest wave, if it is much longer than the hull: heave towards the heave stiffness, and
  /// surge and sway down the slope of the wave, a quarter period before the crest for waves from behind.
  void check_long_waves() {
    constexpr double kMaxPhase = 0.6;  // k L / 2
    const HydrodynamicData& data = *hull_.data;
    if (data.excitation.omega.empty()) return;
    const double omega = data.excitation.omega.front();
    const double k = linear_wave_number(omega, description_.environment.water_depth);
    if (!(vessel_.length > 0.0) || 0.5 * k * std::max(vessel_.length, vessel_.beam) > kMaxPhase) return;
    for (std::size_t j = 0; j < data.excitation.heading.size(); ++j) {
      const CVec6& force = data.force[data.excitation.index(0, j)];
      check_long_wave_heave(force(2), k, omega);
      check_long_wave_push(force, data.excitation.heading[j], omega);
    }
  }

  void check_long_wave_heave(std::complex<double> force, double k, double omega) {
    // The orbital pressure decreases over the draught, and over half the length by at most the cosine of kMaxPhase.
    constexpr double kImpossibleLow = -0.3, kImpossibleHigh = 1.5;
    const double low = 0.7 * std::exp(-1.5 * k * vessel_.draught) - 0.1, high = 1.1;
    const double ratio = force.real() / hull_.data->hydrostatic_stiffness(2, 2);
    if (heave_reported_ || (ratio > low && ratio < high)) return;
    heave_reported_ = true;
    const std::string found = fmt::format(
        "a heave force of {:.2g} times the heave stiffness in waves of {:.3g} s period", ratio, kTurn / omega);
    const std::string expected =
        fmt::format("{:.2g} to {:.2g} times, as for ships and barges in long waves", low, high);
    if (ratio > kImpossibleLow && ratio < kImpossibleHigh) {  // columns on pontoons may do so
      return report(Severity::warning, "hydrodynamics", found + "; usual are " + expected);
    }
    report(Severity::error, "hydrodynamics", found, expected,
           "are the phases, the length scale and the gravity of the files as stated in convention?");
  }

  /// The hull slides down the slope: force leads the crest by 90 deg in the direction of travel.
  void check_long_wave_push(const CVec6& force, double heading, double omega) {
    constexpr double kMinForce = 0.02;  // of the heave force: small forces have no reliable phase
    const std::complex<double> push = std::cos(heading) * force(0) + std::sin(heading) * force(1);
    if (push_reported_ || std::abs(push) < kMinForce * std::abs(force(2)) || push.imag() > -0.7 * std::abs(push)) {
      return;
    }
    push_reported_ = true;
    report(
        Severity::error, "hydrodynamics",
        fmt::format("forces of waves of {:.3g} s period towards {:.4g} deg that push the hull up the slope of the wave",
                    kTurn / omega, heading * kToDegrees),
        "forces down the slope, a quarter period before the crest passes",
        "do phases of the files have the other sense, or do headings state where waves come from?");
  }

  const FieldValue& root_;
  const Description& description_;
  const VesselDescription& vessel_;
  const CoupledHullDescription& hull_;
  double water_density_;
  Diagnostics& diagnostics_;
  bool heave_reported_ = false, push_reported_ = false;
};

}  // namespace

void check_hull_plausibility(const FieldValue& root, const Description& description, Diagnostics& diagnostics) {
  if (description.vessel.coupled) HullChecker(root, description, diagnostics).check();
}

}  // namespace overbend
