// Reader of AQWA's listings: sections under titles of spaced capitals.
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/aqwa_data.h"

namespace overbend {
namespace {

/// Returns the text in capitals without blanks: titles are spaced differently.
std::string squeezed(const TextRow& row) {
  std::string text;
  for (const std::string_view cell : row.cells) text += cell;
  return text;
}

/// Returns the row of a matrix by its first cell: X, Y, Z, RX, RY, RZ; -1 for another cell.
int matrix_row(std::string_view cell) {
  constexpr const char* kNames[] = {"X", "Y", "Z", "RX", "RY", "RZ"};
  for (int k = 0; k < 6; ++k) {
    if (cell == kNames[k]) return k;
  }
  return -1;
}

class ListingParser {
 public:
  explicit ListingParser(const HullText& text) : text_(text) {}

  AqwaData parse() {
    for (const TextRow& row : text_.rows()) take(row);
    finish_table(text_.last_line());
    if (data_.structures.empty()) {
      throw HullFileError("no section HYDRODYNAMIC PARAMETERS FOR STRUCTURE 1", "a listing of AQWA-LINE");
    }
    return std::move(data_);
  }

 private:
  enum class Section { none, frequencies, stiffness, added_mass, damping, mass_table, damping_table, forces, motions };

  void take(const TextRow& row) {
    if (row.cells.size() == 1 && row.cells[0] == "1") return;  // begins a page
    const std::string text = squeezed(row);
    if (take_title(row, text) || take_statement(row, text)) return;
    switch (section_) {
      case Section::none:
        return;
      case Section::frequencies:
        return take_frequency(row);
      case Section::stiffness:
        return take_stiffness(row, text);
      case Section::added_mass:
      case Section::damping:
        return take_matrix_row(row);
      case Section::mass_table:
      case Section::damping_table:
        return check_table_row(row);
      case Section::forces:
      case Section::motions:
        return take_wave_row(row);
    }
  }

  /// Titles of sections; returns true if the row is one.
  bool take_title(const TextRow& row, const std::string& text) {
    struct Title {
      const char* text;
      Section section;
    };
    constexpr Title kTitles[] = {
        {"WAVEFREQUENCIES/PERIODSANDDIRECTIONS", Section::frequencies},
        {"STIFFNESSMATRIX", Section::stiffness},
        {"ADDEDMASS-VARIATION", Section::mass_table},
        {"DAMPING-VARIATION", Section::damping_table},
        {"FROUDEKRYLOV+DIFFRACTIONFORCES-VARIATION", Section::forces},
        {"R.A.O.S-VARIATION", Section::motions},
    };
    if (text.starts_with("****")) {
      finish_table(row.line);
      section_ = Section::none;
      is_left_out_ = false;
      if (text.find("FORSTRUCTURE") != std::string::npos) select_structure(row);
    }
    if (is_left_out_) return true;
    if (text == "ADDEDMASS" || text == "DAMPING") {
      finish_table(row.line);
      section_ = text == "DAMPING" ? Section::damping : Section::added_mass;
      next_row_ = 0;
      return true;
    }
    for (const Title& title : kTitles) {
      if (text.find(title.text) == std::string::npos) continue;
      finish_table(row.line);
      section_ = title.section;
      heading_ = std::nullopt;
      return true;
    }
    if (text.find("-VARIATIONWITH") != std::string::npos) {  // another table: drift, splitting forces
      finish_table(row.line);
      section_ = Section::none;
      return true;
    }
    return text.starts_with("****") || text.starts_with("----");
  }

  void select_structure(const TextRow& row) {
    const std::vector<double> numbers = numbers_in(row);
    // Coefficients between two structures are left out.
    is_left_out_ = numbers.size() == 2 && numbers[0] != numbers[1];
    if (is_left_out_) return;
    if (numbers.empty() || !(numbers[0] >= 1.0) || numbers[0] > AqwaData::kMaxStructures ||
        numbers[0] != std::floor(numbers[0])) {
      throw HullFileError(row.line, "'" + for_display(joined(row)) + "'", "the number of the structure");
    }
    structure_ = &data_.structures[static_cast<int>(numbers[0])];
    omega_ = std::nullopt;
  }

  /// Lines that give one quantity; returns true if the row is one.
  bool take_statement(const TextRow& row, const std::string& text) {
    const auto last = [&](const char* name) { return require_number(row, row.cells.size() - 1, name); };
    if (const std::size_t place = text.find("UnitSystem:"); place != std::string::npos) {
      check_units(row, text.substr(place));
    } else if (text.starts_with("WATERDEPTH")) {
      data_.water_depth = last("the water depth");
    } else if (text.starts_with("DENSITYOFWATER")) {
      data_.water_density = last("the density of the water");
    } else if (text.starts_with("ACCELERATIONDUETOGRAVITY")) {
      data_.gravity = last("the acceleration of gravity");
    } else if (text.starts_with("WAVEPERIOD=")) {
      take_wave_period(row, last("the wave frequency"));
    } else {
      return structure_ != nullptr && take_structure_statement(row, text);
    }
    return true;
  }

  bool take_structure_statement(const TextRow& row, const std::string& text) {
    const auto last = [&](const char* name) { return require_number(row, row.cells.size() - 1, name); };
    if (text.starts_with("PMAS")) {
      structure_->mass = last("the mass of the structure");
    } else if (text.starts_with("CENTREOFGRAVITY") && row.cells.size() >= 6) {
      structure_->centre_of_gravity = require_point(row, row.cells.size() - 3, "the centre of gravity");
    } else if (text.starts_with("C.O.G")) {
      take_centre(row);
    } else if (text.starts_with("MESHBASEDDISPLACEMENT")) {
      structure_->volume = last("the displacement");
    } else {
      return false;
    }
    return true;
  }

  static void check_units(const TextRow& row, const std::string& text) {
    if (text.find("kg,m[N]") != std::string::npos) return;
    throw HullFileError(row.line, "'" + for_display(joined(row)) + "'", "Metric: kg, m [N]");
  }

  void take_wave_period(const TextRow& row, double omega) {
    if (!(omega > 0.0)) {
      throw HullFileError(row.line, "the frequency " + format_number(omega) + " rad/s", "more than 0");
    }
    omega_ = settled_frequency(omega);
    section_ = Section::none;
  }

  /// "C.O.G GX= 0.000 GY= 0.000 GZ= 1.500".
  void take_centre(const TextRow& row) {
    const std::vector<double> p = numbers_in(row);
    if (p.size() != 3) throw HullFileError(row.line, "'" + for_display(joined(row)) + "'", "GX, GY and GZ");
    structure_->centre_of_gravity = Vec3(p[0], p[1], p[2]);
    check_point(*structure_->centre_of_gravity, row.line, "the centre of gravity");
  }

  /// Rows "1 1 0.251327 0.040000 25.0" and "2 0.314159 0.050000 20.0".
  void take_frequency(const TextRow& row) {
    const std::size_t columns = row.cells.size();
    if (!begins_with_number(row) || columns < 4 || columns > 5) return;
    const std::vector<double> values = require_numbers(row, columns - 3, 3, "frequency in rad/s and Hz, and period");
    if (std::abs(values[0] - kTurn * values[1]) > 0.01 * values[0]) return;  // directions
    if (!(values[0] > 0.0)) throw HullFileError(row.line, "the frequency " + format_number(values[0]), "more than 0");
    if (frequencies_.size() >= AqwaData::kMaxFrequencies) {
      throw HullFileError(row.line, "more frequencies", "at most 10,000");
    }
    frequencies_.push_back(values[2] > 0.0 ? kTurn / values[2] : values[0]);
  }

  /// Returns the frequency of the list that rounds to a value of a table with three decimals.
  double settled_frequency(double omega) const {
    double best = omega, difference = 6e-4;  // half of the last digit
    for (const double known : frequencies_) {
      if (std::abs(known - omega) >= difference) continue;
      best = known;
      difference = std::abs(known - omega);
    }
    return best;
  }

  /// Rows "HEAVE( Z) = K33 K34 K35", "ROLL(RX) = ..." and "PITCH(RY) = ...".
  void take_stiffness(const TextRow& row, const std::string& text) {
    const int i = text.starts_with("HEAVE(") ? 2 : text.starts_with("ROLL(") ? 3 : text.starts_with("PITCH(") ? 4 : -1;
    if (i < 0 || structure_ == nullptr) return;
    if (row.cells.size() < 4) throw HullFileError(row.line, "'" + for_display(joined(row)) + "'", "three coefficients");
    const std::vector<double> values =
        require_numbers(row, row.cells.size() - 3, 3, "a coefficient of the hydrostatic stiffness");
    if (!structure_->stiffness) structure_->stiffness = Mat6::Zero();
    for (int k = 0; k < 3; ++k) (*structure_->stiffness)(i, 2 + k) = values[static_cast<std::size_t>(k)];
  }

  void take_matrix_row(const TextRow& row) {
    const int i = matrix_row(row.cells[0]);
    if (i < 0 || (i == 0 && row.cells.size() == 6 && matrix_row(row.cells[1]) == 1)) return;  // names of the columns
    const std::string name = section_ == Section::damping ? "damping" : "added mass";
    if (structure_ == nullptr || !omega_) {
      throw HullFileError(row.line, "a matrix of " + name + " before its wave period", "a line WAVE PERIOD = ...");
    }
    if (i != next_row_) {
      throw HullFileError(row.line, "the row " + std::string(row.cells[0]) + " of " + name,
                          "the rows X to RZ in order");
    }
    if (row.cells.size() != 7) {
      throw HullFileError(row.line, std::to_string(row.cells.size() - 1) + " values in a row of " + name, "6 values");
    }
    const std::vector<double> values = require_numbers(row, 1, 6, "a coefficient of " + name);
    AqwaData::Matrices& matrices = structure_->radiation[*omega_];
    if (matrices.line == 0) matrices.line = row.line;
    Mat6& matrix = section_ == Section::damping ? matrices.damping : matrices.added_mass;
    for (int j = 0; j < 6; ++j) matrix(i, j) = values[static_cast<std::size_t>(j)];
    if (++next_row_ < 6) return;
    (section_ == Section::damping ? matrices.has_damping : matrices.has_mass) = true;
    section_ = Section::none;
  }

  /// An incomplete matrix at the end of its section.
  void finish_table(int line) {
    const bool matrix = section_ == Section::added_mass || section_ == Section::damping;
    if (!matrix || next_row_ == 0 || next_row_ == 6) return;
    throw HullFileError(line, std::to_string(next_row_) + " rows of a matrix", "6 rows, X to RZ");
  }

  /// The tables of variation are not used, but a row that ends early shows a damaged file.
  void check_table_row(const TextRow& row) const {
    if (!begins_with_number(row)) return;
    constexpr std::size_t kColumns = 12;
    const std::string table = section_ == Section::mass_table ? "added mass" : "damping";
    const std::size_t found = row.cells.size() < 2 ? 0 : row.cells.size() - 2;
    if (found != kColumns) {
      throw HullFileError(row.line,
                          std::to_string(found) + " values in a row of the " + table + " table" +
                              (row.line == text_.last_line() ? ", which ends early; the file ends there" : ""),
                          "12 values after period and frequency");
    }
    require_numbers(row, 0, kColumns + 2, "a value of the " + table + " table");
  }

  /// Rows of period, frequency, direction (where it changes), and six pairs of amplitude and phase.
  void take_wave_row(const TextRow& row) {
    if (!begins_with_number(row)) return;
    constexpr std::size_t kValues = 12;
    const std::size_t columns = row.cells.size();
    const std::string name = section_ == Section::forces ? "wave forces" : "motions";
    if (columns != kValues + 2 && columns != kValues + 3) {
      throw HullFileError(row.line, std::to_string(columns) + " values in a row of the " + name,
                          "period, frequency, direction where it changes, and 12 values");
    }
    if (structure_ == nullptr) throw HullFileError(row.line, name + " without a structure", "a section of a structure");
    if (columns == kValues + 3) heading_ = require_number(row, 2, "a direction") * kDegree;
    if (!heading_) throw HullFileError(row.line, "a row without direction", "the direction in the first row");
    AqwaData::WaveValues values;
    values.line = row.line;
    values.heading = *heading_;
    values.omega = settled_frequency(require_number(row, 1, "a frequency"));
    if (!(values.omega > 0.0)) throw HullFileError(row.line, "a frequency of 0", "more than 0");
    const std::vector<double> pairs = require_numbers(row, columns - kValues, kValues, "an amplitude or phase");
    for (std::size_t k = 0; k < 6; ++k) {
      values.amplitude[k] = pairs[2 * k];
      values.phase[k] = pairs[2 * k + 1] * kDegree;
    }
    (section_ == Section::forces ? structure_->forces : structure_->motions).push_back(values);
  }

  const HullText& text_;
  AqwaData data_;
  AqwaData::Structure* structure_ = nullptr;
  std::vector<double> frequencies_;
  std::optional<double> omega_, heading_;
  Section section_ = Section::none;
  int next_row_ = 0;
  bool is_left_out_ = false;  ///< The section couples two structures.
};

}  // namespace

AqwaData parse_aqwa_listing(const HullText& text) {
  return ListingParser(text).parse();
}

}  // namespace overbend
