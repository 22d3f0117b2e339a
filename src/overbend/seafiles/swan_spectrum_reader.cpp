#include "seafiles/swan_spectrum_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr double kNegligible =
    1e-3;  ///< Fraction of the maximum density below which an exception value is that next to it.

struct Quantity {
  std::string name;
  double exception = 0.0;
};

/// Contents of the file in front of the values.
struct SwanHeader {
  bool has_times = false, relative = false, cartesian = false;
  std::size_t locations = 0;
  std::vector<double> frequencies;  ///< [Hz]
  std::vector<double> directions;   ///< As written [deg]; empty in a file of one axis.
  std::vector<Quantity> quantities;

  /// Returns the column of a quantity; the number of columns if it has none.
  std::size_t column(std::initializer_list<std::string_view> names) const {
    const auto found = std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& quantity) {
      return std::find(names.begin(), names.end(), quantity.name) != names.end();
    });
    return static_cast<std::size_t>(found - quantities.begin());
  }
};

/// Position of the values of the wanted location at one time.
struct Block {
  FileTime time{};
  std::size_t row = 0;
};

/// An error that has been reported.
struct Rejected {};

class SwanReader {
 public:
  SwanReader(const WaveFileRequest& request, Diagnostics& diagnostics)
      : request_(request), diagnostics_(diagnostics), rows_(split_table(request.text, ' ').rows) {
    std::erase_if(rows_, [](const TextRow& row) { return row.cells.front().starts_with('$'); });
  }

  std::optional<WaveFileContent> read() {
    try {
      read_header();
      find_blocks();
      const std::size_t chosen = choose_block();
      next_ = blocks_[chosen].row;
      if (header_.directions.empty()) {
        take_frequencies();
      } else {
        take_sectors();
      }
      finish(blocks_[chosen].time);
    } catch (const Rejected&) {
      return std::nullopt;
    }
    return std::move(content_);
  }

 private:
  [[noreturn]] void reject(int line, std::string found, std::string expected, std::string hint = {},
                           std::string key = {}) {
    diagnostics_.add({Severity::error, request_.path(), line, 0, std::move(key), std::move(found), std::move(expected),
                      std::move(hint)});
    throw Rejected();
  }

  int last_line() const { return rows_.empty() ? 1 : rows_.back().line; }

  const TextRow& take(const std::string& expected) {
    if (next_ >= rows_.size()) reject(last_line(), "the end of the file", expected);
    return rows_[next_++];
  }

  double number(const TextRow& row, std::size_t i, const std::string& expected) {
    const std::optional<double> value = i < row.cells.size() ? cell_number(row.cells[i]) : std::nullopt;
    if (!value) {
      reject(row.line, i < row.cells.size() ? "'" + for_display(row.cells[i]) + "'" : "the end of the line", expected);
    }
    return *value;
  }

  std::size_t count(const std::string& what) {
    const TextRow& row = take(what);
    const double value = number(row, 0, what);
    const std::size_t left = rows_.size() - next_;
    if (value != std::floor(value) || value < 1.0 || value > static_cast<double>(left)) {
      reject(row.line, for_display(row.cells[0]) + " with " + std::to_string(left) + " lines left", what);
    }
    return static_cast<std::size_t>(value);
  }

  std::vector<double> axis(const std::string& what) {
    const std::size_t size = count("the number of " + what);
    std::vector<double> values;
    for (std::size_t i = 0; i < size; ++i) {
      values.push_back(number(take("one of the " + what), 0, "one of the " + what));
    }
    return values;
  }

  void read_header() {
    take("SWAN");
    while (header_.quantities.empty()) {
      const TextRow& row = take("AFREQ, NDIR or QUANT");
      const std::string_view word = row.cells.front();
      if (word == "TIME") {
        read_time_coding();
      } else if (word == "LOCATIONS" || word == "LONLAT") {
        header_.locations = count("the number of locations");
        for (std::size_t i = 0; i < header_.locations; ++i) take("a location");
      } else if (word == "AFREQ" || word == "RFREQ") {
        header_.relative = word == "RFREQ";
        read_frequencies();
      } else if (word == "NDIR" || word == "CDIR") {
        header_.cartesian = word == "CDIR";
        header_.directions = axis("directions");
      } else if (word == "QUANT") {
        read_quantities();
      } else {
        reject(row.line, "'" + for_display(word) + "'", "TIME, LOCATIONS, LONLAT, AFREQ, RFREQ, NDIR, CDIR or QUANT");
      }
    }
    if (header_.locations == 0) reject(last_line(), "no locations", "LOCATIONS or LONLAT");
    if (header_.frequencies.size() < 2) reject(last_line(), "no frequencies", "AFREQ or RFREQ with at least 2");
    check_quantities();
  }

  void read_time_coding() {
    const TextRow& row = take("the time coding option");
    if (number(row, 0, "the time coding option") != 1.0) {
      reject(row.line, "time coding option " + for_display(row.cells[0]), "1, times such as 20260601.094000",
             "write the spectra with that option");
    }
    header_.has_times = true;
  }

  void read_frequencies() {
    const int line = rows_[next_ - 1].line;
    header_.frequencies = axis("frequencies");
    for (std::size_t i = 0; i < header_.frequencies.size(); ++i) {
      const double f = header_.frequencies[i], before = i == 0 ? 0.0 : header_.frequencies[i - 1];
      if (f > before) continue;
      reject(line + 2 + static_cast<int>(i),
             "a frequency of " + format_number(f) + " Hz after " + format_number(before), "increasing frequencies");
    }
  }

  void read_quantities() {
    const std::size_t size = count("the number of quantities");
    for (std::size_t i = 0; i < size; ++i) {
      const TextRow& name = take("the name of a quantity");
      const TextRow& unit = take("its unit");
      if (i == 0) density_line_ = name.line;
      header_.quantities.push_back(
          {std::string(name.cells.front()), number(take("its exception value"), 0, "its exception value")});
      if (unit.cells.front().starts_with("J")) {
        reject(name.line, for_display(name.cells.front()) + " in " + for_display(unit.cells.front()),
               "variance density, VaDens in m2/Hz", "energy densities contain a water density that is not in the file");
      }
    }
  }

  void check_quantities() {
    const std::size_t columns = header_.quantities.size();
    if (header_.column({"VaDens"}) == columns) {
      reject(density_line_, "no VaDens among the quantities", "variance density, VaDens in m2/Hz");
    }
    if (!header_.directions.empty() && columns != 1) {
      reject(density_line_, std::to_string(columns) + " quantities over direction", "1, the variance density");
    }
  }

  /// Returns the number of values per line, and lines per location.
  std::size_t width() const {
    return header_.directions.empty() ? header_.quantities.size() : header_.directions.size();
  }

  std::size_t chosen_location() {
    const int wanted = request_.location.value_or(1);
    if (!request_.location && header_.locations > 1) {
      reject(0, std::to_string(header_.locations) + " locations and no choice", "one of them",
             "for example location: 1", request_.location_key);
    }
    if (static_cast<std::size_t>(wanted) > header_.locations) {
      reject(0, "location " + std::to_string(wanted), "1 to " + std::to_string(header_.locations), "",
             request_.location_key);
    }
    return static_cast<std::size_t>(wanted) - 1;
  }

  /// Finds the values of the wanted location at all times.
  void find_blocks() {
    const std::size_t location = chosen_location();
    while (next_ < rows_.size()) {
      Block block;
      if (header_.has_times) {
        const TextRow& row = take("a time");
        const std::optional<FileTime> time = parse_file_time(row.cells.front());
        if (!time) reject(row.line, "'" + for_display(row.cells.front()) + "'", "a time such as 20260601.094000");
        block.time = *time;
      } else if (!blocks_.empty()) {
        return;
      }
      for (std::size_t i = 0; i < header_.locations; ++i) {
        if (i == location) block.row = next_;
        skip_location();
      }
      blocks_.push_back(block);
    }
    if (blocks_.empty()) reject(last_line(), "the end of the file", "values of a location");
  }

  void skip_location() {
    const TextRow& row = take("LOCATION, FACTOR, ZERO or NODATA");
    const std::string_view word = row.cells.front();
    if (word == "NODATA" || word == "ZERO") return;
    if (word != (header_.directions.empty() ? "LOCATION" : "FACTOR")) {
      reject(row.line, "'" + for_display(word) + "'",
             header_.directions.empty() ? "LOCATION or NODATA" : "FACTOR, ZERO or NODATA");
    }
    if (!header_.directions.empty()) take("the factor");
    for (std::size_t i = 0; i < header_.frequencies.size(); ++i) {
      const std::string what = header_.directions.empty() ? "one per quantity" : "one per direction";
      const TextRow& values = take(std::to_string(width()) + " values, " + what);
      if (values.cells.size() == width()) continue;
      reject(values.line, std::to_string(values.cells.size()) + " values", std::to_string(width()) + ", " + what);
    }
  }

  std::size_t choose_block() {
    if (!header_.has_times) {
      if (request_.time.wanted.empty()) return 0;
      reject(0, "no times in the file", "no choice of one", "leave out time", request_.time.key);
    }
    std::vector<FileTime> times;
    for (const Block& block : blocks_) times.push_back(block.time);
    const std::optional<std::size_t> chosen = choose_time(times, request_.time, diagnostics_);
    if (!chosen) throw Rejected();
    return *chosen;
  }

  /// Goes past the line in front of the values.
  void expect_values() {
    const TextRow& row = take("values");
    if (row.cells.front() == "NODATA" || row.cells.front() == "ZERO") {
      reject(row.line, for_display(row.cells.front()), "a location with waves", "choose another location or time");
    }
  }

  void add_point(int line, std::size_t i, double density) {
    if (density < 0.0) {
      reject(line, format_number(density) + " at " + format_number(header_.frequencies[i]) + " Hz", "a density",
             "exception values are missing values");
    }
    content_.spectrum.push_back({kTurn * header_.frequencies[i], density / kTurn});
  }

  /// Returns the azimuth from which waves come [deg].
  static double from_azimuth(double direction, bool cartesian) { return cartesian ? 270.0 - direction : direction; }

  void take_frequencies() {
    expect_values();
    const std::size_t columns = header_.quantities.size(), density = header_.column({"VaDens"});
    const std::size_t direction = header_.column({"NDIR", "CDIR"}), spread = header_.column({"DSPRDEGR", "DSPR"});
    header_.cartesian = direction < columns && header_.quantities[direction].name == "CDIR";
    std::vector<int> lines;
    for (std::size_t i = 0; i < header_.frequencies.size(); ++i) {
      const TextRow& row = take("values");
      const double value = number(row, density, "a density");
      const bool absent = value == header_.quantities[density].exception;
      if (absent) reject(row.line, "the exception value " + format_number(value), "a density");
      add_point(row.line, i, value);
      lines.push_back(row.line);
      if (direction < columns) add_direction(row, direction);
      if (spread < columns) add_spread(row, spread);
    }
    fill_exceptions(content_.directions.from, lines, "direction");
    fill_exceptions(content_.directions.spreading, lines, "spreading");
  }

  void add_direction(const TextRow& row, std::size_t column) {
    const double value = number(row, column, "a direction");
    const bool absent = value == header_.quantities[column].exception;
    if (!absent && std::abs(value) > 720.0) reject(row.line, format_number(value), "a direction in degrees");
    content_.directions.from.push_back(absent ? std::nan("") : from_azimuth(value, header_.cartesian) * kDegree);
  }

  void add_spread(const TextRow& row, std::size_t column) {
    constexpr double kLongCrested = 1e-3;  // [rad]
    const double value = number(row, column, "a directional spreading");
    const bool absent = value == header_.quantities[column].exception;
    if (!absent && (value < 0.0 || value > 180.0)) {
      reject(row.line, format_number(value), "a directional spreading of 0 to 180 deg");
    }
    const double sigma = std::max(value * kDegree, kLongCrested);
    content_.directions.spreading.push_back(absent ? std::nan("") : std::max(0.0, 2.0 / (sigma * sigma) - 1.0));
  }

  /// Replaces exception values where there is next to no energy by the nearest known value.
  void fill_exceptions(std::vector<double>& values, const std::vector<int>& lines, const char* what) {
    double max_density = 0.0;
    for (const SpectrumPoint& point : content_.spectrum) max_density = std::max(max_density, point.density);
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isnan(values[i])) {
        known.push_back(i);
      } else if (content_.spectrum[i].density > kNegligible * max_density) {
        reject(lines[i], std::string("no ") + what + " where the density is large", std::string("a ") + what);
      }
    }
    for (std::size_t i = 0; i < values.size() && !known.empty(); ++i) {
      if (!std::isnan(values[i])) continue;
      const auto distance = [i](std::size_t k) { return k > i ? k - i : i - k; };
      values[i] = values[*std::min_element(known.begin(), known.end(),
                                           [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); })];
    }
    if (known.empty()) values.clear();
  }

  /// Sets the middles of the sectors in order of their azimuth; returns their positions in the file.
  std::vector<std::size_t> set_sectors() {
    constexpr double kRounding = 0.15;  // [deg], of directions with one decimal
    const std::vector<double>& written = header_.directions;
    const std::size_t size = written.size();
    if (size < 2) reject(density_line_, std::to_string(size) + " directions", "at least 2");
    const double step = std::remainder(written[1] - written[0], 360.0);
    for (std::size_t i = 1; i < size; ++i) {
      const double next = std::remainder(written[i] - written[i - 1], 360.0);
      if (step != 0.0 && std::abs(next - step) <= kRounding) continue;
      reject(density_line_, "directions " + format_number(written[i - 1]) + " and " + format_number(written[i]),
             "directions in even steps of " + format_number(step) + " deg");
    }
    if (std::abs(step) * static_cast<double>(size) > 360.0 + kRounding * static_cast<double>(size)) {
      reject(density_line_, std::to_string(size) + " directions of " + format_number(std::abs(step)) + " deg",
             "a circle of 360 deg at most");
    }
    const double turn = header_.cartesian ? -step : step, first = from_azimuth(written[0], header_.cartesian);
    std::vector<std::size_t> order(size);
    for (std::size_t i = 0; i < size; ++i) {
      order[i] = turn > 0.0 ? i : size - 1 - i;
      content_.directions.sectors.push_back((first + turn * static_cast<double>(order[i])) * kDegree);
    }
    return order;
  }

  void take_sectors() {
    expect_values();
    const TextRow& factor_row = take("the factor");
    const double factor = number(factor_row, 0, "the factor");
    if (!(factor > 0.0)) reject(factor_row.line, for_display(factor_row.cells[0]), "a factor above 0");
    const std::vector<std::size_t> order = set_sectors();
    const double width = std::abs(std::remainder(header_.directions[1] - header_.directions[0], 360.0));
    for (std::size_t i = 0; i < header_.frequencies.size(); ++i) {
      const TextRow& row = take("values");
      double sum = 0.0;
      for (const std::size_t column : order) {
        const double value = factor * number(row, column, "a density");
        if (value < 0.0) {
          reject(row.line, "'" + for_display(row.cells[column]) + "'", "0 or more",
                 "exception values are missing values");
        }
        content_.directions.density.push_back(value);
        sum += value;
      }
      add_point(row.line, i, sum * width);
    }
  }

  void finish(const FileTime& time) {
    if (!check_file_spectrum(content_.spectrum, request_.path(), diagnostics_)) throw Rejected();
    content_.from = mean_azimuth(content_.spectrum, content_.directions);
    std::string text = fmt::format(
        "The spectrum is that of {}{}{}: densities in m^2/Hz over {} frequencies up to {:.4g} Hz, linear between them "
        "and "
        "zero outside, no tail is added",
        std::filesystem::path(request_.path()).filename().string(),
        header_.locations > 1 ? fmt::format(", location {}", request_.location.value_or(1)) : "",
        header_.has_times ? " at " + file_time_label(time) : "", header_.frequencies.size(),
        header_.frequencies.back());
    if (!content_.directions.empty()) {
      text += header_.cartesian ? "; Cartesian directions, towards which the waves travel, anticlockwise from x as east"
                                : "; nautical directions, from which the waves come";
    }
    if (!content_.directions.spreading.empty()) {
      text += "; spreading s = 2/sigma^2 - 1 of cos^2s of half the angle";
    }
    content_.assumptions.push_back({AssumptionRank::setting, text + "."});
    if (header_.relative) {
      content_.assumptions.push_back(
          {AssumptionRank::governing,
           "The frequencies of the spectrum are relative to the current (RFREQ) and are used "
           "as those of a fixed point, as they are without current."});
    }
  }

  const WaveFileRequest& request_;
  Diagnostics& diagnostics_;
  std::vector<TextRow> rows_;
  std::size_t next_ = 0;
  int density_line_ = 0;
  SwanHeader header_;
  std::vector<Block> blocks_;
  WaveFileContent content_;
};

}  // namespace

bool is_swan(std::string_view text) {
  return trim(text.substr(0, text.find('\n'))).starts_with("SWAN ");
}

std::optional<WaveFileContent> read_swan_spectrum(const WaveFileRequest& request, Diagnostics& diagnostics) {
  return SwanReader(request, diagnostics).read();
}

}  // namespace overbend
