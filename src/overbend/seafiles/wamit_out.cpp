#include "seafiles/wamit_out.h"

#include <fmt/format.h>

#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/body_number.h"
#include "seafiles/hull_data_builder.h"
#include "seafiles/hull_statements.h"

namespace overbend {
namespace {

constexpr int kMaxModes = 6 * 50;

class WamitOutputParser {
 public:
  explicit WamitOutputParser(const HullText& text) : text_(text) {}

  WamitOutput parse() {
    for (const TextRow& row : text_.rows()) take(row);
    if (!(out_.gravity > 0.0)) {
      throw HullFileError("no line 'Gravity: ... Length scale: ...'", "the complete output file of WAMIT");
    }
    if (out_.bodies.empty()) throw HullFileError("no BODY PARAMETERS", "the complete output file of WAMIT");
    return std::move(out_);
  }

 private:
  enum class Section { none, radiation, waves };

  void take(const TextRow& row) {
    if (begins_with_number(row)) return take_numbers(row);
    const std::string_view first = row.cells[0];
    if (first == "Wave") return take_wave(row);
    if (first.starts_with("****")) {
      section_ = Section::none;
    } else if (first == "Gravity:") {
      out_.gravity = require_number(row, 1, "the acceleration of gravity");
      out_.length_scale = require_number(row, row.cells.size() - 1, "the length scale");
      if (!(out_.gravity > 0.0) || !(out_.length_scale > 0.0)) {
        throw HullFileError(row.line, "gravity or length scale not above 0", "positive numbers");
      }
    } else if (contains(row, "Water depth:")) {
      take_depth(row);
    } else if (contains(row, "Total panels:")) {
      out_.bodies.emplace_back();
    } else if (!out_.bodies.empty()) {
      take_body(row, out_.bodies.back());
    }
    take_heading_line(row);
  }

  void take_depth(const TextRow& row) {
    const bool deep = row.cells.size() > 2 && row.cells[2] == "infinite";
    out_.water_depth = deep ? kInfinity : require_number(row, 2, "the water depth, or infinite");
    if (contains(row, "Water density:")) {
      out_.water_density = require_number(row, row.cells.size() - 1, "the density of the water");
    }
  }

  void take_body(const TextRow& row, WamitOutput::Body& body) {
    const std::string_view first = row.cells[0];
    if (first == "XBODY") {
      const std::vector<double> values = numbers_in(row);
      if (values.size() < 3) throw HullFileError(row.line, "'" + for_display(joined(row)) + "'", "XBODY, YBODY, ZBODY");
      body.place = Vec3(values[0], values[1], values[2]);
      check_point(body.place, row.line, "XBODY, YBODY, ZBODY");
      body.turned = values.size() > 3 ? values[3] * kDegree : 0.0;
    } else if (first == "Volumes") {
      const std::vector<double> v = require_numbers(row, row.cells.size() - 3, 3, "three volumes");
      body.volume = (v[0] + v[1] + v[2]) / 3.0;
    } else if (contains(row, "Center of Gravity")) {
      body.centre_of_gravity = require_point(row, row.cells.size() - 3, "Xg, Yg and Zg");
    } else if (first.starts_with("C(")) {
      take_stiffness(row, body);
    }
  }

  /// Rows "C(3,3),C(3,4),C(3,5):", "C(4,4),C(4,5),C(4,6):" and "C(5,5),C(5,6):".
  void take_stiffness(const TextRow& row, WamitOutput::Body& body) {
    if (!body.stiffness) body.stiffness = Mat6::Zero();
    Mat6& c = *body.stiffness;
    const std::string_view first = row.cells[0];
    const auto value = [&](std::size_t k) { return require_number(row, k, "a coefficient of the stiffness"); };
    if (first.starts_with("C(3,3)")) {
      c(2, 2) = value(1);
      c(2, 3) = c(3, 2) = value(2);
      c(2, 4) = c(4, 2) = value(3);
    } else if (first.starts_with("C(4,4)")) {
      c(3, 3) = value(1);
      c(3, 4) = c(4, 3) = value(2);
      c(3, 5) = value(3);
    } else if (first.starts_with("C(5,5)")) {
      c(4, 4) = value(1);
      c(4, 5) = value(2);
    }
  }

  void take_wave(const TextRow& row) {
    if (contains(row, "Wave period = infinite")) {
      omega_ = 0.0;
    } else if (contains(row, "Wave period = zero")) {
      omega_ = kInfinity;
    } else if (contains(row, "Wave period (sec) =")) {
      const double period = require_number(row, 4, "the wave period");
      constexpr double kMinPeriod = 1e-2, kMaxPeriod = 1e5;
      if (!(period > kMinPeriod && period < kMaxPeriod)) {
        throw HullFileError(row.line, "the period " + format_number(period) + " s", "a period of waves");
      }
      omega_ = kTurn / period;
    } else if (contains(row, "Wave Heading")) {
      const std::vector<double> angles = numbers_in(row);
      if (angles.empty()) throw HullFileError(row.line, "'" + for_display(joined(row)) + "'", "a wave heading");
      heading_ = angles[0] * kDegree;
      same_headings_ = angles.size() < 2 || std::abs(angles[1] - angles[0]) < 1e-6;
      return;
    } else {
      return;
    }
    section_ = Section::none;
  }

  void take_heading_line(const TextRow& row) {
    struct Title {
      const char* text;
      Section section;
      std::vector<WamitOutput::WaveValue>* values;
    };
    const Title titles[] = {
        {"ADDED-MASS", Section::radiation, nullptr},
        {"DIFFRACTION EXCITING FORCES AND MOMENTS", Section::waves, &out_.diffraction},
        {"HASKIND EXCITING FORCES AND MOMENTS", Section::waves, &out_.haskind},
        {"RESPONSE AMPLITUDE OPERATORS", Section::waves, &out_.motions},
        {"DRIFT FORCES (Momentum", Section::waves, &out_.drift_momentum},
        {"DRIFT FORCES (Pressure", Section::waves, &out_.drift_pressure},
        {"DRIFT FORCES (Control", Section::waves, &out_.drift_control_surface},
        {"FLUID DOMAIN", Section::none, nullptr},
        {"ON BODY", Section::none, nullptr},
        {"FROUDE", Section::none, nullptr},
    };
    for (const Title& title : titles) {
      if (!contains(row, title.text)) continue;
      section_ = title.section;
      values_ = title.values;
      same_headings_ = true;
      heading_ = std::nullopt;
    }
  }

  void take_numbers(const TextRow& row) {
    if (section_ == Section::radiation) take_radiation(row);
    if (section_ == Section::waves) take_wave_value(row);
  }

  double omega(const TextRow& row) const {
    if (!omega_) throw HullFileError(row.line, "coefficients before the first wave period", "a line 'Wave period ...'");
    return *omega_;
  }

  std::string place() const {
    if (*omega_ == 0.0) return "zero frequency";
    return std::isinf(*omega_) ? "infinite frequency" : format_number(kTurn / *omega_) + " s";
  }

  void take_radiation(const TextRow& row) {
    WamitOutput::Radiation value;
    value.omega = omega(row);
    value.line = row.line;
    value.i = require_integer(row, 0, 1, kMaxModes, "a mode of the hull");
    value.j = require_integer(row, 1, 1, kMaxModes, "a mode of the hull");
    const std::string pair = fmt::format("({},{}) at {}", value.i, value.j, place());
    value.added_mass = require_number(row, 2, "A" + pair);
    if (value.omega > 0.0 && std::isfinite(value.omega)) value.damping = require_number(row, 3, "B" + pair);
    out_.radiation.push_back(value);
  }

  void take_wave_value(const TextRow& row) {
    if (!heading_) throw HullFileError(row.line, "values before the first wave heading", "a line 'Wave Heading ...'");
    WamitOutput::WaveValue value;
    value.omega = omega(row);
    value.heading = *heading_;
    value.line = row.line;
    value.mode = std::abs(require_integer(row, 0, -kMaxModes, kMaxModes, "a mode of the hull"));
    if (value.mode == 0) throw HullFileError(row.line, "the mode 0", "a mode of the hull");
    const std::string name = fmt::format("mode {} at {}, heading {:.6g} deg", value.mode, place(), *heading_ / kDegree);
    value.modulus = require_number(row, 1, "the modulus of " + name);
    value.phase = require_number(row, 2, "the phase of " + name) * kDegree;
    if (same_headings_) values_->push_back(value);
  }

  const HullText& text_;
  WamitOutput out_;
  std::optional<double> omega_, heading_;
  bool same_headings_ = true;
  Section section_ = Section::none;
  std::vector<WamitOutput::WaveValue>* values_ = nullptr;
};

/// Scales of the dimensionless numbers: rho ULEN^k and so on.
class WamitScales {
 public:
  WamitScales(double density, double gravity, double length) : density_(density), gravity_(gravity), length_(length) {}
  double added_mass(int i, int j) const { return density_ * power(3 + turns(i) + turns(j)); }
  double stiffness(int i, int j) const { return density_ * gravity_ * power(2 + turns(i) + turns(j)); }
  double force(int mode) const { return density_ * gravity_ * power(2 + turns(mode)); }
  double drift(int mode) const { return density_ * gravity_ * power(1 + turns(mode)); }

 private:
  static int turns(int mode) { return mode > 2 ? 1 : 0; }
  double power(int exponent) const { return std::pow(length_, exponent); }

  double density_, gravity_, length_;
};

/// Hull data from the numbers of one body.
class WamitConversion {
 public:
  WamitConversion(const WamitOutput& out, const HydrodynamicsSource& source) : out_(out), source_(source) {
    const std::vector<std::string> names(out.bodies.size());
    index_ = find_body(source.body, names);
  }

  HydrodynamicData convert(HullStatements& statements) {
    HydrodynamicData data;
    data.source = source_.path;
    data.origin_V = source_.origin_V;
    settle_constants(data);
    const WamitScales scales(data.water_density, data.gravity, out_.length_scale);
    add_radiation(scales);
    add_forces(scales);
    add_drift(scales);
    builder_.build(data, source_.mirror_headings);
    if (!body().stiffness) throw HullFileError("no restoring coefficients C(3,3) to C(5,6)", "those of the hull");
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) data.hydrostatic_stiffness(i, j) = scales.stiffness(i, j) * (*body().stiffness)(i, j);
    }
    add_statements(statements);
    if (out_.bodies.size() > 1) {
      data.notes.push_back(
          fmt::format("Body {} of {} in {} is used; the forces that motions of the others cause on it "
                      "are left out.",
                      index_ + 1, out_.bodies.size(), file_name(source_.path)));
    }
    return data;
  }

 private:
  const WamitOutput::Body& body() const { return out_.bodies[index_]; }

  /// Mode of this body from 0 to 5; -1 for another body.
  int local(int mode) const {
    const int mine = mode - 1 - 6 * static_cast<int>(index_);
    return mine >= 0 && mine < 6 ? mine : -1;
  }

  void settle_constants(HydrodynamicData& data) {
    const HydrodynamicsSource defaults;
    data.gravity = settled_constant("gravity", source_.gravity, defaults.gravity, out_.gravity);
    settled_constant("length_scale", source_.length_scale, defaults.length_scale, out_.length_scale);
    if (out_.water_density) {
      data.water_density =
          settled_constant("water_density", source_.water_density, defaults.water_density, *out_.water_density);
    } else {
      data.water_density = source_.water_density;
      data.notes.push_back(
          fmt::format("{} does not state the density of the water: its values are made dimensional "
                      "with {:.6g} kg/m^3.",
                      file_name(source_.path), source_.water_density));
    }
  }

  void add_radiation(const WamitScales& scales) {
    for (const WamitOutput::Radiation& value : out_.radiation) {
      const int i = local(value.i), j = local(value.j);
      if (i < 0 || j < 0) continue;
      const double unit = scales.added_mass(i, j);
      builder_.add_added_mass(value.omega, i, j, unit * value.added_mass, value.line);
      if (value.damping) builder_.add_damping(value.omega, i, j, unit * value.omega * *value.damping, value.line);
    }
  }

  void add_forces(const WamitScales& scales) {
    for (const WamitOutput::WaveValue& value : out_.diffraction.empty() ? out_.haskind : out_.diffraction) {
      const int mode = local(value.mode);
      if (mode < 0) continue;
      builder_.add_force(value.omega, value.heading - body().turned, mode,
                         std::polar(1.0, value.phase) * (scales.force(mode) * value.modulus), value.line);
    }
  }

  /// Drift by momentum is that of all bodies together.
  void add_drift(const WamitScales& scales) {
    const bool single = out_.bodies.size() == 1;
    const auto& values = single && !out_.drift_momentum.empty() ? out_.drift_momentum
                         : !out_.drift_pressure.empty()         ? out_.drift_pressure
                                                                : out_.drift_control_surface;
    for (const WamitOutput::WaveValue& value : values) {
      const int mode = local(value.mode);
      if (mode < 0) continue;
      const double force =
          value.omega < source_.drift_from ? 0.0 : scales.drift(mode) * value.modulus * std::cos(value.phase);
      builder_.add_drift(value.omega, value.heading - body().turned, mode, force, value.line);
    }
  }

  void add_statements(HullStatements& statements) const {
    const WamitPoints points = find_wamit_points(body(), source_.file_origin);
    statements.water_depth = out_.water_depth;
    statements.displaced_volume = body().volume;
    statements.reference = points.origin;
    statements.wave_origin = points.wave_origin;
    if (body().centre_of_gravity) statements.centre_of_gravity = points.origin + *body().centre_of_gravity;
  }

  const WamitOutput& out_;
  const HydrodynamicsSource& source_;
  std::size_t index_ = 0;
  HullDataBuilder builder_;
};

}  // namespace

WamitOutput parse_wamit_output(const HullText& text) {
  return WamitOutputParser(text).parse();
}

WamitPoints find_wamit_points(const WamitOutput::Body& body, const Vec3& file_origin) {
  WamitPoints points;
  points.origin = file_origin + Vec3(0.0, 0.0, body.place.z());
  const double c = std::cos(body.turned), s = std::sin(body.turned);
  const Vec3 from_global(c * body.place.x() + s * body.place.y(), -s * body.place.x() + c * body.place.y(), 0.0);
  points.wave_origin = points.origin - from_global;
  return points;
}

std::optional<HydrodynamicData> read_wamit_output(const HydrodynamicsSource& source, Diagnostics& diagnostics) {
  try {
    const WamitOutput out = parse_wamit_output(HullText::read(source.path));
    HullStatements statements;
    HydrodynamicData data = WamitConversion(out, source).convert(statements);
    check_same_frequencies(data, source.path, source.path, diagnostics);
    complete_hull(data, statements, source, diagnostics);
    return data;
  } catch (const HullFileError& error) {
    add_error(error, source.path, diagnostics);
    return std::nullopt;
  }
}

}  // namespace overbend
