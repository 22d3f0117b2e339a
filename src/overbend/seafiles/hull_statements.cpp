#include "seafiles/hull_statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/shown_unit.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/hull_file_error.h"
#include "seafiles/hull_text.h"
#include "seafiles/reference_point.h"

namespace overbend {
namespace {

constexpr double kSameHullDepth = 0.05, kSameHullMass = 0.02, kSameConstant = 1e-3;  // relative
constexpr double kSameHullPoint = 0.05;                                              // [m]
constexpr double kNoMove = 1e-9;                                                     // [m]

/// True if the longest waves of a sea are deep-water waves in both depths [m].
bool is_deep(double a, double b) {
  constexpr double kMinFrequency = kTurn / 20.0;  // [rad/s]
  return std::min(a, b) * kMinFrequency * kMinFrequency / kGravity > kPi;
}

class HullCompletion {
 public:
  HullCompletion(HydrodynamicData& data, const HullStatements& statements, const HydrodynamicsSource& source,
                 Diagnostics& diagnostics)
      : data_(data), statements_(statements), source_(source), diagnostics_(diagnostics) {}

  void run() {
    check_depth();
    check_mass();
    check_centre_of_gravity();
    add_weight();
    move();
    if (data_.has_infinite) return;
    data_.notes.push_back("The added mass at infinite frequency follows from the radiation damping: " +
                          file_name(data_.source) + " has none.");
  }

 private:
  void warn(std::string remark) {
    diagnostics_.add({Severity::warning, source_.path, 0, 0, "", std::move(remark), "", ""});
  }

  StiffnessContents contents() const { return source_.stiffness.value_or(statements_.stiffness); }

  Vec3 reference() const {
    const std::optional<Vec3> stated = stated_reference(source_);
    return stated ? *stated : statements_.reference.value_or(source_.origin_V);
  }

  void check_depth() {
    const auto& depth = statements_.water_depth;
    if (!depth || !(source_.water_depth > 0.0) || is_deep(*depth, source_.water_depth)) return;
    if (std::isfinite(*depth) && std::abs(*depth / source_.water_depth - 1.0) <= kSameHullDepth) return;
    warn("the file is for " +
         (std::isfinite(*depth) ? "a water depth of " + format_number(*depth) + " m" : std::string("deep water")) +
         ", the model has " + format_number(source_.water_depth) +
         " m; the response to long waves depends on the depth");
  }

  void check_mass() {
    const std::string model = format_quantity(source_.mass, "kg", "t");
    if (!(source_.mass > 0.0)) return;
    if (statements_.mass && std::abs(*statements_.mass / source_.mass - 1.0) > kSameHullMass) {
      warn("the file is for a mass of " + format_quantity(*statements_.mass, "kg", "t") + ", the model has " + model);
    } else if (statements_.displaced_volume) {
      const double displaced = data_.water_density * *statements_.displaced_volume;
      if (std::abs(displaced / source_.mass - 1.0) <= kSameHullMass) return;
      warn("the hull of the file displaces " + format_quantity(displaced, "kg", "t") +
           " of water, the model has a mass of " + model);
    }
  }

  void check_centre_of_gravity() {
    const auto& stated = statements_.centre_of_gravity;
    if (!stated || (*stated - source_.origin_V).norm() <= kSameHullPoint) return;
    const std::string found =
        (statements_.centre_in_file.empty() ? "a centre of gravity " + point_text(*stated - source_.file_origin)
                                            : statements_.centre_in_file) +
        " in the axes of the file, whose origin is at " + point_text(source_.file_origin) + " of the vessel";
    const std::string expected = "the model's centre_of_gravity, " + point_text(source_.origin_V);
    if (contents() == StiffnessContents::hydrostatic_only) return warn(found + "; " + expected + ", is used");
    throw HullFileError(found, expected + ": the file's stiffness includes the weight at this point",
                        "if the axes of the file have another origin, set convention.file_origin");
  }

  /// Moment of the weight over heel, -m g zg, with the height zg of the centre of gravity over the reference point. The
  /// coupling of roll and pitch with yaw vanishes, because the hull is in equilibrium.
  void add_weight() {
    if (contents() == StiffnessContents::with_weight) return;
    if (!(source_.mass > 0.0)) throw HullFileError("a stiffness without weight", "the mass of the vessel, to add it");
    const double height = source_.origin_V.z() - reference().z();
    const double moment = -source_.mass * kGravity * height;
    data_.hydrostatic_stiffness(3, 3) += moment;
    data_.hydrostatic_stiffness(4, 4) += moment;
    data_.hydrostatic_stiffness(3, 5) = data_.hydrostatic_stiffness(4, 5) = 0.0;
    data_.notes.push_back(
        fmt::format("The hydrostatic stiffness in {} is without weight: -m g zg = {} is added to roll and pitch, with "
                    "the centre of gravity {} above the reference point of the file.",
                    file_name(data_.source), shown(moment, "N m", 0), shown_digits(height, "m", 4)));
  }

  void move() {
    const FilePoints from = {reference(), statements_.wave_origin.value_or(reference())};
    const Vec3& gravity = source_.origin_V;
    if ((from.reference - gravity).norm() < kNoMove && (from.wave_origin - gravity).head<2>().norm() < kNoMove) return;
    move_coefficients(data_, from, phase_depth(source_, statements_));
    if ((from.wave_origin - from.reference).head<2>().norm() < kNoMove) return;
    data_.notes.push_back(
        fmt::format("The phases of the wave forces in {} refer to the crest at x = {}, y = {} of the vessel; they are "
                    "turned to the centre of gravity.",
                    file_name(data_.source), shown_digits(from.wave_origin.x(), "m", 4),
                    shown_digits(from.wave_origin.y(), "m", 4)));
  }

  HydrodynamicData& data_;
  const HullStatements& statements_;
  const HydrodynamicsSource& source_;
  Diagnostics& diagnostics_;
};

std::string period_list(const std::vector<double>& omegas) {
  constexpr std::size_t kShown = 3;
  std::vector<std::string> periods;
  for (std::size_t k = 0; k < std::min(omegas.size(), kShown); ++k) {
    periods.push_back(format_number(kTurn / omegas[k], 4) + " s");
  }
  if (omegas.size() > kShown) periods.push_back(std::to_string(omegas.size() - kShown) + " other periods");
  return join_items(periods, "and");
}

}  // namespace

void complete_hull(HydrodynamicData& data, const HullStatements& statements, const HydrodynamicsSource& source,
                   Diagnostics& diagnostics) {
  HullCompletion(data, statements, source, diagnostics).run();
}

double settled_constant(const char* name, double stated_by_user, double default_value, double stated_in_file) {
  if (!(stated_in_file > 0.0)) {
    throw HullFileError(std::string(name) + " = " + format_number(stated_in_file), "above 0");
  }
  if (stated_by_user == default_value || std::abs(stated_by_user / stated_in_file - 1.0) <= kSameConstant) {
    return stated_in_file;
  }
  throw HullFileError(std::string(name) + " = " + format_number(stated_in_file),
                      "that of vessel.motion.coupled.convention, " + format_number(stated_by_user),
                      "leave the key out: the file states it");
}

void check_same_frequencies(const HydrodynamicData& data, const std::string& file, const std::string& other_file,
                            Diagnostics& diagnostics) {
  constexpr double kSame = 1e-4;  // relative: files print five digits or more
  const std::vector<double>& known = data.excitation.omega;
  if (known.empty()) return;
  std::vector<double> between, outside;
  for (const RadiationPoint& point : data.radiation) {
    const auto next = std::lower_bound(known.begin(), known.end(), point.omega * (1.0 - kSame));
    if (next != known.end() && *next <= point.omega * (1.0 + kSame)) continue;
    (next == known.begin() || next == known.end() ? outside : between).push_back(point.omega);
  }
  const std::string which = ", which " + (file == other_file ? "its added mass" : file_name(other_file)) + " has";
  const auto warn = [&](const std::vector<double>& omegas, const std::string& consequence) {
    if (omegas.empty()) return;
    diagnostics.add({Severity::warning, file, 0, 0, "",
                     "no excitation at " + period_list(omegas) + which + "; " + consequence, "", ""});
  };
  warn(between, "the wave forces there are interpolated linearly between the neighbouring periods");
  warn(outside, "waves of these periods are outside the wave forces of the file");
}

void use_stated_stiffness(HydrodynamicData& data, const HydrodynamicsSource& source) {
  if (!source.stated_stiffness) {
    throw HullFileError("no hydrostatic stiffness", "stiffness in the file, or of the vessel in the model",
                        "vessel.motion.coupled.hydrostatics gives heave, roll and pitch");
  }
  data.hydrostatic_stiffness = Mat6::Zero();
  data.hydrostatic_stiffness.diagonal().segment<3>(2) = *source.stated_stiffness;
  data.notes.push_back("The hydrostatic stiffness of the hull is that of the model: " + file_name(data.source) +
                       " has none.");
}

double phase_depth(const HydrodynamicsSource& source, const HullStatements& statements) {
  constexpr double kDeep = 1e4;
  if (source.water_depth > 0.0) return source.water_depth;
  const double stated = statements.water_depth.value_or(kDeep);
  return stated > 0.0 ? std::min(stated, kDeep) : kDeep;
}

std::string point_text(const Vec3& p) {
  return "(" + format_number(p.x()) + ", " + format_number(p.y()) + ", " + format_number(p.z()) + ") m";
}

std::optional<Vec3> stated_reference(const HydrodynamicsSource& source) {
  if (source.reference) return source.reference;
  if (!source.origin) return std::nullopt;
  if (*source.origin == HullOrigin::gravity_centre) return source.origin_V;
  return Vec3(source.file_origin.x(), source.file_origin.y(), 0.0);
}

}  // namespace overbend
