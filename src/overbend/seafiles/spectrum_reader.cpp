#include "seafiles/spectrum_reader.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "model/site/sea_statistics.h"
#include "seafiles/sentinels.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr double kMaxWaveHeight = 40.0;  ///< Upper limit of the key environment.waves.hs [m].

/// A pair of columns and the factors that convert them to rad/s and m2 s.
struct Columns {
  const char *frequency, *density;
  double to_omega, to_density;
};
constexpr Columns kKnown[] = {{"omega_rad_s", "density_m2s", 1.0, 1.0},
                              {"frequency_hz", "density_m2_hz", kTurn, 1.0 / kTurn}};

class SpectrumReader {
 public:
  SpectrumReader(const std::string& path, Diagnostics& diagnostics) : path_(path), diagnostics_(diagnostics) {}

  std::vector<SpectrumPoint> read(const std::string& text) {
    std::istringstream lines(text);
    for (std::string raw; std::getline(lines, raw);) {
      ++line_;
      const std::string_view line = trim(raw);
      if (line.empty() || line.front() == '#') continue;
      if (columns_ == nullptr) {
        if (!take_header(line)) return {};
      } else {
        take_row(line);
      }
    }
    if (good_) check_whole();
    return good_ ? points_ : std::vector<SpectrumPoint>{};
  }

 private:
  void complain(std::string key, std::string found, std::string expected) {
    good_ = false;
    diagnostics_.add(
        {Severity::error, path_, line_, 0, std::move(key), std::move(found), std::move(expected), std::string()});
  }

  static std::vector<std::string_view> split_cells(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t start = 0; start <= line.size();) {
      const std::size_t end = std::min(line.find(',', start), line.size());
      cells.push_back(trim(line.substr(start, end - start)));
      start = end + 1;
    }
    return cells;
  }

  bool take_header(std::string_view line) {
    const auto cells = split_cells(line);
    for (const Columns& known : kKnown) {
      if (cells.size() == 2 && cells[0] == known.frequency && cells[1] == known.density) columns_ = &known;
    }
    if (columns_ == nullptr) {
      complain("", "'" + for_display(line) + "'",
               "the header 'omega_rad_s,density_m2s' or 'frequency_hz,density_m2_hz'");
    }
    return columns_ != nullptr;
  }

  std::optional<double> number(std::string_view cell, const char* column) {
    const auto value = parse_number(cell);
    if (!value) {
      complain(column, "'" + for_display(cell) + "'", "a number");
    } else if (*value < 0.0) {
      complain(column, format_number(*value) + (is_sentinel(*value) ? kMissingValueText : ""), "0 or more");
      return std::nullopt;
    }
    return value;
  }

  void take_row(std::string_view line) {
    const auto cells = split_cells(line);
    if (cells.size() != 2) {
      complain("", std::to_string(cells.size()) + " columns", "2, as in the header");
      return;
    }
    const auto frequency = number(cells[0], columns_->frequency);
    const auto density = number(cells[1], columns_->density);
    if (!frequency || !density) return;
    if (*frequency == 0.0 && *density > 0.0) {
      complain(columns_->density, format_number(*density), "0 at frequency 0, where there is no wave");
    }
    if (frequency <= last_frequency_) {
      complain(columns_->frequency, format_number(*frequency),
               "more than the previous frequency, " + format_number(*last_frequency_));
    }
    last_frequency_ = frequency;
    lines_.push_back(line_);
    points_.push_back({*frequency * columns_->to_omega, *density * columns_->to_density});
  }

  /// Checks the spectrum as a whole.
  void check_whole() {
    line_ = 0;
    if (columns_ == nullptr) {
      complain("", "an empty file", "a wave spectrum");
    } else if (points_.size() < 2) {
      complain("", std::to_string(points_.size()) + " rows", "at least 2 rows");
    } else {
      const double height = sea_statistics(points_).hs;
      check_sentinels();
      check_peak();
      check_sea();
      if (!(height > 0.0)) complain(columns_->density, "0 in every row", "a spectrum with energy");
      if (height > kMaxWaveHeight) {
        complain(columns_->density, "a sea with a significant wave height of " + format_quantity(height, "m", "m", 3),
                 "at most " + format_quantity(kMaxWaveHeight, "m", "m") + " with the units named in the header");
      }
    }
  }

  double written(const SpectrumPoint& point) const { return point.density / columns_->to_density; }

  /// Returns the larger of the neighbouring densities that differ from that of row `i`.
  double neighbouring_density(std::size_t i) const {
    const auto differs = [&](const SpectrumPoint& point) { return point.density != points_[i].density; };
    const auto place = points_.begin() + static_cast<std::ptrdiff_t>(i);
    const auto after = std::find_if(place, points_.end(), differs);
    const auto before = std::find_if(std::make_reverse_iterator(place), points_.rend(), differs);
    return std::max(after != points_.end() ? after->density : 0.0, before != points_.rend() ? before->density : 0.0);
  }

  /// Reports sentinels, which stand out from their neighbours.
  void check_sentinels() {
    constexpr double kApart = 3.0;
    for (std::size_t i = 0; i < points_.size() && points_.size() > 3; ++i) {
      const double density = written(points_[i]);
      if (!is_sentinel(density) || points_[i].density < kApart * neighbouring_density(i)) continue;
      line_ = lines_[i];
      complain(columns_->density, format_number(density) + kMissingValueText, "a density, or no row");
      line_ = 0;
      return;
    }
  }

  void warn(int line, std::string remark) {
    diagnostics_.add({Severity::warning, path_, line, 0, columns_->density, std::move(remark), "", ""});
  }

  /// Warns about a single row far above all others.
  void check_peak() {
    constexpr double kTower = 5.0;
    const auto less = [](const SpectrumPoint& p, const SpectrumPoint& q) { return p.density < q.density; };
    const auto peak = std::max_element(points_.begin(), points_.end(), less);
    double next = 0.0;
    for (auto p = points_.begin(); p != points_.end(); ++p) next = p == peak ? next : std::max(next, p->density);
    if (!good_ || points_.size() < 4 || peak->density < kTower * next) return;
    warn(lines_[static_cast<std::size_t>(peak - points_.begin())],
         format_number(written(*peak)) + " is " + format_number(peak->density / next, 2) +
             " times the second largest density: the sea is nearly a regular wave");
  }

  /// Warns about implausible seas, which indicate wrong units or columns.
  void check_sea() {
    constexpr double kMinPeriod = 1.5, kMaxPeriod = 30.0,
                     kBreaking = 0.1;  // [s], [s], height over length of mean waves
    const SeaStatistics sea = sea_statistics(points_);
    if (!good_ || !(sea.tz > 0.0)) return;
    const double steepness = kTurn * sea.hs / (9.81 * sea.tz * sea.tz);
    if (sea.tp < kMinPeriod || sea.tp > kMaxPeriod) {
      warn(0, "the peak of the spectrum is at a period of " + format_number(sea.tp, 3) +
                  " s; peak periods of seas are between " + format_number(kMinPeriod) + " and " +
                  format_number(kMaxPeriod) + " s. Are the frequencies in " +
                  (columns_->to_omega == 1.0 ? "rad/s" : "Hz") + "?");
    } else if (steepness > kBreaking) {
      warn(0, "the sea has " + sea_statistics_label(points_) + ", a steepness of " + format_number(steepness, 2) +
                  "; seas break at about " + format_number(kBreaking) + ". Are frequencies and densities correct?");
    }
  }

  std::string path_;
  Diagnostics& diagnostics_;
  int line_ = 0;
  std::vector<int> lines_;  ///< Line number of each point.
  bool good_ = true;
  const Columns* columns_ = nullptr;
  std::optional<double> last_frequency_;
  std::vector<SpectrumPoint> points_;
};

}  // namespace

std::vector<SpectrumPoint> read_spectrum_text(const std::string& text, const std::string& path,
                                              Diagnostics& diagnostics) {
  return SpectrumReader(path, diagnostics).read(text);
}

}  // namespace overbend
