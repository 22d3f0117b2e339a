// Reader of AQWA's hydrodynamic database in text.
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/aqwa_data.h"

namespace overbend {
namespace {

constexpr int kMaxDirections = 1000;

class DatabaseParser {
 public:
  explicit DatabaseParser(const HullText& text) : text_(text) {}

  AqwaData parse() {
    read_head();
    for (; place_ < text_.rows().size(); ++place_) {
      const std::string_view name = row().cells[0];
      if (name == "END") return std::move(data_);
      if (name.starts_with('*')) continue;
      if (begins_with_number(row())) {
        read_row();
      } else {
        section_ = name;
      }
    }
    throw HullFileError(text_.last_line(), "the end of the file in the section " + for_display(section_), "END");
  }

 private:
  const TextRow& row() const {
    if (place_ >= text_.rows().size()) throw HullFileError(text_.last_line(), "the end of the file", "more rows");
    return text_.rows()[place_];
  }

  /// Numbers of structures, directions and frequencies; the directions; then the frequencies, in several rows.
  void read_head() {
    while (row().cells[0].starts_with('*')) ++place_;
    structures_ = require_integer(row(), 0, 1, AqwaData::kMaxStructures, "the number of structures");
    const int directions = require_integer(row(), 1, 1, kMaxDirections, "the number of directions");
    const int frequencies = require_integer(row(), 2, 1, AqwaData::kMaxFrequencies, "the number of frequencies");
    const int line = row().line;
    std::size_t cell = 3;
    const auto read_list = [&](int count, const char* name) {
      std::vector<double> values;
      while (static_cast<int>(values.size()) < count) {
        if (cell >= row().cells.size()) {
          ++place_;
          cell = 0;
        }
        values.push_back(require_number(row(), cell++, name));
      }
      return values;
    };
    headings_ = read_list(directions, "a direction");
    omegas_ = read_list(frequencies, "a frequency in rad/s");
    if (cell != row().cells.size()) {
      throw HullFileError(row().line, "more numbers than " + std::to_string(frequencies) + " frequencies",
                          "as many as line " + std::to_string(line) + " says");
    }
    for (const double omega : omegas_) {
      if (!(omega > 0.0)) throw HullFileError(row().line, "the frequency " + format_number(omega), "more than 0");
    }
    ++place_;
  }

  AqwaData::Structure& structure(const TextRow& indices) {
    return data_.structures[require_integer(indices, 0, 1, structures_, "the number of a structure")];
  }

  void read_row() {
    if (section_ == "GENERAL") {
      data_.water_depth = require_number(row(), 1, "the water depth");
      data_.water_density = require_number(row(), 2, "the density of the water");
      data_.gravity = require_number(row(), 3, "the acceleration of gravity");
    } else if (section_ == "COG") {
      structure(row()).centre_of_gravity = require_point(row(), 1, "the centre of gravity");
    } else if (section_ == "DISPLACEMENT") {
      structure(row()).volume = require_number(row(), 1, "the displaced volume");
    } else if (section_ == "MASS") {
      AqwaData::Structure& hull = structure(row());
      hull.mass = read_matrix(1)(2, 2);
    } else if (section_ == "HYDSTIFFNESS") {
      AqwaData::Structure& hull = structure(row());
      hull.stiffness = read_matrix(1);
    } else if (section_ == "ADDEDMASS" || section_ == "DAMPING") {
      read_radiation();
    } else if (section_ == "FORCERAO") {
      read_forces();
    }
  }

  double frequency(const TextRow& indices, std::size_t cell) const {
    return omegas_[static_cast<std::size_t>(
        require_integer(indices, cell, 1, static_cast<int>(omegas_.size()), "the number of a frequency") - 1)];
  }

  /// Reads six rows of six numbers; the first row has `before` cells before them.
  Mat6 read_matrix(std::size_t before) {
    Mat6 matrix;
    for (int i = 0; i < 6; ++i) {
      if (i > 0) ++place_;
      const std::size_t first = i == 0 ? before : 0;
      if (row().cells.size() != first + 6) {
        throw HullFileError(row().line,
                            std::to_string(row().cells.size()) + " numbers in row " + std::to_string(i + 1) +
                                " of a matrix of " + for_display(section_),
                            std::to_string(first + 6) + " numbers");
      }
      const std::vector<double> values = require_numbers(row(), first, 6, "a number of " + for_display(section_));
      for (int j = 0; j < 6; ++j) matrix(i, j) = values[static_cast<std::size_t>(j)];
    }
    return matrix;
  }

  /// Rows of structure, structure, frequency and a matrix. Matrices that couple two structures are left out.
  void read_radiation() {
    const TextRow& first = row();
    const double omega = frequency(first, 2);
    const int second = require_integer(first, 1, 1, structures_, "the number of a structure");
    const bool coupling = require_integer(first, 0, 1, structures_, "the number of a structure") != second;
    const Mat6 matrix = read_matrix(3);
    if (coupling) return;
    AqwaData::Matrices& matrices = structure(first).radiation[omega];
    const bool mass = section_ == "ADDEDMASS";
    bool& has = mass ? matrices.has_mass : matrices.has_damping;
    if (has) throw HullFileError(first.line, "a second matrix of " + for_display(section_), "one for each frequency");
    (mass ? matrices.added_mass : matrices.damping) = matrix;
    has = true;
    matrices.line = first.line;
  }

  /// Rows of structure, direction, frequency and six amplitudes; below them six phases.
  void read_forces() {
    const TextRow& first = row();
    AqwaData::WaveValues values;
    values.line = first.line;
    AqwaData::Structure& hull = structure(first);
    const int direction = require_integer(first, 1, 1, static_cast<int>(headings_.size()), "the number of a direction");
    values.heading = headings_[static_cast<std::size_t>(direction - 1)] * kDegree;
    values.omega = frequency(first, 2);
    if (first.cells.size() != 9) {
      throw HullFileError(first.line, std::to_string(first.cells.size()) + " numbers",
                          "9: three indices, 6 amplitudes");
    }
    const std::vector<double> amplitudes = require_numbers(first, 3, 6, "the amplitude of a force");
    ++place_;
    if (row().cells.size() != 6) {
      throw HullFileError(row().line, std::to_string(row().cells.size()) + " numbers", "six phases");
    }
    const std::vector<double> phases = require_numbers(row(), 0, 6, "the phase of a force");
    for (std::size_t k = 0; k < 6; ++k) {
      values.amplitude[k] = amplitudes[k];
      values.phase[k] = phases[k] * kDegree;
    }
    hull.forces.push_back(values);
  }

  const HullText& text_;
  std::size_t place_ = 0;
  int structures_ = 0;
  std::vector<double> headings_, omegas_;
  std::string section_;
  AqwaData data_;
};

}  // namespace

AqwaData parse_aqwa_database(const HullText& text) {
  return DatabaseParser(text).parse();
}

}  // namespace overbend
