#include "modelfile/reading/hull_files.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/constants.h"
#include "base/units.h"
#include "model/site/wave_groups.h"
#include "model/waves/rao_table.h"
#include "modelfile/binding/binding.h"
#include "modelfile/checks/hull_plausibility.h"
#include "modelfile/fields/field_table.h"
#include "seafiles/coefficient_table.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend {
namespace {

constexpr double kWidestGap = 46.0 * kDegree;  // headings at 45 deg can be interpolated
const std::string kHull = "vessel.motion.coupled";

HydrodynamicsSource read_source(const FieldValue& root, const Description& description) {
  const CoupledHullDescription& hull = *description.vessel.coupled;
  HydrodynamicsSource source;
  source.path = hull.hydrodynamics;
  source.origin_V = hull.centre_of_gravity;
  source.mass = hull.mass;
  source.water_depth = description.environment.water_depth;
  const std::string path = kHull + ".convention";
  const FieldValue* convention = root.find(path);
  if (convention != nullptr) bind_members(field_node(path), *convention, &source, description.source_file);
  const FieldValue* stiffness = root.find(kHull + ".hydrostatics");
  if (stiffness != nullptr && stiffness->given) {
    Vec3& values = source.stated_stiffness.emplace(Vec3::Zero());
    bind_members(field_node(kHull + ".hydrostatics"), *stiffness, &values, description.source_file);
  }
  return source;
}

/// Plausibility of the files' contents, reported at the key that names them.
class HullFileChecks {
 public:
  HullFileChecks(const FieldValue& root, const Description& description, Diagnostics& diagnostics)
      : at_(*root.find(kHull + ".hydrodynamics")), description_(description), diagnostics_(diagnostics) {}

  void judge(const HydrodynamicData& data) {
    waterplane(data);
    stability(data);
    modes(data);
    if (is_calm(description_.environment.waves)) return;
    headings(data.excitation.heading, "headings");
    if (description_.vessel.coupled->wave_drift != WaveDrift::none) {
      headings(data.drift.heading, "headings of the drift");
    }
  }

 private:
  void add_warning(Severity severity, std::string found, std::string expected, std::string hint) {
    diagnostics_.add({severity, description_.source_file, at_.line, 0, at_.path, std::move(found), std::move(expected),
                      std::move(hint)});
  }

  /// Checks the heave stiffness, waterplane area times rho g, against that of a box: a larger one indicates another
  /// length scale or another hull.
  void waterplane(const HydrodynamicData& data) {
    const VesselDescription& vessel = description_.vessel;
    const double area = data.hydrostatic_stiffness(2, 2) / (data.water_density * data.gravity);
    const double box = vessel.length * vessel.beam;
    if (area > 0.3 * box && area < 1.05 * box) return;
    add_warning(Severity::error,
                "a waterplane of " + format_number(area, 4) + " m^2, from the heave stiffness in the files",
                "0.3 to 1.05 of the vessel's length times beam, " + format_number(box, 4) + " m^2",
                "is convention.length_scale right, and are these the files of this hull?");
  }

  void stability(const HydrodynamicData& data) {
    for (const auto& [freedom, i] : {std::pair{"roll", 3}, std::pair{"pitch", 4}}) {
      const double stiffness = data.hydrostatic_stiffness(i, i);
      if (stiffness > 0.0) continue;
      add_warning(
          Severity::error,
          "a " + std::string(freedom) + " stiffness of " + format_number(1e-3 * stiffness, 4) + " kN*m", "more than 0",
          "is the stiffness without weight (convention.stiffness), or about another point (convention.origin)?");
    }
  }

  /// Reports modes without data: panel programs can omit modes, and these are not zero.
  void modes(const HydrodynamicData& data) {
    std::string silent;
    for (int i = 0; i < 6; ++i) {
      const bool has_added_mass =
          std::any_of(data.radiation.begin(), data.radiation.end(),
                      [&](const RadiationPoint& point) { return point.added_mass(i, i) != 0.0; });
      if (!has_added_mass) {
        silent += (silent.empty() ? "" : ", ") + std::string(kFreedomNames[static_cast<std::size_t>(i)]);
      }
    }
    if (silent.empty()) return;
    add_warning(Severity::warning, "no added mass of " + silent + " in the files; it is taken as zero", "all six modes",
                "was the panel program run for some modes only?");
  }

  void headings(const std::vector<double>& heading, const std::string& name) {
    if (heading.empty()) return;
    double gap = heading.front() + 2.0 * std::numbers::pi - heading.back();
    for (std::size_t i = 1; i < heading.size(); ++i) gap = std::max(gap, heading[i] - heading[i - 1]);
    if (gap < kWidestGap) return;
    add_warning(Severity::error, name + " with a gap of " + format_number(gap / kDegree, 3) + " deg",
                "headings over the full circle, at most 45 deg apart",
                "convention.headings: mirrored uses the other side of a symmetric hull");
  }

  const FieldValue& at_;
  const Description& description_;
  Diagnostics& diagnostics_;
};

}  // namespace

void read_hull_files(const FieldValue& root, Description& description, Diagnostics& diagnostics) {
  if (!description.vessel.coupled) return;
  CoupledHullDescription& hull = *description.vessel.coupled;
  const int errors = diagnostics.error_count();
  hull.data = read_hydrodynamics(read_source(root, description), diagnostics);
  if (hull.data) HullFileChecks(root, description, diagnostics).judge(*hull.data);
  if (diagnostics.error_count() == errors) check_hull_plausibility(root, description, diagnostics);
  if (hull.current.form == HullCurrentModel::table) {
    hull.current.table = read_coefficient_table(hull.current.table_file, diagnostics);
  }
  if (!hull.wind.table_file.empty()) {
    hull.wind.table = read_coefficient_table(hull.wind.table_file, diagnostics);
  }
}

}  // namespace overbend
