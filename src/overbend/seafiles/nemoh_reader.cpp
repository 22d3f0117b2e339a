#include "seafiles/nemoh_reader.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/body_number.h"
#include "seafiles/hull_data_builder.h"
#include "seafiles/hull_statements.h"
#include "seafiles/hull_text.h"
#include "seafiles/reference_point.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxNemohBodies = 50, kMaxNemohModes = 1000, kMaxNemohRows = 100'000;
constexpr double kSameNemohPoint = 1e-6;  // [m]

std::string nemoh_folder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error) ? path : fs::path(path).parent_path().string();
}

/// Degrees of freedom or forces of a body: each is a mode from 0 to 5, turning about one point.
struct NemohModes {
  std::vector<int> modes;
  std::optional<Vec3> centre;
};

struct NemohBody {
  std::string mesh;
  NemohModes motions, forces;
};

/// Contents of Nemoh.cal.
struct NemohCase {
  double density = 0.0, gravity = 0.0, depth = 0.0;  ///< Infinite for deep water.
  Vec3 wave_origin = Vec3::Zero();
  std::vector<NemohBody> bodies;
};

/// Reads Nemoh.cal: values, then a comment after '!'; lines of dashes are titles.
class CaseParser {
 public:
  explicit CaseParser(const HullText& text) : text_(text) {}

  NemohCase parse() {
    NemohCase result;
    result.density = positive("the density of the water");
    result.gravity = positive("the acceleration of gravity");
    result.depth = require_number(next(), 0, "the water depth");
    if (result.depth < 0.0) throw HullFileError(line(), "a depth below 0", "the water depth, 0 for deep water");
    if (result.depth == 0.0) result.depth = kInfinity;
    const std::vector<double> origin = require_numbers(next(), 0, 2, "the wave measurement point");
    result.wave_origin = Vec3(origin[0], origin[1], 0.0);
    check_point(result.wave_origin, line(), "the wave measurement point");
    const int bodies = require_integer(next(), 0, 1, kMaxNemohBodies, "the number of bodies");
    for (int k = 0; k < bodies; ++k) result.bodies.push_back(read_body());
    return result;
  }

 private:
  const TextRow& next() {
    while (place_ < text_.rows().size()) {
      const TextRow& row = text_.rows()[place_++];
      if (!row.cells[0].starts_with("---") && !row.cells[0].starts_with('!')) return row;
    }
    throw HullFileError(text_.last_line(), "the end of the file", "the bodies of the run");
  }
  int line() const { return text_.rows()[place_ - 1].line; }

  double positive(const char* name) {
    const TextRow& row = next();
    const double value = require_number(row, 0, name);
    if (!(value > 0.0)) throw HullFileError(row.line, format_number(value), std::string(name) + ", more than 0");
    return value;
  }

  NemohBody read_body() {
    NemohBody body;
    body.mesh = for_display(next().cells[0]);
    require_numbers(next(), 0, 2, "numbers of points and panels");
    body.motions = read_modes("degree of freedom");
    body.forces = read_modes("force");
    const int more = require_integer(next(), 0, 0, kMaxNemohModes, "the number of lines of additional information");
    for (int k = 0; k < more; ++k) next();
    return body;
  }

  NemohModes read_modes(const std::string& name) {
    NemohModes modes;
    const int count = require_integer(next(), 0, 1, kMaxNemohModes, "the number of entries, each a " + name);
    for (int k = 0; k < count; ++k) {
      const TextRow& row = next();
      const int type = require_integer(row, 0, 1, 2, "1 (translation) or 2 (rotation)");
      const std::vector<double> v = require_numbers(row, 1, 6, "the direction and point of a " + name);
      const int axis = unit_axis(v);
      if (axis < 0) throw HullFileError(row.line, "a " + name + " in another direction", "one along x, y or z");
      const int mode = axis + (type == 2 ? 3 : 0);
      if (std::find(modes.modes.begin(), modes.modes.end(), mode) != modes.modes.end()) {
        throw HullFileError(row.line, "a second " + name + " along this axis", "surge to yaw, each once");
      }
      modes.modes.push_back(mode);
      if (type == 2) take_centre(modes, Vec3(v[3], v[4], v[5]), row.line, name);
    }
    return modes;
  }

  static int unit_axis(const std::vector<double>& v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double rest = 0.0;
      for (std::size_t k = 0; k < 3; ++k) rest += k == axis ? 0.0 : std::abs(v[k]);
      if (v[axis] == 1.0 && rest == 0.0) return static_cast<int>(axis);
    }
    return -1;
  }

  static void take_centre(NemohModes& modes, const Vec3& point, int line, const std::string& name) {
    check_point(point, line, "the point of a " + name);
    if (!modes.centre) modes.centre = point;
    if ((*modes.centre - point).norm() > kSameNemohPoint) {
      throw HullFileError(line, "a " + name + " about " + point_text(point), "the same point as above");
    }
  }

  const HullText& text_;
  std::size_t place_ = 0;
};

/// One variable of a .tec file: "A   1   3", "abs(F   1   3)".
struct TecVariable {
  std::string kind;
  int body = 0, force = 0;
};

struct TecZone {
  std::string title;
  int line = 0;
  std::vector<const TextRow*> rows;
};

/// Tecplot file: VARIABLES, then zones with the number of their rows.
class TecFile {
 public:
  explicit TecFile(const std::string& file) : text_(HullText::read(file)) {
    for (const TextRow& row : text_.rows()) take(row);
    finish_zone("the end of the file");
    if (zones_.empty()) throw HullFileError("no zones", "the results of Nemoh");
    if (!frequencies_) throw HullFileError("no variable 'w (rad/s)'", "results by frequency in rad/s");
  }

  const std::vector<TecVariable>& variables() const { return variables_; }
  const std::vector<TecZone>& zones() const { return zones_; }

 private:
  void take(const TextRow& row) {
    const std::string text = joined(row);
    const std::string lower = lower_case(text);
    if (lower.starts_with("zone")) {
      begin_zone(row, lower);
    } else if (lower.starts_with("variables") || text.starts_with('"')) {
      take_variables(text);
    } else if (!zones_.empty() && wanted_ > 0) {
      take_row(row);
    }
  }

  void begin_zone(const TextRow& row, const std::string& text) {
    finish_zone("the next zone");
    const std::size_t place = text.rfind("i=");
    int count = 0;
    const TextTable cells =
        split_table(place == std::string::npos ? "" : std::string_view(text).substr(place + 2), ',');
    if (!cells.rows.empty()) {
      const auto value = cell_number(cells.rows[0].cells[0]);
      if (value && *value >= 1.0 && *value <= kMaxNemohRows && *value == std::floor(*value)) {
        count = static_cast<int>(*value);
      }
    }
    if (count == 0) {
      throw HullFileError(row.line, "'" + for_display(text) + "'", "a zone with its number of rows, I = ...");
    }
    wanted_ = count;
    zones_.push_back({text, row.line, {}});
  }

  void take_row(const TextRow& row) {
    const std::size_t columns = variables_.size() + 1;
    if (row.cells.size() != columns) {
      throw HullFileError(row.line, std::to_string(row.cells.size()) + " numbers",
                          std::to_string(columns) + ", one for each variable");
    }
    if (static_cast<int>(zones_.back().rows.size()) == wanted_) {
      throw HullFileError(row.line, "a row after the " + std::to_string(wanted_) + " of the zone",
                          "I = " + std::to_string(wanted_));
    }
    zones_.back().rows.push_back(&row);
  }

  void finish_zone(const std::string& end) const {
    if (zones_.empty() || static_cast<int>(zones_.back().rows.size()) == wanted_) return;
    throw HullFileError(zones_.back().line, std::to_string(zones_.back().rows.size()) + " rows before " + end,
                        "I = " + std::to_string(wanted_));
  }

  /// Names between quotes: "w (rad/s)", "A   1   1", "abs(F   1   1)".
  void take_variables(const std::string& text) {
    for (std::size_t from = text.find('"'); from != std::string::npos; from = text.find('"', from + 1)) {
      const std::size_t to = text.find('"', from + 1);
      if (to == std::string::npos) return;
      std::string name = text.substr(from + 1, to - from - 1);
      from = to;
      if (name.starts_with("w ")) {
        frequencies_ = name.find("rad/s") != std::string::npos;
        continue;
      }
      for (char& c : name) {
        if (c == '(' || c == ')') c = ' ';
      }
      variables_.push_back(parse_variable(name));
    }
  }

  static TecVariable parse_variable(const std::string& name) {
    TecVariable variable;
    const TextTable columns = split_table(name, ' ');
    if (columns.rows.empty()) return variable;
    const auto& cells = columns.rows[0].cells;
    variable.kind = std::string(cells[0]);
    const auto index = [&](std::size_t from_end) {
      const auto value = cells.size() > from_end ? cell_number(cells[cells.size() - 1 - from_end]) : std::nullopt;
      return value && *value >= 1.0 && *value <= kMaxNemohModes ? static_cast<int>(*value) : 0;
    };
    variable.body = index(1);
    variable.force = index(0);
    return variable;
  }

  HullText text_;
  std::vector<TecVariable> variables_;
  std::vector<TecZone> zones_;
  int wanted_ = 0;
  bool frequencies_ = false;
};

class NemohReader {
 public:
  NemohReader(const HydrodynamicsSource& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics), folder_(nemoh_folder(source.path)) {}

  HydrodynamicData read() {
    in_file(path("Nemoh.cal"), [&] { read_case(); });
    data_.source = source_.path;
    data_.origin_V = source_.origin_V;
    in_file(path("Results/RadiationCoefficients.tec"), [&] { read_radiation(); });
    in_file(path("Results/ExcitationForce.tec"), [&] { read_excitation(); });
    builder_.build(data_, source_.mirror_headings);
    statements_.water_depth = case_.depth;
    statements_.reference = source_.file_origin + reference_;
    statements_.wave_origin = source_.file_origin + case_.wave_origin;
    read_hydrostatics();
    check_same_frequencies(data_, path("Results/ExcitationForce.tec"), path("Results/RadiationCoefficients.tec"),
                           diagnostics_);
    complete_hull(data_, statements_, source_, diagnostics_);
    return std::move(data_);
  }

 private:
  std::string path(const std::string& name) const { return (fs::path(folder_) / name).string(); }

  template <class Work>
  static void in_file(const std::string& file, Work work) {
    try {
      work();
    } catch (const HullFileError& error) {
      throw error.in_file(file);
    }
  }

  const NemohBody& body() const { return case_.bodies[index_]; }

  void read_case() {
    case_ = CaseParser(HullText::read(path("Nemoh.cal"))).parse();
    std::vector<std::string> names;
    for (const NemohBody& hull : case_.bodies) names.push_back(hull.mesh);
    index_ = find_body(source_.body, names);
    const HydrodynamicsSource defaults;
    data_.water_density =
        settled_constant("water_density", source_.water_density, defaults.water_density, case_.density);
    data_.gravity = settled_constant("gravity", source_.gravity, defaults.gravity, case_.gravity);
    const auto &turning = body().motions.centre, &moments = body().forces.centre;
    if (turning && moments && (*turning - *moments).norm() > kSameNemohPoint) {
      throw HullFileError("rotations about " + point_text(*turning) + " and moments about " + point_text(*moments),
                          "the same point");
    }
    reference_ = turning ? *turning : moments.value_or(Vec3::Zero());
    if (case_.bodies.size() > 1) {
      data_.notes.push_back(
          fmt::format("Body {} of {} in {} is used; the forces that motions of the others cause on it "
                      "are left out.",
                      index_ + 1, case_.bodies.size(), file_name(path("Nemoh.cal"))));
    }
  }

  /// Mode from 0 to 5 of a force of a .tec file; -1 if it acts on another body.
  int force_mode(const TecVariable& variable) const {
    if (variable.body != static_cast<int>(index_) + 1) return -1;
    const std::vector<int>& modes = body().forces.modes;
    if (variable.force < 1 || variable.force > static_cast<int>(modes.size())) {
      throw HullFileError("a force " + std::to_string(variable.force), "forces as in Nemoh.cal");
    }
    return modes[static_cast<std::size_t>(variable.force - 1)];
  }

  /// Mode of the motion of a zone "Motion of body    1 in DoF   3"; -1 for another body.
  int zone_mode(const TecZone& zone) const {
    const std::size_t of_body = zone.title.find("body"), of_freedom = zone.title.find("dof");
    const auto number = [&](std::size_t place, std::size_t length) {
      const TextTable cells =
          split_table(place == std::string::npos ? "" : std::string_view(zone.title).substr(place + length), ' ');
      std::string_view cell = cells.rows.empty() ? "" : cells.rows[0].cells[0];
      cell = cell.substr(0, number_length(cell));
      return cell_number(cell).value_or(0.0);
    };
    const double hull = number(of_body, 4), freedom = number(of_freedom, 3);
    const std::vector<int>& modes = body().motions.modes;
    if (!(hull >= 1.0) || hull > static_cast<double>(case_.bodies.size())) {
      throw HullFileError(zone.line, "'" + for_display(zone.title) + "'",
                          "a zone of the motion of a body of Nemoh.cal");
    }
    if (static_cast<std::size_t>(hull) != index_ + 1) return -1;
    if (!(freedom >= 1.0) || freedom > static_cast<double>(modes.size())) {
      throw HullFileError(zone.line, "'" + for_display(zone.title) + "'", "a degree of freedom of Nemoh.cal");
    }
    return modes[static_cast<std::size_t>(freedom) - 1];
  }

  static double frequency(const TextRow& row) {
    const double omega = require_number(row, 0, "a frequency");
    if (omega > 0.0) return omega;
    throw HullFileError(row.line, "the frequency " + format_number(omega), "more than 0");
  }

  void read_radiation() {
    const TecFile file(path("Results/RadiationCoefficients.tec"));
    for (const TecZone& zone : file.zones()) {
      const int j = zone_mode(zone);
      if (j < 0) continue;
      for (const TextRow* row : zone.rows) {
        const double omega = frequency(*row);
        for (std::size_t k = 0; k < file.variables().size(); ++k) {
          const TecVariable& variable = file.variables()[k];
          const int i = force_mode(variable);
          if (i < 0) continue;
          const double value = require_number(*row, k + 1, "added mass or damping");
          variable.kind == "A" ? builder_.add_added_mass(omega, i, j, value, row->line)
                               : builder_.add_damping(omega, i, j, value, row->line);
        }
      }
    }
  }

  /// Zones "Diffraction force - beta =   45.000 deg".
  static double zone_heading(const TecZone& zone) {
    const std::size_t place = zone.title.find("beta");
    const TextTable cells =
        split_table(place == std::string::npos ? "" : std::string_view(zone.title).substr(place), ' ');
    for (const TextRow& row : cells.rows) {
      for (const std::string_view cell : row.cells) {
        if (const auto value = cell_number(cell); value && std::abs(*value) <= 360.0) return *value * kDegree;
      }
    }
    throw HullFileError(zone.line, "'" + for_display(zone.title) + "'", "beta = ... deg, from -360 to 360 deg");
  }

  void read_excitation() {
    const TecFile file(path("Results/ExcitationForce.tec"));
    const std::vector<TecVariable>& variables = file.variables();
    for (const TecZone& zone : file.zones()) {
      const double heading = zone_heading(zone);
      for (const TextRow* row : zone.rows) {
        const double omega = frequency(*row);
        for (std::size_t k = 0; k + 1 < variables.size(); k += 2) {
          if (variables[k].kind != "abs" || variables[k + 1].kind != "angle") {
            throw HullFileError("the variables " + variables[k].kind + " and " + variables[k + 1].kind,
                                "abs and angle of each force");
          }
          const int mode = force_mode(variables[k]);
          if (mode < 0) continue;
          const double modulus = require_number(*row, k + 1, "the modulus of a force");
          const double lag = require_number(*row, k + 2, "the angle of a force");
          builder_.add_force(omega, heading, mode, std::polar(1.0, -lag) * modulus, row->line);
        }
      }
    }
  }

  /// Name of a file of hydrostatics: numbered from 0 if there are several bodies.
  std::string hydrostatic_file(const std::string& name) const {
    const std::string number = case_.bodies.size() > 1 ? "_" + std::to_string(index_) : "";
    return path("Mesh/" + name + number + ".dat");
  }

  /// The stiffness is about the centre of gravity in Hydrostatics.dat.
  void read_hydrostatics() {
    in_file(hydrostatic_file("Hydrostatics"), [&] { read_centre(); });
    in_file(hydrostatic_file("KH"), [&] { read_stiffness(); });
    const Vec3& centre = *statements_.centre_of_gravity;
    move_matrix(data_.hydrostatic_stiffness, centre, *statements_.reference);
  }

  /// Rows " XF =   0.000 - XG =   0.000" and " Displacement =  1.26E+04".
  void read_centre() {
    const HullText text = HullText::read(hydrostatic_file("Hydrostatics"));
    Vec3 centre = Vec3::Zero();
    std::array<bool, 3> found{};
    for (const TextRow& row : text.rows()) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        constexpr const char* kNames[] = {"XG", "YG", "ZG"};
        if (!contains(row, kNames[axis])) continue;
        centre(static_cast<Eigen::Index>(axis)) =
            require_number(row, row.cells.size() - 1, "the centre of gravity " + std::string(kNames[axis]));
        found[axis] = true;
      }
      if (contains(row, "Displacement")) {
        statements_.displaced_volume = require_number(row, row.cells.size() - 1, "the displacement");
      }
    }
    if (!found[0] || !found[1] || !found[2]) throw HullFileError("no centre of gravity", "XG, YG and ZG");
    check_point(centre, 0, "XG, YG and ZG");
    statements_.centre_of_gravity = source_.file_origin + centre;
    statements_.centre_in_file = "XG, YG, ZG = " + point_text(centre);
  }

  void read_stiffness() {
    const HullText text = HullText::read(hydrostatic_file("KH"));
    if (text.rows().size() < 6) {
      throw HullFileError(text.last_line(), std::to_string(text.rows().size()) + " rows", "six rows of six numbers");
    }
    for (int i = 0; i < 6; ++i) {
      const std::vector<double> values =
          require_numbers(text.rows()[static_cast<std::size_t>(i)], 0, 6, "a coefficient of the stiffness");
      for (int j = 0; j < 6; ++j) data_.hydrostatic_stiffness(i, j) = values[static_cast<std::size_t>(j)];
    }
  }

  const HydrodynamicsSource& source_;
  Diagnostics& diagnostics_;
  std::string folder_;
  NemohCase case_;
  std::size_t index_ = 0;
  Vec3 reference_ = Vec3::Zero();
  HydrodynamicData data_;
  HullStatements statements_;
  HullDataBuilder builder_;
};

}  // namespace

std::optional<HydrodynamicData> read_nemoh(const HydrodynamicsSource& source, Diagnostics& diagnostics) {
  try {
    return NemohReader(source, diagnostics).read();
  } catch (const HullFileError& error) {
    add_error(error, source.path, diagnostics);
    return std::nullopt;
  }
}

std::vector<std::string> nemoh_files(const std::string& path) {
  const fs::path folder = nemoh_folder(path);
  std::vector<std::string> files;
  for (const char* name : {"Nemoh.cal", "Results/RadiationCoefficients.tec", "Results/ExcitationForce.tec",
                           "Mesh/KH.dat", "Mesh/Hydrostatics.dat"}) {
    files.push_back((folder / name).string());
  }
  return files;
}

}  // namespace overbend
