#include "seafiles/orcaflex_hull.h"

#include <array>
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "base/yaml_document.h"
#include "orcaflex/unit_system.h"
#include "seafiles/hull_data_builder.h"
#include "seafiles/hull_statements.h"
#include "seafiles/hull_text.h"
#include "seafiles/rao_formats.h"
#include "seafiles/reference_point.h"

namespace overbend {
namespace {

using orcaflex::Object;
using rao_formats::OrcaFlexRaos;
using rao_formats::RaoFile;

/// Signs of surge to yaw for the mirror image at midship.
constexpr std::array<double, 6> kForeAftSigns = {-1.0, 1.0, 1.0, 1.0, -1.0, -1.0};

/// Thrown after errors were added to the diagnostics.
struct ReportedError {};

class OrcaFlexHullReader {
 public:
  OrcaFlexHullReader(const HydrodynamicsSource& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {
    settings_.vessel_type = source.vessel_type;
    settings_.draught = source.draught;
  }

  HydrodynamicData read() {
    const std::optional<std::string> text = read_text_file(source_.path, diagnostics_);
    if (!text) throw ReportedError();
    root_ = parse_yaml(*text, source_.path, diagnostics_);
    stop_after_errors();
    const Object root(*root_, {source_.path, "", &diagnostics_});
    units_ = orcaflex::read_units(root.object("General"));
    data_.source = source_.path;
    data_.origin_V = source_.origin_V;
    data_.water_density = source_.water_density;
    data_.gravity = units_.gravity;
    const RaoFile loads = read_raos(*text, OrcaFlexRaos::load);
    const bool with_drift = rao_formats::has_orcaflex_raos(*text, settings_, OrcaFlexRaos::drift);
    const RaoFile drift = with_drift ? read_raos(*text, OrcaFlexRaos::drift) : RaoFile();
    read_draught(root);
    stop_after_errors();
    add_loads(loads);
    add_drift(drift);
    builder_.build(data_, source_.mirror_headings || loads.symmetry == RaoSymmetry::port_starboard ||
                              loads.symmetry == RaoSymmetry::quarters);
    check_same_frequencies(data_, source_.path, source_.path, diagnostics_);
    refer(loads, drift);
    return std::move(data_);
  }

 private:
  void stop_after_errors() const {
    if (diagnostics_.has_errors()) throw ReportedError();
  }

  RaoFile read_raos(const std::string& text, OrcaFlexRaos kind) {
    RaoFile raos = rao_formats::read_orcaflex(text, source_.path, settings_, diagnostics_, kind);
    stop_after_errors();
    if (raos.symmetry == RaoSymmetry::circular) {
      throw HullFileError("Symmetry: circular", "loads for all headings: save them with Symmetry: None");
    }
    return raos;
  }

  /// Selected item of a list, which rao_formats::read_orcaflex found as well.
  static std::optional<Object> choose(const std::vector<Object>& list, const std::string& wanted) {
    if (wanted.empty() && list.size() == 1) return list.front();
    for (const Object& item : list) {
      if (item.name() == wanted) return item;
    }
    return std::nullopt;
  }

  void read_draught(const Object& root) {
    const std::optional<Object> type = choose(root.objects("VesselTypes"), settings_.vessel_type);
    const std::optional<Object> draught =
        type ? choose(type->objects("Draughts"), settings_.draught) : std::optional<Object>();
    if (!draught) throw HullFileError("no draught of the vessel type", "its load RAOs, added mass and damping");
    read_axes(*draught);
    read_radiation(*draught, type->text("WavesReferredToBy", "period (s)"));
    read_stiffness(*draught);
    if (const auto mass = draught->number("Mass")) statements_.mass = *mass * units_.mass;
    if (const auto volume = draught->number("DisplacedVolume")) {
      statements_.displaced_volume = *volume * std::pow(units_.length, 3);
    }
    if (!draught->numbers("CentreOfMass").empty()) {
      statements_.centre_of_gravity = axes_ + draught->triple("CentreOfMass") * units_.length;
      check_point(*statements_.centre_of_gravity, draught->find_line("CentreOfMass"), "the centre of mass");
      statements_.centre_in_file = "CentreOfMass " + point_text(draught->triple("CentreOfMass") * units_.length);
    }
    if (draught->text("WaveDriftQTFMethod") == "Full QTFs") {
      data_.notes.push_back("Full quadratic transfer functions in " + file_name(source_.path) + " are left out.");
    }
  }

  /// Origin of the vessel's axes: the file states the height of the reference origin over the water.
  void read_axes(const Object& draught) {
    const Vec3 reference = draught.triple("ReferenceOrigin") * units_.length;
    axes_ = source_.file_origin;
    const std::vector<std::optional<double>> datum = draught.numbers("ReferenceOriginDatumPosition");
    if (!datum.empty() && datum.front() && source_.file_origin.z() == 0.0) {
      axes_.z() = *datum.front() * units_.length - reference.z();
    }
    check_point(axes_, draught.find_line("ReferenceOriginDatumPosition"), "the datum position, [z, heel, trim]");
    check_point(reference, draught.find_line("ReferenceOrigin"), "the reference origin");
    statements_.reference = axes_ + reference;
    if (source_.file_origin.isZero()) {
      data_.notes.push_back("The vessel axes of " + file_name(source_.path) + " are taken to begin at midship.");
    }
  }

  double frequency(double value, const std::string& kind) const {
    if (kind == "period (s)") return value == 0.0 ? kInfinity : std::isinf(value) ? 0.0 : kTurn / value;
    return kind == "frequency (Hz)" ? kTurn * value : value;
  }

  void read_radiation(const Object& draught, const std::string& waves) {
    const std::vector<Object> list = draught.objects("FrequencyDependentAddedMassAndDamping");
    if (list.empty()) {
      throw HullFileError(draught.line(), "no FrequencyDependentAddedMassAndDamping",
                          "added mass and damping by frequency (AMDMethod: Frequency dependent)");
    }
    for (const Object& item : list) {
      const std::optional<double> value = item.number("AMDPeriodOrFrequency");
      if (!value || !(*value >= 0.0)) {
        throw HullFileError(item.line(), "no AMDPeriodOrFrequency of 0 or more", "a period or frequency");
      }
      const double omega = frequency(*value, waves);
      const Mat6 mass = read_matrix(item, {"AddedMassMatrixX", "AddedMassMatrixY", "AddedMassMatrixZ",
                                           "AddedMassMatrixRx", "AddedMassMatrixRy", "AddedMassMatrixRz"});
      const bool finite = omega > 0.0 && std::isfinite(omega);
      const Mat6 damping =
          !finite ? Mat6(Mat6::Zero())
                  : read_matrix(item, {"DampingX", "DampingY", "DampingZ", "DampingRx", "DampingRy", "DampingRz"});
      for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
          const double arms = std::pow(units_.length, (i > 2 ? 1 : 0) + (j > 2 ? 1 : 0));
          builder_.add_added_mass(omega, i, j, mass(i, j) * units_.mass * arms, item.line());
          if (finite) builder_.add_damping(omega, i, j, damping(i, j) * units_.stiffness() * arms, item.line());
        }
      }
    }
  }

  Mat6 read_matrix(const Object& item, const std::array<const char*, 6>& columns) {
    const auto table = item.table(columns[0]);
    if (!table || table->size() != 6) {
      throw HullFileError(
          item.line(),
          table ? std::to_string(table->size()) + " rows of " + columns[0] : std::string("no ") + columns[0],
          "six rows of six numbers");
    }
    Mat6 matrix;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        const auto value = table->number(i, columns[j]);
        if (!value || !std::isfinite(*value)) {
          throw HullFileError(table->line(i), "no number in the column " + std::string(columns[j]),
                              "six finite numbers");
        }
        matrix(static_cast<int>(i), static_cast<int>(j)) = *value;
      }
    }
    return matrix;
  }

  void read_stiffness(const Object& draught) {
    constexpr std::array<const char*, 3> kColumns = {"HydrostaticStiffnessz", "HydrostaticStiffnessRx",
                                                     "HydrostaticStiffnessRy"};
    const auto table = draught.table(kColumns[0]);
    if (!table || table->size() != 3) {
      throw HullFileError(draught.line(), "no HydrostaticStiffnessz, HydrostaticStiffnessRx, HydrostaticStiffnessRy",
                          "three rows of three numbers");
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const auto value = table->number(i, kColumns[j]);
        if (!value || !std::isfinite(*value)) {
          throw HullFileError(table->line(i), "no number in the column " + std::string(kColumns[j]),
                              "three finite numbers");
        }
        const double arms = std::pow(units_.length, (i > 0 ? 1 : 0) + (j > 0 ? 1 : 0));
        data_.hydrostatic_stiffness(static_cast<int>(i) + 2, static_cast<int>(j) + 2) =
            *value * units_.stiffness() * arms;
      }
    }
  }

  static RaoTranslation translation(const RaoFile& raos, bool crest) {
    ConventionValues convention = convention_set("orcaflex");
    for (const auto& [key, word] : raos.stated.values) convention[key] = word;
    if (crest) convention["phase_zero"] = "crest";  // drift has no phases
    return {convention, 1.0, 0.0};
  }

  static bool has_fore_aft_symmetry(const RaoFile& raos) {
    return raos.symmetry == RaoSymmetry::fore_aft || raos.symmetry == RaoSymmetry::quarters;
  }

  void add_loads(const RaoFile& loads) {
    const RaoTranslation convention = translation(loads, false);
    for (const RaoRecord& record : loads.records) {
      const double heading = convention.heading(record.heading);
      const std::complex<double> force = convention.response(record);
      builder_.add_force(record.omega, heading, record.freedom, force, record.line);
      if (!has_fore_aft_symmetry(loads)) continue;
      builder_.add_force(record.omega, kPi - heading, record.freedom,
                         kForeAftSigns[static_cast<std::size_t>(record.freedom)] * force, record.line);
    }
  }

  void add_drift(const RaoFile& drift) {
    if (drift.records.empty()) return;
    const RaoTranslation convention = translation(drift, true);
    for (const RaoRecord& record : drift.records) {
      const double heading = convention.heading(record.heading);
      const double force = record.omega < source_.drift_from ? 0.0 : convention.response(record).real();
      builder_.add_drift(record.omega, heading, record.freedom, force, record.line);
      if (!has_fore_aft_symmetry(drift)) continue;
      builder_.add_drift(record.omega, kPi - heading, record.freedom,
                         kForeAftSigns[static_cast<std::size_t>(record.freedom)] * force, record.line);
    }
  }

  Vec3 in_vessel(const std::optional<Vec3>& point) const { return axes_ + point.value_or(Vec3::Zero()); }

  /// Loads, drift and matrices may each have another reference point.
  void refer(const RaoFile& loads, const RaoFile& drift) {
    HydrodynamicData moved = data_, moved_drift = data_;
    move_coefficients(moved, {in_vessel(loads.stated.reference), in_vessel(loads.stated.wave_origin)},
                      phase_depth(source_, statements_));
    move_coefficients(moved_drift, {in_vessel(drift.stated.reference), in_vessel(drift.stated.reference)},
                      phase_depth(source_, statements_));
    complete_hull(data_, statements_, source_, diagnostics_);
    data_.force = moved.force;
    data_.mean_drift = moved_drift.mean_drift;
  }

  const HydrodynamicsSource& source_;
  Diagnostics& diagnostics_;
  RaoSettings settings_;
  std::optional<YamlNode> root_;
  orcaflex::UnitSystemOfFile units_;
  Vec3 axes_ = Vec3::Zero();  ///< Origin of the axes of the file, frame V [m].
  HydrodynamicData data_;
  HullStatements statements_;
  HullDataBuilder builder_;
};

}  // namespace

std::optional<HydrodynamicData> read_orcaflex_hull(const HydrodynamicsSource& source, Diagnostics& diagnostics) {
  Diagnostics found;
  std::optional<HydrodynamicData> data;
  try {
    data = OrcaFlexHullReader(source, found).read();
  } catch (const ReportedError&) {
    data = std::nullopt;
  } catch (const HullFileError& error) {
    add_error(error, source.path, found);
  }
  for (const Diagnostic& diagnostic : found.sorted()) diagnostics.add(diagnostic);
  return found.has_errors() ? std::nullopt : std::move(data);
}

}  // namespace overbend
