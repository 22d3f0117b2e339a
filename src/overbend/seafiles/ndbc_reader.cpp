#include "seafiles/ndbc_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/constants.h"
#include "base/text.h"
#include "base/units.h"
#include "seafiles/ndbc_table.h"
#include "seafiles/text_table.h"

namespace overbend {
namespace {

constexpr double kNegligible =
    0.01;  ///< Fraction of the maximum density below which a missing direction is that next to it.

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

/// Files of the directions and their spread next to one of densities.
struct Companions {
  std::string direction, spread;
};

/// Returns a path with another letter before the year of a yearly file, "46042w2019.txt"; empty for other names.
std::string with_letter(const std::filesystem::path& path, char letter) {
  constexpr std::size_t kYear = 4;
  std::string stem = path.stem().string();
  if (stem.size() <= kYear || stem[stem.size() - kYear - 1] != 'w') return "";
  stem[stem.size() - kYear - 1] = letter;
  return (path.parent_path() / (stem + path.extension().string())).string();
}

Companions companions(const std::string& path) {
  std::filesystem::path base(path);
  if (base.extension() == ".data_spec") {
    return {base.replace_extension(".swdir").string(), base.replace_extension(".swr1").string()};
  }
  return {with_letter(base, 'd'), with_letter(base, 'j')};
}

bool exists(const std::string& path) {
  std::error_code error;
  return !path.empty() && std::filesystem::is_regular_file(path, error);
}

class NdbcReader {
 public:
  NdbcReader(const WaveFileRequest& request, Diagnostics& diagnostics) : request_(request), diagnostics_(diagnostics) {}

  std::optional<WaveFileContent> read() {
    std::optional<NdbcTable> table = split_ndbc(request_.text, request_.path(), diagnostics_);
    if (!table) return std::nullopt;
    const std::optional<std::size_t> row = choose_time(table->times, request_.time, diagnostics_);
    if (!row) return std::nullopt;
    time_ = table->times[*row];
    const bool good =
        table->kind == NdbcTable::Kind::sea_states ? take_state(*table, *row) : take_spectrum(*table, *row);
    if (!good) return std::nullopt;
    return std::move(content_);
  }

 private:
  bool reject(const std::string& path, int line, std::string key, std::string found, std::string expected,
              std::string hint = {}) {
    diagnostics_.add(
        {Severity::error, path, line, 0, std::move(key), std::move(found), std::move(expected), std::move(hint)});
    return false;
  }

  bool take_state(const NdbcTable& table, std::size_t row) {
    const TextRow& cells = table.rows[row];
    const std::optional<double> hs = table.value(row, "WVHT"), tp = table.value(row, "DPD");
    const std::string when = "at " + file_time_label(time_);
    for (const char* column : {"WVHT", "DPD"}) {
      const std::optional<double> value = table.value(row, column);
      if (value && *value > 0.0) continue;
      return reject(request_.path(), cells.line, column,
                    (table.has(column) ? for_display(table.cell(row, column)) : "no such column") + " " + when +
                        ": no waves in this row",
                    "a row with WVHT and DPD", "choose another time");
    }
    content_.state = FileSeaState{cells.line, *hs, *tp, table.value(row, "APD")};
    if (const std::optional<double> from = table.value(row, "MWD")) content_.from = *from * kDegree;
    content_.assumptions.push_back(
        {AssumptionRank::setting,
         fmt::format("Height and period are those of {} {}: WVHT {:.4g} m, DPD {:.4g} s as Tp{}{}.",
                     file_name(request_.path()), when, *hs, *tp,
                     content_.state->tz ? fmt::format(", APD {:.4g} s is not used", *content_.state->tz) : "",
                     content_.from ? fmt::format(", MWD {:.4g} deg", *content_.from / kDegree) : ", no MWD")});
    return true;
  }

  bool take_spectrum(const NdbcTable& table, std::size_t row) {
    const std::optional<NdbcSpectrumRow> densities =
        table.spectrum_row(row, NdbcMissing::two_or_three_nines, request_.path(), diagnostics_);
    if (!densities) return false;
    for (std::size_t i = 0; i < densities->values.size(); ++i) {
      const double density = densities->values[i];
      if (!(density >= 0.0)) {
        return reject(request_.path(), densities->line, frequency_label(densities->frequencies[i]),
                      std::isnan(density) ? "a missing value at " + file_time_label(time_) : format_number(density),
                      "a spectral density in m^2/Hz", "choose another time");
      }
      content_.spectrum.push_back({kTurn * densities->frequencies[i], density / kTurn});
    }
    if (!check_file_spectrum(content_.spectrum, request_.path(), diagnostics_)) return false;
    std::string directions = "no directions";
    if (!take_directions(*densities, directions)) return false;
    content_.from = mean_azimuth(content_.spectrum, content_.directions);
    content_.assumptions.push_back(
        {AssumptionRank::setting,
         fmt::format(
             "The spectrum is that of {} at {}: densities in m^2/Hz over {} frequencies up to {:.4g} Hz, linear "
             "between them and zero outside; {}.",
             file_name(request_.path()), file_time_label(time_), densities->values.size(),
             densities->frequencies.back(), directions)});
    return true;
  }

  static std::string frequency_label(double frequency) { return format_number(frequency) + " Hz"; }

  /// Reads the row of the same time of a file next to that of the densities, with the same frequencies.
  std::optional<NdbcSpectrumRow> companion_row(const std::string& path, const NdbcSpectrumRow& densities) {
    const std::optional<std::string> text = read_text_file(path, diagnostics_);
    if (!text) return std::nullopt;
    const std::optional<NdbcTable> table = split_ndbc(*text, path, diagnostics_);
    if (!table) return std::nullopt;
    const TimeChoice same{path, request_.time.key, file_time_label(time_)};
    const std::optional<std::size_t> row = choose_time(table->times, same, diagnostics_);
    if (!row || table->kind == NdbcTable::Kind::sea_states) return std::nullopt;
    std::optional<NdbcSpectrumRow> values = table->spectrum_row(*row, NdbcMissing::three_nines, path, diagnostics_);
    if (values && values->frequencies != densities.frequencies) {
      reject(
          path, values->line, "",
          std::to_string(values->frequencies.size()) + " frequencies other than those of " + file_name(request_.path()),
          "the same frequencies");
      return std::nullopt;
    }
    return values;
  }

  /// Replaces missing values where there is next to no energy by the nearest known one.
  bool fill_missing(NdbcSpectrumRow& row, const NdbcSpectrumRow& densities, const std::string& path) {
    const double limit = kNegligible * *std::max_element(densities.values.begin(), densities.values.end());
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      if (!std::isnan(row.values[i])) known.push_back(i);
      if (!std::isnan(row.values[i]) || densities.values[i] <= limit) continue;
      return reject(path, row.line, frequency_label(row.frequencies[i]),
                    "a missing value where the density is " + format_number(densities.values[i]) + " m^2/Hz", "a value",
                    "choose another time, or move the file away to use `from`");
    }
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      if (!std::isnan(row.values[i])) continue;
      const auto distance = [i](std::size_t k) { return k > i ? k - i : i - k; };
      row.values[i] = row.values[*std::min_element(
          known.begin(), known.end(), [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); })];
    }
    return true;
  }

  bool take_directions(const NdbcSpectrumRow& densities, std::string& label) {
    const Companions files = companions(request_.path());
    if (!exists(files.direction)) return true;
    std::optional<NdbcSpectrumRow> from = companion_row(files.direction, densities);
    if (!from || !fill_missing(*from, densities, files.direction)) return false;
    for (const double azimuth : from->values) {
      if (azimuth < 0.0 || azimuth > 360.0) {
        return reject(files.direction, from->line, "", format_number(azimuth), "a direction of 0 to 360 deg");
      }
      content_.directions.from.push_back(azimuth * kDegree);
    }
    label = "directions from which they come by " + file_name(files.direction);
    if (!exists(files.spread)) return true;
    std::optional<NdbcSpectrumRow> r1 = companion_row(files.spread, densities);
    if (!r1 || !fill_missing(*r1, densities, files.spread)) return false;
    if (!take_spreading(*r1, files.spread)) return false;
    label += ", spreading by r1 of " + file_name(files.spread) +
             ": s = r1/(1 - r1) of cos^2s of half the angle; second moments are not used";
    return true;
  }

  bool take_spreading(const NdbcSpectrumRow& r1, const std::string& path) {
    constexpr double kNarrowest = 0.999;  // s of 999, in effect long-crested
    // Yearly files have hundredths.
    const double unit = *std::max_element(r1.values.begin(), r1.values.end()) > 1.0 ? 0.01 : 1.0;
    for (const double written : r1.values) {
      const double moment = unit * written;
      if (moment < 0.0 || moment > 1.0) {
        return reject(path, r1.line, "", format_number(written), "a moment r1 of 0 to 1, or 0 to 100");
      }
      const double limited = std::min(moment, kNarrowest);
      content_.directions.spreading.push_back(limited / (1.0 - limited));
    }
    return true;
  }

  const WaveFileRequest& request_;
  Diagnostics& diagnostics_;
  FileTime time_{};
  WaveFileContent content_;
};

}  // namespace

bool is_ndbc(std::string_view text) {
  return is_ndbc_header(text.substr(0, text.find('\n')));
}

std::optional<WaveFileContent> read_ndbc(const WaveFileRequest& request, Diagnostics& diagnostics) {
  return NdbcReader(request, diagnostics).read();
}

}  // namespace overbend
